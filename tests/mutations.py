"""Break the app in one place at a time, and check that a test fails: `python -m tests.mutations [words]`.

Each mutation is applied to a copy of the sources, in which its tests are run. Without a mutation these tests must pass.
With words, only the mutations whose names contain one of them are run. This takes minutes and is not part of the test
suite.
"""

import shutil
import subprocess
import sys
import tempfile
from dataclasses import dataclass
from pathlib import Path

from tests.checks.browser import ROOT

_COPIED = ("app.py", "ramanujan", "tests", ".streamlit", ".pytest.ini")
DRAWN = "all_that_is_drawn"
"""The test that compares every body and both hands with the core."""
LAYERS = "marks_of_every_layer"
"""The test that compares the marks of all layers with the core."""


@dataclass(frozen=True)
class Mutation:
    """A text in a file, its replacement, and the tests that must fail, as an expression for pytest's -k."""

    name: str
    file: str
    old: str
    new: str
    tests: str = DRAWN


_SPIN = "(FORMULAS.angle[name](values) * 360) / TURN"
_ARROW_LENGTH = "const length = velocity(name, known)"
MUTATIONS = [
    Mutation("every roller turns backwards", "stage/drawing.js", _SPIN, _SPIN.replace("(FORM", "(-FORM")),
    Mutation(
        "the block stays where it is",
        "stage/drawing.js",
        "translate(${x0 + x[name]} ",
        'translate(${name === "block" ? 0 : x0 + x[name]} ',
    ),
    Mutation(
        "hoop and cylinder change places",
        "stage/drawing.js",
        "{ hoop: [hoop, deck + R], cylinder: [cylinder, deck + R]",
        "{ hoop: [cylinder, deck + R], cylinder: [hoop, deck + R]",
    ),
    Mutation(
        "the hoop is drawn as a disc",
        "stage/drawing.js",
        "if (beta > 0.8)",
        "if (beta > 1.8)",
        "painted",
    ),
    Mutation(
        "the spring ends at the slab's left",
        "stage/drawing.js",
        "[from, to] = [place.slab.right + x.slab",
        "[from, to] = [place.slab.left + x.slab",
    ),
    Mutation(
        "the slab goes half as far",
        "stage/formulas.py",
        '"displacement": {body.name: body.displacement for',
        '"displacement": {body.name: body.displacement / (1 + (body.name == "slab")) for',
    ),
    Mutation(
        "the rollers' spin has no energy",
        "stage/formulas.py",
        '"kinetic_energy": {body.name: body.kinetic_energy for',
        '"kinetic_energy": {body.name: body.mass * body.velocity**2 / 2 for',
        LAYERS,
    ),
    Mutation(
        "bars against their own largest",
        "stage/layers.js",
        "energies.reduce((sum, energy) => sum + energy, 0)",
        "Math.max(...energies)",
        LAYERS,
    ),
    Mutation(
        "velocities point the wrong way",
        "stage/layers.js",
        _ARROW_LENGTH,
        _ARROW_LENGTH.replace("velocity", "-velocity"),
        LAYERS,
    ),
    Mutation(
        "forces point the wrong way",
        "stage/layers.js",
        "length = newtons * unitLengths.force",
        "length = -newtons * unitLengths.force",
        LAYERS,
    ),
    Mutation("the bodies stay together", "stage/picture.js", "-bottom - SUNKEN_FLOOR", "0", LAYERS),
    Mutation(
        "the reference arrow is too long",
        "stage/layers.js",
        "drawn(value * unitLengths[name])",
        "drawn(1.3 * value * unitLengths[name])",
        LAYERS,
    ),
    Mutation("the plain mass's hand is frozen", "stage/dial.js", "rotate(${degrees(other)})", "rotate(0)"),
    Mutation(
        "the arrow of the drift points the other way",
        "stage/dial.js",
        "turns < 0 ? -1 : 1",
        "turns < 0 ? 1 : -1",
        "in_step",
    ),
    Mutation(
        "a change of the machine moves a hand",
        "stage/playback.js",
        "Object.assign(this, machine);",
        "Object.assign(this, machine, { plainPhase: this.phase });",
        "goes_on",
    ),
    Mutation(
        "in step when it is not",
        "stage/dial.js",
        "const IN_STEP = VISIBLE / 1e6;",
        "const IN_STEP = VISIBLE;",
        "in_step",
    ),
    Mutation(
        "two bodies' colours are swapped",
        "stage/stage.css",
        "--hoop: var(--st-orange-color); --cylinder: var(--st-blue-color)",
        "--hoop: var(--st-blue-color); --cylinder: var(--st-orange-color)",
        "painted",
    ),
    Mutation(
        "the traces run the other way",
        "stage/drawing.js",
        "place.R * Math.sin(angle)} ${-(y",
        "-place.R * Math.sin(angle)} ${-(y",
        LAYERS,
    ),
    Mutation("a layer is dead", "stage/layers.js", 'if (shown.has("forces") || data.forces)', "if (false)", LAYERS),
    Mutation(
        "the speed menu is dead",
        "stage/toolbar.js",
        "speed: Number(value)",
        "",
        "speed_menu",
    ),
    Mutation(
        "the slider of x₀ counts wrong",
        "../shell/parameters.py",
        '"scale": PARAMETERS[name].scale, "step"',
        '"scale": PARAMETERS[name].scale * 1.1, "step"',
        "thumb",
    ),
    Mutation(
        "the view jumps after a threshold",
        "stage/playback.js",
        ": this.solution.drift * time",
        ": Math.abs(this.solution.drift) > 1e-12 ? this.solution.drift * time + 0.03 : 0",
        "smallest_push",
    ),
    Mutation(
        "the view stays behind",
        "stage/playback.js",
        ": this.solution.drift * time",
        ": 0",
        "pushed_machine",
    ),
    Mutation("X counts to the right", "stage/coordinates.js", "length = -7.5", "length = 7.5", LAYERS),
    Mutation(
        "the picture's height follows the radius",
        "stage/picture.js",
        "set(svg, { viewBox: `",
        "svg.style.aspectRatio = 1 + place.R / 10, set(svg, { viewBox: `",
        "nothing_below",
    ),
    Mutation(
        "old ghosts stay",
        "stage/picture.js",
        "replaceChildren(...states",
        "append(...states",
        "less_motion",
    ),
    Mutation(
        "the wrong body is lit",
        "stage/terms.js",
        "touching.includes(name)",
        'touching.includes("hoop")',
        "body_has_its_ink",
    ),
    Mutation(
        "a class counts as present who left three minutes ago",
        "../classroom/rules.py",
        "PRESENCE_DURATION = 20.0",
        "PRESENCE_DURATION = 200.0",
        "recent_request",
    ),
    Mutation(
        "what is typed before a preset is taken after it",
        "../shell/sidebar.py",
        "request.func is not set_number",
        "request.func is set_number",
        "every_slider_preset_and_typed_value",
    ),
    Mutation(
        "a formula may have a larger exponent",
        "../answers/grammar.py",
        "= 320, 20, 12, 120",
        "= 320, 20, 13, 120",
        "limits_are_exact",
    ),
    *(
        Mutation(
            f"after an old message {wins}",
            "../shell/pending_updates.py",
            "update if current in update.old_values else update._replace(value=current)",
            taken,
            "old_message_does_not_undo",
        )
        for wins, taken in (
            ("the preset always wins", "update"),
            ("the message always wins", "update._replace(value=current)"),
        )
    ),
    Mutation(
        "the spring's old colour",
        "../../.streamlit/config.toml",
        'violetColor = "#B17DB5"',
        'violetColor = "#B565A7"',
        "colour_blind",
    ),
]


def outcome(folder: Path, tests: str) -> str:
    """Run tests in a folder with the sources. Return "passed", "failed" or pytest's error message."""
    command = [sys.executable, "-m", "pytest", "-q", "-x", "-n", "0", "-p", "no:cacheprovider"]
    command += ["-k", f"({tests}) and not firefox and not webkit", "tests"]
    done = subprocess.run(command, cwd=folder, capture_output=True, text=True, check=False)
    return {0: "passed", 1: "failed"}.get(done.returncode, f"pytest ended with {done.returncode}: {done.stdout[-500:]}")


def outcome_with(mutation: Mutation, folder: Path) -> str:
    """Copy the sources to a folder, apply a mutation, and return the outcome of its tests."""
    for name in _COPIED:
        source = ROOT / name
        if source.is_dir():
            shutil.copytree(source, folder / name, ignore=shutil.ignore_patterns("__pycache__", ".*_cache"))
        else:
            shutil.copy(source, folder / name)
    file = folder / "ramanujan/browser" / mutation.file
    text = file.read_text(encoding="utf-8")
    if text.count(mutation.old) != 1:
        return f"no mutation: its text occurs {text.count(mutation.old)} times in {mutation.file}"
    file.write_text(text.replace(mutation.old, mutation.new), encoding="utf-8")
    return outcome(folder, mutation.tests)


def main(words: list[str]) -> int:
    """Print the outcome of every mutation. Return the number of mutations that no test noticed."""
    chosen = list(MUTATIONS)
    if words:
        chosen = [mutation for mutation in MUTATIONS if any(word in mutation.name for word in words)]
    without_mutation = outcome(ROOT, " or ".join({mutation.tests for mutation in chosen}))
    if without_mutation != "passed":
        print(f"Without a mutation: {without_mutation}")
        return 1
    survivors = 0
    for mutation in chosen:
        with tempfile.TemporaryDirectory() as folder:
            result = outcome_with(mutation, Path(folder))
        survivors += result != "failed"
        verdict = {"failed": "noticed", "passed": "SURVIVED"}.get(result, result)
        print(f"{verdict}: {mutation.name}", flush=True)
    print(f"{survivors} of {len(chosen)} were not noticed.")
    return survivors


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))

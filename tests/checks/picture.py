"""Measurements of the drawn picture: positions in pixels, angles in degrees clockwise, painted colours.

This file uses neither the page's formulas nor its layout. The scale comes from the drawn radius of a roller, and the
zero from the drawn ruler. Arrows are measured by the scale arrows in the picture.
"""

import io
import math
from itertools import product

import numpy as np
from PIL import Image

from ramanujan import Oscillator
from ramanujan.browser import stage
from ramanujan.physics.motion import InitialState, motion, released
from ramanujan.shell.parameters import PARAMETERS
from tests.checks.bare import Bare
from tests.checks.browser import STAGE, inside, next_frame, script

ROLLERS = ("hoop", "cylinder", "top")
STEPS = 24
"""Number of steps of the step button in a period."""

_READ = script("picture")

_SEEK = f"""([periods, part]) => {{
  const root = {STAGE}, press = (name) => root.querySelector(`[data-do=${{name}}]`).click();
  press("restart");
  for (let i = 0; i < Math.abs(periods) * {STEPS}; i++) press(periods > 0 ? "forward" : "back");
  const scrub = root.querySelector(".scrub input");
  scrub.value = part;
  scrub.dispatchEvent(new Event("input", {{ bubbles: true }}));
}}"""


class Picture:
    """A stage on a bare page, with a machine and a time set by the test."""

    def __init__(self, bare: Bare, name: str = "oscillator", **options: object) -> None:
        self.bare, self.page, self.name = bare, bare.page, name
        bare.stage(name=name, **options)

    def show(self, machine: Oscillator, compression: float, initial: InitialState | None = None) -> None:
        """Show a machine."""
        self.machine, self.compression, self.initial = machine, compression, initial or released(machine, compression)
        data = stage.payload(machine, compression, initial=initial)
        self.bare.put(lambda: stage.publish(data, name=self.name))
        next_frame(self.page)

    def find(self, expression: str) -> object:
        """Evaluate a JavaScript expression in which `root` is the stage's shadow tree."""
        return inside(self.page, expression)

    def at(self, periods: float) -> dict:
        """Go to a time, in periods after release, by the buttons and the scrubber. Return the measurements.

        The attributes `time`, `q` and `q_dot` are then the core's state at that time.
        """
        whole = math.floor(periods)
        self.page.evaluate(_SEEK, [whole, periods - whole])
        next_frame(self.page)
        drawn = self.page.evaluate(_READ)
        self.time = periods * self.machine.period
        self.q, self.q_dot = motion(self.machine, self.initial, self.time)
        self.pixels = drawn["rollers"]["hoop"]["radius"] / self.machine.radius
        value, x = drawn["ruler"][0]
        self.zero = x - value / 100 * self.pixels
        return drawn

    def layers(self, *names: str) -> None:
        """Show only these layers."""
        boxes = "[...root.querySelectorAll('[data-layer]')]"
        wrong = f"{boxes}.filter((box) => {list(names)}.includes(box.dataset.layer) !== box.firstChild.checked)"
        self.find(f"{wrong}.forEach((box) => box.firstChild.click())")
        next_frame(self.page)

    def painted(self) -> np.ndarray:
        """The colours on the screen: red, green and blue from 0 to 255, by row and column."""
        return np.asarray(Image.open(io.BytesIO(self.page.screenshot())).convert("RGB"), dtype=float)


def middle(box: list[float]) -> float:
    """The horizontal centre of a box, the list of its left, upper, right and lower edge."""
    left, _upper, right, _lower = box
    return (left + right) / 2


def places(drawn: dict) -> dict[str, float]:
    """The horizontal position of each body's centre, in pixels."""
    rollers = {name: drawn["rollers"][name]["centre"][0] for name in ROLLERS}
    return {"block": middle(drawn["block"]), "slab": middle(drawn["slab"]), **rollers}


def length(arrow: dict[str, list[float]] | None) -> float:
    """The length of an arrow in pixels, positive to the right. An arrow has a `box` and a `tail`."""
    if arrow is None:
        return 0.0
    left, _upper, right, _lower = arrow["box"]
    tail, _y = arrow["tail"]
    return right - left if abs(tail - left) < abs(tail - right) else left - right


def difference(a: float, b: float) -> float:
    """The angle between two directions, in degrees."""
    return abs((a - b + 180) % 360 - 180)


def add_reactions(on_rollers: dict[str, float]) -> dict[str, float]:
    """Return the forces on both bodies of every contact: the given one on the roller, the opposite one on the other."""
    forces = {}
    for contact, force in on_rollers.items():
        roller, other = contact.split("_")
        forces[f"{contact} {roller}"] = force
        forces[f"{contact} {other}"] = -force
    return forces


SEED = 1729


def machines(count: int) -> list[tuple[Oscillator, float]]:
    """Return the corners of R and x₀ with unequal masses, and `count` random machines within the sliders' ranges."""
    random = np.random.default_rng(SEED)

    def anywhere(key: str) -> float:
        control = PARAMETERS[key]
        return math.exp(random.uniform(math.log(control.least), math.log(control.most))) * control.scale

    corners = product(*((PARAMETERS[key].least, PARAMETERS[key].most) for key in ("radius", "compression")))
    machines = [(Oscillator(2.0, 0.7, 30.0, R / 100), x0 / 100) for R, x0 in corners]
    for _ in range(count):
        machines.append((Oscillator(*map(anywhere, ("m", "m_prime", "k", "radius"))), anywhere("compression")))
    return machines

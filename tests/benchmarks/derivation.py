"""How long the derivations take: to build each route, to put numbers into all of its steps, and to judge an answer.

Run as `python -m tests.benchmarks.derivation`. With numbers a whole route should take about a millisecond, and so
should the six steps of the first page, with √1729 as without. A page may spend 200 ms on an answer; the first answer to
a question also derives its typical mistakes.
"""

import argparse
import time
from collections.abc import Callable
from statistics import median

from ramanujan import UNIT_MASS_RATIO
from ramanujan.answers import QUESTIONS, judge, question
from ramanujan.derivation import ROUTES, Step
from ramanujan.derivation.numbers import Numbers
from ramanujan.derivation.rows import rows
from ramanujan.pages.oscillator.cache import SUMMARY

MACHINES = {
    "on the steps": lambda n: (1 + n / 100, 1.13),
    "off the steps": lambda n: (1.2345678901 + n / 1e10, 1.234567),
    "with √1729": lambda n: (1 + n / 100, (1 + n / 100) * UNIT_MASS_RATIO),
}
FIRST_PAGE = [key for line in SUMMARY for key in line]


def milliseconds(action: Callable[[], object]) -> float:
    """Return the duration of one call."""
    start = time.perf_counter()
    action()
    return 1e3 * (time.perf_counter() - start)


def times(steps: list[Step], machine: Callable[..., tuple]) -> list[float]:
    """Return how long a page takes to show the steps of nine machines that it has not met before."""
    durations = []
    for n in range(10):
        mass, roller_mass = machine(n)
        numbers = Numbers(mass, roller_mass, 50 * mass)
        durations.append(
            milliseconds(lambda numbers=numbers: [row.latex for step in steps for row in rows(step, numbers)])
        )
    return durations[1:]


def main() -> None:
    """Print build times, median and longest time of putting numbers in; then the answers."""
    argparse.ArgumentParser(description=__doc__).parse_args()
    print(f"{'':<24}{'build':>8}" + "".join(f"{kind:>18}" for kind in MACHINES) + "   [ms]")
    parts = {name: lambda name=name: list(ROUTES[name].steps) for name in ROUTES}
    parts["six steps of page 1"] = lambda: [ROUTES["euler_lagrange"][key] for key in FIRST_PAGE]
    for name, part in parts.items():
        print(f"{name:<24}{milliseconds(part):>8.0f}", end="")
        for machine in MACHINES.values():
            found = times(part(), machine)
            print(f"{median(found):>10.1f} …{max(found):>6.1f}", end="")
        print()
    print(f"\n{'question':<30}{'asked [ms]':>12}{'first answer [ms]':>20}{'next [ms]':>12}")
    for name in QUESTIONS:
        steps = (lambda: question(name), lambda: judge(name, "2 m"), lambda: judge(name, "3 k / m"))  # noqa: B023
        asked, first, following = map(milliseconds, steps)
        print(f"{name:<30}{asked:>12.1f}{first:>20.1f}{following:>12.1f}")


if __name__ == "__main__":
    main()

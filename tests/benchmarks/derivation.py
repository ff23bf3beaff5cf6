"""How long the derivations take: to build each route, to put numbers into all of its steps, and to judge an answer.

Run as `python -m tests.benchmarks.derivation`. A page may spend 50 ms on putting numbers into a route, and 200 ms on an
answer; the first answer to a question also derives its typical mistakes.
"""

from __future__ import annotations

import time
from collections.abc import Callable
from statistics import median

import sympy as sp

from ramanujan.derivation import ROUTES
from ramanujan.derivation.answers import QUESTIONS, judge, question
from ramanujan.derivation.symbols import k, m, m_prime

RATIO_OF_1729 = (sp.sqrt(1729) - 1) / 36


def milliseconds(action: Callable[[], object]) -> float:
    """Return the duration of one call."""
    start = time.perf_counter()
    action()
    return 1e3 * (time.perf_counter() - start)


def substitution_times(name: str, ratio: sp.Expr, repeats: int = 9) -> list[float]:
    """Return the durations of putting numbers into a whole route, each time other ones, so that no cache helps."""
    masses = [sp.Rational(100 + n, 97) for n in range(repeats)]
    return [
        milliseconds(lambda mass=mass: ROUTES[name].with_numbers({m: mass, m_prime: ratio * mass, k: 50 * mass}))
        for mass in masses
    ]


def main() -> None:
    """Print build, median and longest substitution of each route for rational and surd masses; then the answers."""
    print(f"{'route':<16}{'build [ms]':>12}{'rational [ms]':>24}{'with √1729 [ms]':>24}")
    for name in ROUTES:
        build = milliseconds(lambda name=name: ROUTES[name])
        columns = [substitution_times(name, ratio) for ratio in (sp.Rational(113, 100), RATIO_OF_1729)]
        print(f"{name:<16}{build:>12.0f}" + "".join(f"{median(c):>14.1f} … {max(c):>6.1f} " for c in columns))
    print(f"\n{'question':<30}{'asked [ms]':>12}{'first answer [ms]':>20}{'next [ms]':>12}")
    for name in QUESTIONS:
        steps = (lambda: question(name), lambda: judge(name, "2 m"), lambda: judge(name, "3 k / m"))  # noqa: B023
        asked, first, following = map(milliseconds, steps)
        print(f"{name:<30}{asked:>12.1f}{first:>20.1f}{following:>12.1f}")


if __name__ == "__main__":
    main()

"""The right answers as SymPy expressions."""

import sympy as sp

from ramanujan.answers.grammar import parse
from ramanujan.answers.spelling import SYMBOLS as SPELLINGS
from tests.checks import answers
from tests.checks.answers import RATIO, RIGHT, zero_on_the_right

NAMES = ("m", "m'", "k", "R", "X", "X'", "phi", "phi'", "Phi", "Phi'")
m, mp, k, R, X, Xd, phi, phid, Phi, Phid = SYMBOLS = sp.symbols("m mp k R X Xd phi phid Phi Phid")
TYPED = dict(zip(SYMBOLS, NAMES, strict=True))
Xdd, phidd, Phidd, ratio = ACCELERATIONS = sp.symbols("Xdd phidd Phidd ratio")
TYPED |= dict(zip(ACCELERATIONS, ("X''", "phi''", "Phi''", "eps"), strict=True))


def by_hand(name: str) -> sp.Expr:
    """Return the answer by hand, or the difference of both sides of an equation."""
    read = parse(zero_on_the_right(RIGHT[name][0])).doit()
    return read.xreplace({SPELLINGS[text]: symbol for symbol, text in TYPED.items()})


QUOTIENTS = {
    "block_coupling": (6 * R * m + 6 * R * mp, 7 * m + 6 * mp),
    "top_coupling": (4 * m + 4 * mp, 7 * m + 6 * mp),
    "natural_frequency_squared": (56 * k * m + 48 * k * mp, 32 * m**2 + 49 * m * mp + 18 * mp**2),
}
EQUATIONS = {name: by_hand(name) for name in answers.EQUATIONS}
"""Expressions that vanish."""
ENERGIES = {name: by_hand(name) for name in RIGHT if name not in {*QUOTIENTS, *EQUATIONS, RATIO}}
ENERGIES["phi_equation"] = sp.expand(ENERGIES["phi_equation"])

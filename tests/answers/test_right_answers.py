"""Spellings of the right answer, as text and as LaTeX, regrouped by SymPy. The judge must reject none."""

import random
import re

import pytest
import sympy as sp

from ramanujan.answers import QUESTIONS, judge
from ramanujan.answers.grammar import MAX_LENGTH, typeset
from ramanujan.answers.spelling import SYMBOLS
from ramanujan.derivation.printers import latex
from tests.checks.answers import RATIO, RIGHT_RATIO
from tests.checks.expressions import ENERGIES, EQUATIONS, QUOTIENTS, TYPED, R, Xd, k, m, mp, phid
from tests.settings import DEEP

COUNT = 1000 if DEEP else 20
SPELLINGS = {
    "m'": ["m'", "m′", "m_prime", "m’"],
    "phi": ["phi", "φ", "ϕ", "varphi"],
    "X'": ["X'", "Ẋ", "X_dot", "X′", "(dX/dt)", "X\u0307"],
    "phi'": ["phi'", "φ'", "φ̇", "phi_dot", "dphi", "(dφ/dt)", "φ′", "ϕ'"],
    "Phi'": ["Phi'", "Φ'", "Φ̇", "Phi_dot", "(dΦ/dt)", "Φ′"],
    "X''": ["X''", "Ẍ", "X_ddot", "X″", "(d²X/dt²)", "X\u0308"],
    "phi''": ["phi''", "φ''", "φ̈", "phi_ddot", "(d^2φ/dt^2)", "φ′′"],
    "Phi''": ["Phi''", "Φ″", "Φ̈", "Phi_ddot", "(d²Φ/dt²)"],
    "eps": ["eps", "ε", "varepsilon", "ϵ"],
}
SIGNS = {
    "*": ["*", " * ", "·", " × "],
    "+": ["+", " + "],
    "-": ["-", " − ", "–"],
    "^2": ["^2", "**2", "²", "^(1+1)"],
    "sqrt": ["sqrt", "√"],
    "/2": ["/2", "*½", "*0.5", "*0,5", "*(1/2)"],
    "/4": ["/4", "*¼", "*0.25"],
}


def rewritten(expression: sp.Expr, source: random.Random) -> sp.Expr:
    """Return an equal expression in another form."""
    common = source.choice([m, mp, R, k, sp.Integer(5), sp.Rational(1, 4), m * R])
    ways = [
        sp.expand,
        sp.factor,
        sp.together,
        sp.cancel,
        sp.nsimplify,
        lambda e: sp.collect(sp.expand(e), source.choice([m, mp, R, k, Xd, phid])),
        lambda e: sp.Mul(common, sp.expand(e / common), evaluate=False),
        lambda e: sp.Add(e, common, -common, evaluate=False),
        lambda e: sp.horner(sp.expand(e), m) if e.is_polynomial(m) else sp.apart(e, m),
    ]
    return source.choice(ways)(expression)


def some_form(name: str, source: random.Random) -> sp.Expr:
    if name == RATIO:
        n = source.choice([1, 2, 3, 5, -1, m, k])
        above, below = source.choice([(sp.sqrt(1729) - 1, 36), (48, 1 + sp.sqrt(1729)), (RIGHT_RATIO, 1)])
        return sp.Mul(sp.expand(n * above), sp.Pow(sp.expand(n * below), -1, evaluate=False), evaluate=False)
    if name in ENERGIES or name in EQUATIONS:
        return rewritten((ENERGIES | EQUATIONS)[name], source)
    above, below = QUOTIENTS[name]
    if source.randrange(2):
        return rewritten(above / below, source)
    factor = source.choice([1, 2, -1, m, R, 3 * mp, m + mp, sp.Rational(1, 2)])
    above, below = (rewritten(sp.expand(each * factor), source) for each in (above, below))
    return sp.Mul(above, sp.Pow(below, -1, evaluate=False), evaluate=False)


def spelled(expression: sp.Expr, source: random.Random) -> str:
    """Return SymPy's text in a random spelling."""
    names = {str(symbol): SPELLINGS.get(name, [name]) for symbol, name in TYPED.items()}
    choices = names | SIGNS
    part = re.compile("|".join([r"\^2(?!\d)", r"/[24](?!\d)", *sorted(names, key=len, reverse=True), "sqrt", r"[-+*]"]))
    return part.sub(lambda match: source.choice(choices[match[0]]), str(expression).replace("**", "^"))


def as_latex(expression: sp.Expr) -> str:
    """Return the LaTeX of the app's printer."""
    return latex(expression.xreplace({symbol: SYMBOLS[name] for symbol, name in TYPED.items()}))


@pytest.mark.parametrize("name", QUESTIONS)
def test_right_answer_is_accepted_in_any_form_and_spelling(name):
    source = random.Random(name)
    refused = 0
    for _ in range(COUNT):
        expression = some_form(name, source)
        text = as_latex(expression) if source.random() < 0.3 else spelled(expression, source)
        verdict = judge(name, text)
        if verdict.kind == "unreadable":
            # The only permitted error is about a text that is too long.
            assert "too long" in verdict.message or "too large" in verdict.message, (text, verdict.message)
            refused += 1
            continue
        assert verdict.kind in ("right", "unsimplified"), (text, verdict.message)
        # The typeset formula is valid input.
        again = typeset(text, is_equation=name in EQUATIONS)
        assert len(again) > MAX_LENGTH or judge(name, again).kind == verdict.kind, (text, again)
    assert refused < COUNT / 4

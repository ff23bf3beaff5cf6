"""Thousands of ways to write the right answer: expanded, factored, regrouped, respelled; none may be called wrong.

A writer of our own turns each answer into text, with every choice drawn at random. The suite takes a small seeded
sample; RAMANUJAN_DEEP=1 takes 5,000 spellings of each answer.
"""

from __future__ import annotations

import itertools
import os
import random
from collections.abc import Callable

import pytest
import sympy as sp

from ramanujan.derivation.answers import QUESTIONS, judge
from tests.test_wrong_answers import ENERGIES, QUOTIENTS, RATIO, RIGHT_RATIO, Phid, R, Xd, k, m, mp, phi, phid

COUNT = 5000 if os.environ.get("RAMANUJAN_DEEP") else 25
SPELLINGS = {
    m: ["m"],
    mp: ["m'", "m′", "m_prime", "m’"],
    k: ["k"],
    R: ["R"],
    phi: ["phi", "φ", "ϕ", "varphi"],
    Xd: ["X'", "Ẋ", "X_dot", "X′", "(dX/dt)", "X\u0307"],
    phid: ["phi'", "φ'", "φ̇", "phi_dot", "dphi", "(dφ/dt)", "φ′", "ϕ'"],
    Phid: ["Phi'", "Φ'", "Φ̇", "Phi_dot", "(dΦ/dt)", "Φ′"],
}
FRACTIONS = {(1, 2): ["½", "0.5", ".5", "1/2"], (1, 4): ["¼", "0.25"], (3, 4): ["¾", "0.75"], (7, 2): ["3.5"]}
SUPERSCRIPTS = str.maketrans("0123456789", "⁰¹²³⁴⁵⁶⁷⁸⁹")


class Writer:
    """Writes an expression as a student might; every choice is drawn."""

    def __init__(self, source: random.Random) -> None:
        self.draw = source

    def sum(self, expression: sp.Expr) -> str:
        terms = list(sp.Add.make_args(expression))
        self.draw.shuffle(terms)
        if len(terms) > 2 and self.draw.random() < 0.2:
            return f"{self.product(terms[0])} + ({self.sum(sp.Add(*terms[1:]))})"
        text = ""
        for term in terms:
            if term.could_extract_minus_sign():
                text += self.draw.choice([" - ", "-", "−", " – "]) + self.product(-term)
            else:
                text += (self.draw.choice([" + ", "+"]) if text else "") + self.product(term)
        return text

    def product(self, expression: sp.Expr) -> str:
        number, rest = expression.as_coeff_Mul()
        above = [f for f in sp.Mul.make_args(rest) if not (f.is_Pow and f.exp.is_negative)]
        below = [1 / f for f in sp.Mul.make_args(rest) if f not in above]
        if rest == 1:
            above = []
        self.draw.shuffle(above)
        if self.draw.random() < 0.1:
            number, extra = sp.Integer(1), number
            return f"({self.number(extra)})*({self.product(sp.Mul(number, *above, *(1 / f for f in below)))})"
        p, q = number.p, number.q
        texts = [self.factor(f) for f in above]
        if (p, q) in FRACTIONS and self.draw.random() < 0.6 and texts:
            texts.insert(0, self.draw.choice(FRACTIONS[p, q]))
            if texts[0] == "1/2":
                texts[0] = "(1/2)"
            q = 1
        elif p != 1 or not texts:
            texts.insert(0, self.integer(p))
        text = texts[0]
        for before, after in itertools.pairwise(texts):
            text += self.separator(before, after) + after
        denominators = ([self.integer(q)] if q != 1 else []) + [self.factor(f) for f in below]
        if not denominators:
            return text
        if len(denominators) > 1 and self.draw.random() < 0.5:
            return f"{text}/({'*'.join(denominators)})"
        return text + "".join(f"/{each}" if each.isalnum() else f"/({each})" for each in denominators)

    def separator(self, before: str, after: str) -> str:
        if after[0].isdigit() or after[0] in ".½¼¾" or (before[-1].isdigit() and after[0] == "("):
            return "*"
        bare_root = before.startswith("√") and "(" not in before
        return self.draw.choice(["*", " ", "·", " × ", ""] if not bare_root else ["*", "·"])

    def factor(self, expression: sp.Expr) -> str:
        if expression.is_Pow and expression.exp == sp.Rational(1, 2):
            inside = self.sum(expression.base)
            return self.draw.choice([f"√({inside})", f"sqrt({inside})", f"({inside})^(1/2)", f"({inside})^½"])
        if expression.is_Pow and expression.exp.is_Integer:
            return self.power(expression.base, int(expression.exp))
        if expression.is_Integer:
            return self.integer(int(expression))
        if expression.is_Symbol:
            return self.draw.choice(SPELLINGS[expression])
        return f"({self.sum(expression)})"

    def power(self, base: sp.Expr, n: int) -> str:
        text = self.factor(base)
        if not (text[0] == "(" and text[-1] == ")") and not base.is_Symbol:
            text = f"({text})"
        kind = self.draw.randrange(5)
        if kind == 0:
            return "*".join([text] * n)
        if kind == 1:
            return f"{text}{str(n).translate(SUPERSCRIPTS)}"
        if kind == 2 and base in (m, mp, k, R):
            return f"√({text}^{2 * n})"
        return f"{text}{self.draw.choice(['^', '**', ' ^ '])}{n}"

    def integer(self, n: int) -> str:
        kind = self.draw.random()
        if kind < 0.04:
            return f"√({n**2})" if n > 0 else str(n)
        if kind < 0.08:
            split = self.draw.randrange(1, 9)
            return f"({n - split}+{split})"
        if kind < 0.12:
            return f"({2 * n}/2)"
        if kind < 0.14:
            return f"{n}.0"
        return str(n)

    def number(self, number: sp.Rational) -> str:
        return f"{self.integer(number.p)}/{self.integer(number.q)}"


def rewritten(expression: sp.Expr, source: random.Random) -> sp.Expr:
    """An equal expression, put together otherwise."""
    ways: list[Callable[[sp.Expr], sp.Expr]] = [
        lambda e: e,
        sp.expand,
        sp.factor,
        sp.together,
        lambda e: sp.collect(sp.expand(e), source.choice([m, mp, R, k, Xd, phid])),
        lambda e: sp.Mul(sp.Rational(1, 6), sp.expand(6 * e), evaluate=False),
        lambda e: pulled_out(e, source),
    ]
    return source.choice(ways)(expression)


def pulled_out(expression: sp.Expr, source: random.Random) -> sp.Expr:
    """A common factor in front of a bracket, whether or not all terms contain it."""
    common = source.choice([m, mp, R, k, sp.Integer(5), sp.Rational(1, 4), m * R])
    return sp.Mul(common, sp.expand(expression / common), evaluate=False)


def quotient(name: str, source: random.Random) -> sp.Expr:
    above, below = QUOTIENTS[name]
    factor = source.choice([1, 2, -1, m, R, 3 * mp, m + mp, sp.Rational(1, 2)])
    top, bottom = rewritten(sp.expand(above * factor), source), rewritten(sp.expand(below * factor), source)
    return sp.Mul(top, sp.Pow(bottom, -1, evaluate=False), evaluate=False)


def unit_ratio(source: random.Random) -> sp.Expr:
    root, n = sp.sqrt(1729), source.choice([1, 2, 3, 5, -1, m, k])
    return source.choice(
        [
            lambda: sp.Mul(sp.expand(n * (root - 1)), sp.Pow(36 * n, -1, evaluate=False), evaluate=False),
            lambda: sp.Mul(48 * n, sp.Pow(sp.expand(n * (1 + root)), -1, evaluate=False), evaluate=False),
            lambda: root / 36 - sp.Rational(1, 36),
            lambda: sp.Add(RIGHT_RATIO, n, -n, evaluate=False),
        ]
    )()


@pytest.mark.parametrize("name", QUESTIONS)
def test_the_right_answer_is_right_in_any_spelling(name: str) -> None:
    source = random.Random(name)
    refused = 0
    for _ in range(COUNT):
        if name == RATIO:
            expression = unit_ratio(source)
        else:
            expression = rewritten(ENERGIES[name], source) if name in ENERGIES else quotient(name, source)
        text = Writer(source).sum(expression)
        verdict = judge(name, text)
        if verdict.kind == "unreadable":
            # Some texts are longer than a formula may be; nothing else is refused.
            assert "too long" in verdict.message or "too large" in verdict.message, (text, verdict.message)
            refused += 1
            continue
        assert verdict.kind in ("right", "unsimplified"), (text, verdict.message)
    assert refused < COUNT / 4

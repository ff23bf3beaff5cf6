r"""Numbers into formulas: a formula is printed once with a slot for each number, then filled for any machine.

Where masses and stiffness have values, each formula is a sum of terms, each a number times something that keeps its
symbols. The template keeps that LaTeX, and each number as a rational function of m, m′ and k:

    ½R²(8m + 7m′)φ̇²   →   □ R²φ̇²  with  □ = (8m + 7m′)/2   →   \frac{15}{2}\,R^{2}\,\dot{\varphi}^{2}

Filling evaluates the functions exactly and joins text; nothing is simplified or printed by SymPy again.
"""

import re
from collections.abc import Callable, Mapping
from dataclasses import dataclass
from fractions import Fraction
from functools import cache, lru_cache, partial
from math import lcm

import sympy as sp
from sympy.utilities.iterables import sift

from ramanujan.derivation.printers import InOrder, LatexPrinter, Number, in_order, number_to_latex
from ramanujan.derivation.symbols import k, m, m_prime
from ramanujan.translation import _

GIVEN = (m, m_prime, k)
"""What has a value."""

Values = Mapping[sp.Symbol, sp.Expr]
"""m, m′ and k as exact numbers, such as `numbers.exact_values` returns; m′/m may carry a square root."""

Highlight = tuple[tuple[sp.Basic, str], ...]
"""Symbols, or functions of time, and their colours."""

Coefficients = tuple[tuple[int, int], ...]
"""Of a polynomial, by falling powers: c and d of each coefficient c + d√n."""

# Private characters, which no formula contains, surround what belongs there in the printed text: the sign of a number,
# its absolute value, its numerator or its denominator.
_SIGN, _ABSOLUTE, _ABOVE, _BELOW = "sabc"
_SLOT = re.compile("( \\+ )?\ue000(\\d+)([sabc])\ue001(\\\\,)?")


@dataclass(frozen=True)
class Template:
    """One side of an equation: its terms as LaTeX with slots, and the numbers in them as functions of m, m′ and k."""

    terms: tuple[str, ...]
    numbers: tuple[sp.Expr, ...]

    def filled(self, values: Values | None = None) -> list[str]:
        """Return the terms, each with its sign; without values there must be no slot."""
        if not self.numbers:
            return list(self.terms)
        numbers = [number_to_latex(number) for number in self.evaluated(values)]

        def put(found: re.Match) -> str:
            plus, place, kind, times = found.groups("")
            number = numbers[int(place)]
            if kind == _SIGN:
                return f"{plus and ' '}- " if number.sign < 0 else plus
            text = {_ABSOLUTE: number.absolute, _ABOVE: number.above, _BELOW: number.below}[kind]
            if not times:
                return text
            is_sum = number.is_sum and (kind == _ABOVE or not number.below)
            return "" if text in ("", "1") else (rf"\left({number.above}\right)" if is_sum else text) + times

        return [_SLOT.sub(put, term) for term in self.terms]

    def evaluated(self, values: Values) -> list[Number]:
        """Return the numbers for exact values.

        Raises
        ------
        ValueError : values contain other roots than multiples of one square root, in m′ alone.
        """
        mass, roller_mass, stiffness = (sp.sympify(values[symbol]) for symbol in GIVEN)
        if not (mass.is_Rational and stiffness.is_Rational):
            raise ValueError(_("values must give m and k as fractions"))
        p, r, q, n = _ratio(mass, roller_mass, _root_in(*self.numbers))
        of_mass, of_spring = Fraction(mass.p, mass.q), Fraction(stiffness.p, stiffness.q)
        found = []
        for (of_m, of_k), above, below in map(_quotient, self.numbers):
            (a, b), (c, d) = _at(above, p, r, q, n), _at(below, p, r, q, n)
            scale = of_mass**of_m * of_spring**of_k * Fraction(q) ** (len(below) - len(above))
            times, over = scale.as_integer_ratio()
            found.append(Number.of((a * c - n * b * d) * times, (b * c - a * d) * times, (c * c - n * d * d) * over, n))
        return found


@lru_cache(maxsize=1024)
def template(side: sp.Basic, highlight: Highlight = (), with_slots: bool = True) -> Template:
    """Return one side of an equation as a template.

    Parameters
    ----------
    side : an expression, a matrix or a tuple; rational in m, m′ and k
    highlight : symbols, or functions of time, in a colour
    with_slots : False for the formula in symbols, which has no slot to fill
    """
    numbers: dict[sp.Expr, sp.Symbol] = {}

    def slot(number: sp.Expr) -> sp.Expr:
        return numbers.setdefault(number, sp.Symbol(f"slot_{len(numbers)}", positive=True))

    slotted = gather_numbers(side, slot) if with_slots else side
    printer = _TemplatePrinter(dict(highlight), {symbol: place for place, symbol in enumerate(numbers.values())})
    return Template(tuple(printer.terms(slotted)), tuple(numbers))


def gather_numbers(expression: sp.Basic, replaced: Callable[[sp.Expr], sp.Expr]) -> sp.Basic:
    """Return the expression with each part that is a rational function of m, m′ and k alone replaced.

    Parameters
    ----------
    expression : an expression or a matrix
    replaced : part → what replaces it
    """
    if expression.free_symbols.isdisjoint(GIVEN):
        return expression
    if _is_number(expression):
        return replaced(expression)
    if isinstance(expression, InOrder):
        return in_order(*(gather_numbers(part, replaced) for part in expression.args))
    if not isinstance(expression, sp.Add | sp.Mul):
        return expression.func(*(gather_numbers(part, replaced) for part in expression.args))
    numbers, rest = sift(expression.args, _is_number, binary=True)
    if numbers and expression.is_Mul and (sums := [argument for argument in rest if argument.is_Add]):
        # A number before a sum goes into it, where it meets the numbers of the terms, and takes a denominator along.
        rest.remove(sums[0])
        below, before = sift(rest, lambda argument: argument.is_Pow and argument.exp.is_negative, binary=True)
        distributed = sp.Add(*(sp.Mul(*numbers, term, *below) for term in sums[0].args))
        return gather_numbers(sp.Mul(distributed, *before), replaced)
    gathered = (gather_numbers(part, replaced) for part in rest)
    return expression.func(*([replaced(expression.func(*numbers))] if numbers else []), *gathered)


def _is_number(expression: sp.Expr) -> bool:
    """Tell whether the expression is a rational function of m, m′ and k alone."""
    if expression.is_Symbol:
        return expression in GIVEN
    return expression.is_Rational or (
        type(expression) in (sp.Add, sp.Mul, sp.Pow) and all(_is_number(part) for part in expression.args)
    )


def _mark(place: int, kind: str) -> str:
    return f"\ue000{place}{kind}\ue001"


class _TemplatePrinter(LatexPrinter):
    """Prints the slot of a number, as marked text, before what it is multiplied by."""

    def __init__(self, highlight: Mapping[sp.Basic, str], slots: Mapping[sp.Symbol, int]) -> None:
        super().__init__(highlight)
        self._slots = slots

    def terms(self, expression: sp.Basic) -> list[str]:
        """Return the terms of a sum, or an expression as its only term, each with its sign."""
        if not isinstance(expression, sp.Add):
            return [self._print(expression)]
        ordered = expression.args
        if not isinstance(expression, InOrder):
            # The order is that of the terms without their numbers.
            sifted = ((*self._sifted(term), term) for term in expression.args)
            with_number = {sp.Mul(*rest) if slot else term: term for slot, rest, term in sifted}
            ordered = [with_number[rest] for rest in sp.Add(*with_number).as_ordered_terms()]
        texts = [self._print(term) for term in ordered]
        return [texts[0], *(f" - {each[1:].lstrip()}" if each[0] == "-" else f" + {each}" for each in texts[1:])]

    def _print_Add(self, expr: sp.Add, order: str | None = None) -> str:
        has_slot = not self._slots.keys().isdisjoint(expr.free_symbols)
        return "".join(self.terms(expr)) if has_slot else super()._print_Add(expr, order)

    def _print_Mul(self, expr: sp.Mul) -> str:
        slot, others = self._sifted(expr)
        if not slot:
            return super()._print_Mul(expr)
        above, below = sp.fraction(sp.Mul(*others))
        if below == 1:
            return rf"{self._print(slot[0])}\,{self._print(above)}"
        above = rf"\,{self._print(above)}" if above != 1 else ""
        mark = partial(_mark, self._slots[slot[0]])
        return rf"{mark(_SIGN)}\frac{{{mark(_ABOVE)}{above}}}{{{mark(_BELOW)}\,{self._print(below)}}}"

    def _print_Symbol(self, expr: sp.Symbol, style: str = "plain") -> str:
        if expr not in self._slots:
            return super()._print_Symbol(expr, style)
        return _mark(self._slots[expr], _SIGN) + _mark(self._slots[expr], _ABSOLUTE)

    def _sifted(self, term: sp.Expr) -> tuple[list[sp.Expr], list[sp.Expr]]:
        return sift(sp.Mul.make_args(term), lambda factor: factor in self._slots, binary=True)


# Numbers


@cache
def _quotient(number: sp.Expr) -> tuple[tuple[int, int], Coefficients, Coefficients]:
    """Return a number as mⁱkʲ times a quotient of polynomials in m′/m: i and j, and both polynomials.

    A number has a unit, so it is homogeneous in m and m′, and in k.
    """
    root, symbol = _root_in(number), sp.Symbol("root")
    plain = number.subs(root, symbol) if root else number
    above, below = (sp.Poly(part, *GIVEN, symbol) for part in sp.fraction(sp.together(plain)))
    common, above = above.clear_denoms(convert=True)
    degrees, polynomials = [], []
    for part in (above, below * common):
        i, of_prime, j, _of_root = part.monoms()[0]
        degrees.append((i + of_prime, j))
        found = [[0, 0] for _power in range(part.degree(m_prime) + 1)]
        for (_i, of_prime, _j, of_root), c in part.terms():
            found[-1 - of_prime][of_root % 2] += int(c) * int(root.base if root else 1) ** (of_root // 2)
        polynomials.append(tuple(map(tuple, found)))
    (i, j), (below_i, below_j) = degrees
    return (i - below_i, j - below_j), *polynomials


def _at(coefficients: Coefficients, p: int, r: int, q: int, n: int) -> tuple[int, int]:
    """Return a polynomial at (p + r√n)/q, times q to the power of its degree, as a + b√n."""
    a, b, scale = 0, 0, 1
    for c, d in coefficients:
        a, b, scale = a * p + b * r * n + c * scale, a * r + b * p + d * scale, scale * q
    return a, b


@lru_cache(maxsize=1024)
def _ratio(mass: sp.Rational, roller_mass: sp.Expr, other: sp.Pow | None) -> tuple[int, int, int, int]:
    """Return p, r, q and n of m′/m = (p + r√n)/q; n is that of another root if there is one."""
    root, ratio = _root_in(roller_mass, *([other] if other else [])), sp.expand(roller_mass / mass)
    of_root = ratio.coeff(root) if root else sp.S.Zero
    plain = ratio - of_root * root if root else ratio
    q = lcm(plain.q, of_root.q)
    return int(plain * q), int(of_root * q), q, int(root.base) if root else 1


@lru_cache(maxsize=4096)
def _root_in(*values: sp.Expr) -> sp.Pow | None:
    """Return the one square root in some numbers, or None if all are fractions.

    Raises
    ------
    ValueError : values contain other roots, or more than one.
    """
    roots = {power for value in values for power in value.atoms(sp.Pow) if not power.exp.is_Integer}
    if len(roots) > 1 or any(root.exp != sp.S.Half or not root.base.is_Integer for root in roots):
        raise ValueError(_("values must contain no roots except multiples of one square root"))
    return next(iter(roots), None)

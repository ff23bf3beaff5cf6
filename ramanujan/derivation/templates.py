r"""Numbers into formulas: a formula is printed once with a slot for each number, then filled for any machine.

Where masses and stiffness have values, each formula is a sum of terms, each a number times something that keeps its
symbols. The template keeps that LaTeX, and each number as a rational function of m, m′ and k:

    ½R²(8m + 7m′)φ̇²   →   □ R²φ̇²  with  □ = (8m + 7m′)/2   →   \frac{15}{2}\,R^{2}\,\dot{\varphi}^{2}

Filling evaluates the functions exactly and joins text; nothing is simplified or printed by SymPy again.
"""

import re
from collections.abc import Callable, Mapping
from dataclasses import dataclass
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
        made = _functions(self.numbers)
        n, plain, of_root = _parts(roller_mass, made.root)
        q = lcm(mass.q, plain.q, of_root.q)
        of_mass, plain, of_root = (int(part * q) for part in (mass, plain, of_root))
        base = made.base(of_mass, plain, of_root, stiffness.p)
        results = iter(made.function(of_mass, plain + of_root * base, stiffness.p, base))
        found = []
        for (mass_degree, stiffness_degree), above, below in zip(made.degrees, results, results, strict=True):
            (p, r), (s, t) = _in_root(above, base, n), _in_root(below, base, n)
            (a, b), (c, d) = _power((1, q), mass_degree), _power((1, stiffness.q), stiffness_degree)
            found.append(
                Number.of((p * s - n * r * t) * a * c, (r * s - p * t) * a * c, (s * s - n * t * t) * b * d, n)
            )
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


def _power(quotient: tuple[int, int], exponent: int) -> tuple[int, int]:
    above, below = quotient if exponent >= 0 else quotient[::-1]
    return above ** abs(exponent), below ** abs(exponent)


class _Functions:
    """Numerators and denominators of numbers as one function of m, m′, k and √n, with integer coefficients.

    A number has a unit, so it is homogeneous in m and m′, and in k: `degrees` says of which degrees.
    """

    def __init__(self, numbers: tuple[sp.Expr, ...]) -> None:
        self.root, symbol = _root_in(*numbers), sp.Symbol("root")
        parts, self.degrees, self._degree, self._bits = [], [], 0, 0
        for number in numbers:
            plain = number.subs(self.root, symbol) if self.root else number
            above, below = (sp.Poly(part, *GIVEN, symbol) for part in sp.fraction(sp.together(plain)))
            # With a fraction among its coefficients, a generated function would compute in floats.
            common, above = above.clear_denoms(convert=True)
            below *= common
            (i, j, of_k, _r), (a, b, below_k, _r) = above.monoms()[0], below.monoms()[0]
            self.degrees.append((i + j - a - b, of_k - below_k))
            for part in (above, below):
                parts.append(part.as_expr())
                self._degree = max(self._degree, part.total_degree())
                self._bits = max(self._bits, int(sum(map(abs, part.coeffs()))).bit_length())
        self.function = sp.lambdify((*GIVEN, symbol), parts, modules=[], cse=True)

    def base(self, *values: int) -> int:
        """Return a power of two beyond twice the size of every coefficient of √n in the results for these values."""
        return 1 << self._bits + self._degree * max(2 * abs(value) for value in values).bit_length() + 2


_functions = cache(_Functions)


def _in_root(value: int, base: int, n: int) -> tuple[int, int]:
    """Return p and r of a polynomial in √n, p + r√n, from its value at a base that exceeds its coefficients.

    The digits of the value in that base are the coefficients (Kronecker’s substitution).
    """
    parts, place = [0, 0], 0
    while value:
        digit = (value + base // 2) % base - base // 2
        parts[place % 2] += digit * n ** (place // 2)
        value, place = (value - digit) // base, place + 1
    return parts[0], parts[1]


@lru_cache(maxsize=1024)
def _parts(value: sp.Expr, other: sp.Expr | None) -> tuple[int, sp.Rational, sp.Rational]:
    """Return n, p and r of a value p + r√n; n is that of another root if there is one."""
    root = _root_in(value, *([other] if other else []))
    expanded = value.expand()
    of_root = expanded.coeff(root) if root else sp.S.Zero
    return int(root.base) if root else 1, expanded - of_root * root if root else expanded, of_root


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

r"""Formulas as LaTeX with slots: printed once in symbols, then filled with the exact numbers of any machine.

Where masses and stiffness have values, each formula is a sum of terms, each a number times something that keeps its
symbols. So a formula is printed once with a slot for each number, and the number as a rational function beside it:

    ½R²(8m + 7m′)φ̇²   →   □ R²φ̇²  with  □ = (8m + 7m′)/2   →   \frac{15\,R^{2}\,\dot{\varphi}^{2}}{2}

Filling evaluates the functions exactly and joins text; nothing is simplified or printed by SymPy again. `substitution`
is the general way to the same formulas, and the tests hold the two against each other.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, replace
from functools import cache, cached_property, lru_cache

import sympy as sp

from ramanujan.derivation.exact import Rational, Surd, Written, element, root_in, written
from ramanujan.derivation.printers import LatexPrinter
from ramanujan.derivation.substitution import gather_numbers
from ramanujan.derivation.symbols import k, m, m_prime

GIVEN = (m, m_prime, k)
"""What has a value, in the order in which `numbers_for` takes it."""

# Private characters, which no formula contains, mark a slot in the printed text: sign, index, numerator, denominator.
_OPEN, _NEXT, _CLOSE = "\ue000", "\ue001", "\ue002"
_ALONE, _FIRST, _LATER = "a", "f", "l"


@dataclass(frozen=True)
class Slot:
    """A place for a number times `above` over `below`; `role` says whether a term stands before it in a sum."""

    index: int
    role: str
    above: Text
    below: str


Text = tuple["str | Slot", ...]
"""LaTeX with slots in it."""


@dataclass(frozen=True)
class Template:
    """One side of an equation: its terms, whose signs come with the numbers, and the numbers as functions of GIVEN."""

    terms: tuple[Text, ...]
    numbers: tuple[sp.Expr, ...]

    @cached_property
    def is_number(self) -> bool:
        """Whether the side is a number alone."""
        return self.terms == ((Slot(0, _FIRST, (), ""),),)

    @cached_property
    def plain(self) -> tuple[str, ...]:
        """The terms of a side without numbers."""
        return tuple("".join(term) for term in self.terms)


@lru_cache(maxsize=1024)
def template(side: sp.Basic, highlight: tuple[tuple[sp.Basic, str], ...] = (), with_slots: bool = True) -> Template:
    """Return one side of an equation as a template.

    Parameters
    ----------
    side : an expression, a matrix or a tuple; rational in m, m′ and k
    highlight : symbols, or functions of time, and their colours
    with_slots : False for the formula in symbols, which has no slot to fill
    """
    numbers: dict[sp.Expr, sp.Symbol] = {}

    def slot(number: sp.Expr) -> sp.Expr:
        return numbers.setdefault(number, sp.Symbol(f"slot_{len(numbers)}", positive=True))

    slotted = gather_numbers(side, frozenset(GIVEN if with_slots else ()), slot)
    printer = _SlotPrinter(dict(highlight), tuple(numbers.items()))
    terms = tuple(_parsed(text) for text in printer.terms(slotted))
    return Template(terms, tuple(numbers))


class _SlotPrinter(LatexPrinter):
    """Prints a number's slot, and what it is multiplied by, as marked text."""

    def __init__(self, highlight: Mapping[sp.Basic, str], numbers: tuple[tuple[sp.Expr, sp.Symbol], ...]) -> None:
        super().__init__(highlight)
        self._slots = {symbol: index for index, (_, symbol) in enumerate(numbers)}
        self._signs = {symbol: sp.sign(number.subs(dict.fromkeys(GIVEN, 1))) for number, symbol in numbers}

    def terms(self, expression: sp.Basic) -> list[str]:
        """Return the terms of a sum, or an expression as its only term, each with its sign."""
        if not isinstance(expression, sp.Add):
            return [self._signed(expression, _FIRST)]
        first, *others = self._in_order(expression)
        return [self._signed(first, _FIRST), *(self._signed(term, _LATER) for term in others)]

    def _print_Add(self, expr: sp.Add, order: str | None = None) -> str:
        return "".join(self.terms(expr)) if self._has_slot(expr) else super()._print_Add(expr, order)

    def _print_Mul(self, expr: sp.Mul) -> str:
        return self._signed(expr, _ALONE) if self._slot_of(expr) is not None else super()._print_Mul(expr)

    def _print_Symbol(self, expr: sp.Symbol, style: str = "plain") -> str:
        return self._signed(expr, _ALONE) if expr in self._slots else super()._print_Symbol(expr, style)

    def _signed(self, term: sp.Basic, role: str) -> str:
        slot = self._slot_of(term)
        if slot is None:
            text = self._print(term)
            if role == _LATER:
                return f" - {text[1:].lstrip()}" if text.startswith("-") else f" + {text}"
            return text
        above, below = sp.fraction(term / slot)
        parts = (role, str(self._slots[slot]), *("" if part == 1 else self._print(part) for part in (above, below)))
        return _OPEN + _NEXT.join(parts) + _CLOSE

    def _slot_of(self, term: sp.Basic) -> sp.Symbol | None:
        factors = term.args if isinstance(term, sp.Mul) else (term,)
        return next((factor for factor in factors if factor in self._slots), None)

    def _has_slot(self, expression: sp.Basic) -> bool:
        return not self._slots.keys().isdisjoint(expression.free_symbols)

    def _in_order(self, total: sp.Add) -> list[sp.Expr]:
        """Return the terms in the order in which SymPy writes them with numbers in the place of the slots."""
        if not self._has_slot(total):
            return total.as_ordered_terms()
        numbered = {}
        for place, term in enumerate(total.args):
            slot = self._slot_of(term)
            factor = sp.S.One if slot is None else sp.prime(place + 5) * self._signs[slot] / slot
            numbered[term * factor] = term
        return [numbered[each] for each in sp.Add(*numbered).as_ordered_terms()]


def _parsed(text: str) -> Text:
    """Return marked text as text and slots."""
    found, rest = _read(text)
    assert not rest
    return found


def _read(text: str) -> tuple[Text, str]:
    """Return the marked text up to its end, or to the mark that ends the part in which it is, and the rest."""
    pieces: list[str | Slot] = []
    while text:
        end = min((i for mark in (_OPEN, _NEXT, _CLOSE) if (i := text.find(mark)) >= 0), default=len(text))
        if end:
            pieces.append(text[:end])
        text = text[end:]
        if not text.startswith(_OPEN):
            break
        role, index, text = text[1:].split(_NEXT, 2)
        above, text = _read(text)
        below, text = _read(text[1:])
        pieces.append(Slot(int(index), role, above, "".join(below)))
        text = text[1:]
    return tuple(pieces), text


# Filling


def fill(made: Template, numbers: Sequence[Written]) -> list[str]:
    """Return the terms of a side with its numbers; what has become zero is left out.

    Parameters
    ----------
    made : the template
    numbers : what `numbers_for` returns for it, as LaTeX
    """
    filled = [text for text in (_filled(term, numbers) for term in made.terms) if text]
    if not filled:
        return ["0"]
    # The term that was to be the first one may have vanished.
    return [filled[0].removeprefix(" + ").replace(" - ", "- ", 1) if filled[0][0] == " " else filled[0], *filled[1:]]


def _filled(text: Text, numbers: Sequence[Written]) -> str:
    return "".join(piece if isinstance(piece, str) else _term(piece, numbers) for piece in text)


def _term(slot: Slot, numbers: Sequence[Written]) -> str:
    """Return the number times what belongs to it, with its sign."""
    number = numbers[slot.index]
    if not number.sign:
        return "0" if slot.role == _ALONE else ""
    above = _filled(slot.above, numbers)
    if not above and not slot.below:
        if slot.role != _LATER:
            return number.alone
        body = _absolute(number)
    elif number.is_decimal:
        body = number.factor + r"\," + (rf"\frac{{{above or 1}}}{{{slot.below}}}" if slot.below else above)
    else:
        numerator = _product(number.factor, above) if above else number.above
        denominator = _product(number.below, slot.below)
        body = rf"\frac{{{numerator}}}{{{denominator}}}" if denominator else numerator
    if slot.role == _LATER:
        return f" - {body}" if number.sign < 0 else f" + {body}"
    return f"- {body}" if number.sign < 0 else body


def _absolute(number: Written) -> str:
    """Return the absolute value of a number that follows a sign, in brackets where the sign would split it."""
    if number.sign < 0 and not number.below:
        return number.factor or number.above
    return replace(number, sign=1).alone


def _product(left: str, right: str) -> str:
    return rf"{left}\,{right}" if left and right else left or right


# Numbers


def numbers_for(made: Template, values: Exact) -> list[Written]:
    """Return the numbers of a template for exact values of m, m′ and k, as LaTeX."""
    return [written(number) for number in evaluated(made, values)]


Exact = tuple[Rational | Surd, Rational | Surd, Rational | Surd]
"""m, m′ and k as exact numbers."""


def exact(values: Mapping[sp.Symbol, sp.Expr]) -> Exact:
    """Return m, m′ and k as elements of ℚ, or of ℚ(√n) if one of them carries a root.

    Raises
    ------
    ValueError : values contain another root than one square root.
    """
    return _exact(tuple(sp.sympify(values[symbol]) for symbol in GIVEN))


@lru_cache(maxsize=256)
def _exact(values: tuple[sp.Expr, ...]) -> Exact:
    n = root_in(values)
    return tuple(element(value, n if value.has(sp.Pow) else None) for value in values)


def evaluated(made: Template, values: Exact) -> list[Rational | Surd]:
    """Return the numbers of a template, exactly."""
    function, root = _function(made.numbers)
    pairs = iter(function(*values, root))
    return [sp.QQ(above, below) if isinstance(above, int) and isinstance(below, int) else above / below
            for above, below in zip(pairs, pairs, strict=True)]  # fmt: skip


@cache
def _function(numbers: tuple[sp.Expr, ...]) -> tuple[Callable, Surd | None]:
    """Return a function of m, m′, k and a root that gives numerators and denominators with integer coefficients."""
    n = root_in(numbers)
    root = sp.Symbol("root")
    plain = [number.subs(sp.sqrt(n), root) if n else number for number in numbers]
    variables = (*GIVEN, root)
    parts = []
    for number in plain:
        above, below = sp.fraction(sp.together(number))
        # With a fraction among its coefficients, a generated function would compute in floats.
        common, above = sp.Poly(above, *variables).clear_denoms(convert=True)
        parts += [above.as_expr(), common * below]
    function = sp.lambdify(variables, parts, modules=[], cse=True)
    return function, Surd(0, 1, 1, n) if n else None

"""Format numbers for people: significant digits, thin spaces, a true minus sign, powers of ten.

    number(0.0332)            0.033             fixed(-0.5, 2)             −0.50
    number(12345.0, 3)        12 300            quantity(2.54, "m/s", 3)   2.54 m/s
    number(4.56e153)          4.6×10¹⁵³
    filled("It takes {t:3 s}.", t=0.61)         It takes 0.610 s.
    at_most(5.36e-16, 1), at_least(0.36, 1)     6×10⁻¹⁶, 0.3: an upper and a lower bound

The language determines the decimal mark. `sentences.js` applies the same rules in the browser, and
`derivation.printers` formats numbers in LaTeX. Files for programs use Python's format.
"""

import math
import re
import string
from collections.abc import Callable, Sequence
from decimal import ROUND_CEILING, ROUND_FLOOR, Decimal
from numbers import Integral
from typing import Any

from ramanujan.text.translation import _, pgettext

# TRANSLATORS: a point or a comma: what your language writes between 0 and 5 in one half.
DECIMAL = pgettext("decimal mark", ".")
_DECIMAL_IN_LATEX = DECIMAL if DECIMAL == "." else f"{{{DECIMAL}}}"
THIN = "\u202f"
"""A thin no-break space, between groups of three digits, and between a number and its unit."""

SUPERSCRIPTS = str.maketrans("-0123456789", "⁻⁰¹²³⁴⁵⁶⁷⁸⁹")
FROM_SUPERSCRIPTS = str.maketrans("⁻⁰¹²³⁴⁵⁶⁷⁸⁹", "-0123456789")
"""Translation tables from digits to superscripts, and back."""

_DIGITS_OF_A_FLOAT = 17
_LONGEST_INTEGER = 10**6
_POWERS_WITHOUT_EXPONENT = range(-4, 6)
"""A number is written without a power of ten if its leading digit has one of these powers."""

_UNITS_OF_TIME = ((1.0, "s"), (1e-3, "ms"), (1e-6, "µs"), (1e-9, "ns"))
_UNITS_OF_LENGTH = ((1e-2, "cm"), (1e-3, "mm"), (1e-6, "µm"), (1e-9, "nm"))

Number = float | int | Decimal


def number(value: Number, digits: int = 2, *, strip: bool = False) -> str:
    """Return a number with `digits` significant digits; an integer below a million keeps all its digits.

    Parameters
    ----------
    value : any real number, also a NumPy scalar
    digits : significant digits
    strip : whether to omit trailing zeros of a decimal

    >>> number(0.0332), number(-12345.0, 3), number(1729), number(4.56e153), number(1e6)
    ('0.033', '−12\\u202f300', '1729', '4.6×10¹⁵³', '10⁶')
    >>> number(0.5, 3), number(0.5, 3, strip=True)
    ('0.500', '0.5')
    """
    if isinstance(value, Integral):
        if abs(value) < _LONGEST_INTEGER:
            return _grouped(f"{int(value):,}")
        value = Decimal(int(value))
    if value != value:
        return _("not a number")
    if value in (math.inf, -math.inf):
        return "∞" if value > 0 else "−∞"
    if value == 0:
        return "0"
    mantissa, _e, exponent = f"{value:.{digits - 1}e}".partition("e")
    power = int(exponent)
    if power not in _POWERS_WITHOUT_EXPONENT:
        return _scientific(mantissa, power)
    places = digits - 1 - power
    text = f"{round(value, places):,.{max(places, 0)}f}"
    return _grouped(_without_trailing_zeros(text) if strip else text)


def _scientific(mantissa: str, power: int) -> str:
    """Return a mantissa times a power of ten, without trailing zeros and without the mantissa 1."""
    sign = "−" if mantissa.startswith("-") else ""
    factor = _without_trailing_zeros(mantissa.lstrip("-")).replace(".", DECIMAL)
    return sign + (power_of_ten(power) if factor == "1" else f"{factor}×{power_of_ten(power)}")


def _without_trailing_zeros(decimal: str) -> str:
    return decimal.rstrip("0").rstrip(".") if "." in decimal else decimal


def at_most(value: Number, digits: int = 2) -> str:
    """Return an upper bound of a number: the number rounded up to `digits` significant digits.

    Use it in a sentence with "at most", "up to", "below" or "never exceeds".

    >>> at_most(5.36e-16, 1), at_most(130298.5, 3), at_most(0.1, 1), at_most(-1.25, 2)
    ('6×10⁻¹⁶', '131\\u202f000', '0.1', '−1.2')
    """
    return number(_rounded(value, digits, ROUND_CEILING), digits)


def at_least(value: Number, digits: int = 2) -> str:
    """Return a lower bound of a number: the number rounded down to `digits` significant digits.

    >>> at_least(2.828, 3), at_least(16777216.0, 2), at_least(0.3, 1)
    ('2.82', '1.6×10⁷', '0.3')
    """
    return number(_rounded(value, digits, ROUND_FLOOR), digits)


def _rounded(value: Number, digits: int, rounding: str) -> Number:
    """Return a number rounded to `digits` significant digits; integers, infinities and NaN are returned unchanged."""
    if isinstance(value, Integral) or not math.isfinite(value) or value == 0:
        return value
    # `repr` gives the shortest decimal of a float. The exact value of the float 0.1 is a little larger than 0.1.
    decimal = value if isinstance(value, Decimal) else Decimal(repr(float(value)))
    last_digit = Decimal(1).scaleb(decimal.adjusted() - digits + 1)
    return decimal.quantize(last_digit, rounding)


def distinct_from(value: float, other: float, digits: int = 2, write: Callable[[Number, int], str] = number) -> str:
    """Return a number with `digits` significant digits, and more if it would otherwise look equal to another number.

    Parameters
    ----------
    value, other : two numbers
    digits : significant digits
    write : `number`, `at_most` or `at_least`

    >>> distinct_from(0.00103, 0.001), distinct_from(0.25, 0.001)
    ('0.00103', '0.25')
    """
    while digits < _DIGITS_OF_A_FLOAT and write(value, digits) == write(other, digits):
        digits += 1
    return write(value, digits)


def fixed(value: float, places: int) -> str:
    """Return a number with `places` decimal places.

    >>> fixed(-0.5, 2), fixed(12345.678, 1)
    ('−0.50', '12\\u202f345.7')
    """
    return _grouped(f"{value:,.{places}f}")


def quantity(value: Number, unit: str, digits: int = 2, *, strip: bool = False) -> str:
    """Return a number with its unit, a thin space between them.

    >>> quantity(2.54, "m/s", 3)
    '2.54\\u202fm/s'
    """
    return with_unit(number(value, digits, strip=strip), unit)


def with_unit(text: str, unit: str) -> str:
    """Return a formatted number with its unit; without a unit, return it unchanged.

    >>> with_unit("2", "kg")
    '2\\u202fkg'
    """
    return f"{text}{THIN}{unit}" if unit else text


def duration(seconds: float) -> str:
    """Return a time in s, ms, µs or ns, with a value between 1 and 1000.

    >>> duration(2.5e-5)
    '25\\u202fµs'
    """
    return _in_largest_unit(seconds, _UNITS_OF_TIME, number)


def length(metres: float) -> str:
    """Return an upper bound of a length in cm, mm, µm or nm.

    >>> length(0.0062), length(5e-9)
    ('6.2\\u202fmm', '5.0\\u202fnm')
    """
    return _in_largest_unit(metres, _UNITS_OF_LENGTH, at_most)


def _in_largest_unit(value: float, units: Sequence[tuple[float, str]], write: Callable[[Number], str]) -> str:
    """Return a value in the largest of its units that it reaches, or in the smallest unit."""
    reached = [(size, unit) for size, unit in units if value >= size]
    size, unit = reached[0] if reached else units[-1]
    return with_unit(write(value / size), unit)


def in_latex(decimal: str) -> str:
    """Return a decimal as LaTeX; braces prevent a space after a decimal comma.

    >>> in_latex("0.5")
    '0.5'
    """
    return decimal.replace(".", _DECIMAL_IN_LATEX)


def filled(template: str, **values: object) -> str:
    """Fill the slots of a template. A slot gives the format of its number: significant digits, then a unit or %.

    An arrow after the digits rounds up or down: "at most {error:1↑}", "at least {time:2↓ s}".

    Parameters
    ----------
    template : as for `str.format`; a text is inserted unchanged, and a slot without a format shows `str(value)`
    values : by the names of the slots; a share is multiplied by 100 if its slot has the unit %

    >>> filled("{n} periods take {t:3 s}, {share:2 %} more than {least:1}.", n=7, t=0.61, share=0.25, least=4.0)
    '7 periods take 0.610\\u202fs, 25\\u202f% more than 4.'
    >>> filled("The error is at most {error:1↑ %}.", error=0.0707)
    'The error is at most 8\\u202f%.'
    """
    return _FORMATTER.vformat(template, (), values)


class _SentenceFormatter(string.Formatter):
    """`str.format` with the formats of `filled`."""

    def format_field(self, value: Any, format_spec: str) -> str:
        digits_and_arrow, _space, unit = format_spec.partition(" ")
        if not digits_and_arrow or isinstance(value, str):
            return str(value)
        digits = int(digits_and_arrow.rstrip("↑↓"))
        write = {"↑": at_most, "↓": at_least}.get(digits_and_arrow[-1], number)
        if unit == "%":
            # As decimals: 100 · 0.07 is a little larger than 7.
            value = 100 * Decimal(repr(float(value)))
        return with_unit(write(value, digits), unit)


_FORMATTER = _SentenceFormatter()


def unbroken(formulas: str) -> str:
    """Return a list of formulas for a text, in which a line can break only between two formulas."""
    return re.sub("(?<![,:;]) ", "\u00a0", formulas).replace("/", "/\u2060")


def power_of_ten(exponent: int) -> str:
    """Return a power of ten with a raised exponent.

    >>> power_of_ten(-3)
    '10⁻³'
    """
    return f"10{superscript(exponent)}"


def superscript(exponent: int) -> str:
    """Return an integer in superscript digits.

    >>> superscript(-12)
    '⁻¹²'
    """
    return str(exponent).translate(SUPERSCRIPTS)


def _grouped(text: str) -> str:
    """Replace Python's grouping commas by thin spaces, or by nothing in four digits, and write a true minus sign."""
    whole, point, decimals = text.partition(".")
    thin = THIN if len(whole.lstrip("-")) > len("1,729") else ""
    return whole.replace(",", thin).replace("-", "−") + point.replace(".", DECIMAL) + decimals

"""Numbers as the lesson writes them: significant digits, a true minus sign, a thin space before the unit.

number(1.0505, 3)   1.05          quantity(0.615, "cm")   0.615 cm          percent(0.305)   30.5 %
"""

from __future__ import annotations

THIN = "\u202f"
"""A thin space that does not break."""


def number(value: float, digits: int = 3, *, strip: bool = False) -> str:
    """Return a number with so many significant digits; an integer keeps all of its own.

    Parameters
    ----------
    value : the number
    digits : significant digits
    strip : leave out the zeros at the end of a decimal

    >>> number(1.050505), number(-0.25, 2), number(1729), number(2.5e-7, 2), number(0.5, strip=True)
    ('1.05', '−0.25', '1729', '2.5×10⁻⁷', '0.5')
    """
    if isinstance(value, int):
        return str(value).replace("-", "−")
    mantissa, _e, exponent = f"{value:.{digits - 1}e}".partition("e")
    power = int(exponent)
    if value == 0 or -4 <= power < digits + 2:
        text = f"{value:.{max(digits - 1 - power, 0)}f}".replace("-", "−")
        return text.rstrip("0").rstrip(".") if strip and "." in text else text
    raised = str(power).translate(str.maketrans("-0123456789", "⁻⁰¹²³⁴⁵⁶⁷⁸⁹"))
    return f"{mantissa}×10{raised}".replace("-", "−")


def quantity(value: float, unit: str, digits: int = 3) -> str:
    """Return a number with its unit.

    >>> quantity(0.0625, "m")
    '0.062\\u202fm'
    """
    return f"{number(value, digits)}{THIN}{unit}"


def percent(share: float, digits: int = 2) -> str:
    """Return a share of the whole in percent.

    >>> percent(0.305, 3)
    '30.5\\u202f%'
    """
    return quantity(100 * share, "%", digits)

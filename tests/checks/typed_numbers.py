"""The table of typed numbers for all readers: text → its value, None for an invalid text, or its two readings.

The decimal mark is the point. With a decimal comma, points and commas change places.
"""

from fractions import Fraction

TYPED_NUMBERS: dict[str, Fraction | tuple[str, str] | None] = {
    # Decimals
    "12": Fraction(12),
    " 2 ": Fraction(2),
    "1.5": Fraction(3, 2),
    "1,5": Fraction(3, 2),
    ".5": Fraction(1, 2),
    ",5": Fraction(1, 2),
    "5.": Fraction(5),
    "+3": Fraction(3),
    "-0,25": Fraction(-1, 4),
    "12.500": Fraction(25, 2),
    "1.127": Fraction(1127, 1000),
    "0,500": Fraction(1, 2),
    "1234,500": Fraction(2469, 2),
    "1,2000": Fraction(6, 5),
    # Two readings
    "1,000": ("1.000", "1000"),
    "1,200": ("1.200", "1200"),
    "12,500": ("12.500", "12500"),
    "-100,000": ("100.000", "100000"),
    "1,500/2": ("1.500", "1500"),
    "0,5/1,500": ("1.500", "1500"),
    "１，０００": ("1.000", "1000"),
    # Fractions
    "9/8": Fraction(9, 8),
    "1:2": Fraction(1, 2),
    "1 : 2": Fraction(1, 2),
    "9÷8": Fraction(9, 8),
    "9∕8": Fraction(9, 8),
    "9⁄8": Fraction(9, 8),
    "9／8": Fraction(9, 8),
    "9/\u20608": Fraction(9, 8),
    "2/1.500": Fraction(4, 3),
    "½": Fraction(1, 2),
    "⅜": Fraction(3, 8),
    "1½": None,
    "1/0": None,
    # Pasted from the app and from word processors
    "1\u202f729": Fraction(1729),
    "12\u202f300,5": Fraction(24601, 2),
    "−3": Fraction(-3),
    "—3": Fraction(-3),
    "\ufeff3\u200b": Fraction(3),
    "\u00a03\u2003": Fraction(3),
    "１．５": Fraction(3, 2),
    "𝟏𝟐": Fraction(12),
    # Neither
    "": None,
    "x": None,
    "1 2": None,
    "1,000,000": None,
    "1,000.5": None,
    "1'000": None,
    "10\u202fkg": None,
    "10²": None,
    "10⁻²": None,
    "1_000": None,
    "1.2.3": None,
    "1,2,3": None,
    "1..5": None,
    "/2": None,
    "2/": None,
    "inf": None,
    "nan": None,
    "0x10": None,
    "١٢": None,
}

SCIENTIFIC: dict[str, Fraction | tuple[str, str] | None] = {
    "1e1": Fraction(10),
    "2e-1": Fraction(1, 5),
    "1,5E+2/3": Fraction(50),
    "1,500e1": ("1.500", "1500"),
    "1e400": None,
    "1e0001": None,
}
"""Numbers with an exponent, which the boxes and links read. A formula has no letter e."""

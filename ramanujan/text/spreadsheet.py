"""Tables as CSV files that a spreadsheet opens by a double click, in the language of the server.

A spreadsheet in a language with a decimal comma expects semicolons between the cells. The byte-order mark declares the
encoding UTF-8. `numpy_call` returns the line by which NumPy reads the numbers.

    a text            unchanged
    a number          12 significant digits, without a power of ten, with the decimal mark of the language
    True, False       yes, no
"""

import csv
import io
from collections.abc import Iterable
from decimal import Decimal

from ramanujan.text.numerals import DECIMAL
from ramanujan.text.translation import _

BYTE_ORDER_MARK = "\ufeff"
SEPARATOR = "," if DECIMAL == "." else ";"
DIGITS = 12
"""Significant digits of a number. More would be rounding errors."""

Cell = str | float | int | bool


def spreadsheet(rows: Iterable[Iterable[Cell]]) -> str:
    """Return a table as the content of a CSV file for a spreadsheet.

    Parameters
    ----------
    rows : the cells from left to right; rows may have different lengths

    >>> spreadsheet([["time [s]", "right"], [0.25, True], [-1e-7, False]])
    '\\ufefftime [s],right\\r\\n0.25,yes\\r\\n-0.0000001,no\\r\\n'
    """
    text = io.StringIO()
    text.write(BYTE_ORDER_MARK)
    writer = csv.writer(text, delimiter=SEPARATOR, lineterminator="\r\n")
    writer.writerows([_format_cell(cell) for cell in row] for row in rows)
    return text.getvalue()


def numpy_call(skipped: int) -> str:
    """Return the Python expression that reads the numbers of a file, whose name is in the variable `file`.

    Parameters
    ----------
    skipped : number of rows above the numbers

    >>> numpy_call(9)
    "numpy.loadtxt(file, delimiter=',', skiprows=9, encoding='utf-8')"
    """
    converters = "" if DECIMAL == "." else ", converters=lambda cell: float(cell.replace(',', '.'))"
    return f"numpy.loadtxt(file, delimiter='{SEPARATOR}', skiprows={skipped}, encoding='utf-8'{converters})"


def _format_cell(cell: Cell) -> str:
    if isinstance(cell, bool):
        return _("yes") if cell else _("no")
    if isinstance(cell, float):
        number = f"{cell:.{DIGITS}g}"
        if "e" in number:
            # Some spreadsheets read a power of ten as text.
            number = f"{Decimal(number):f}"
        return number.replace(".", DECIMAL)
    return str(cell)

"""Tables as files for a spreadsheet, in the language of the server.

A spreadsheet in a language with a decimal comma expects semicolons between the cells. The byte-order mark declares the
encoding UTF-8. Other programs read the plain CSV files of `record.table` and `lesson.class_record.write_csv`.

    a text            unchanged
    a number          15 significant digits, without a power of ten, with the decimal mark of the language
    True, False       yes, no
"""

import csv
import io
from collections.abc import Iterable
from decimal import Decimal

from ramanujan.numerals import DECIMAL
from ramanujan.translation import _

BYTE_ORDER_MARK = "\ufeff"
SEPARATOR = "," if DECIMAL == "." else ";"
# The precision of a number in a spreadsheet.
_DIGITS = 15

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


def _format_cell(cell: Cell) -> str:
    if isinstance(cell, bool):
        return _("yes") if cell else _("no")
    if isinstance(cell, float):
        number = f"{cell:.{_DIGITS}g}"
        if "e" in number:
            # Some spreadsheets read a power of ten as text.
            number = f"{Decimal(number):f}"
        return number.replace(".", DECIMAL)
    return str(cell)

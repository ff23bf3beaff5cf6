"""Numbers as a table in comma-separated values, which a spreadsheet opens and numpy reads back exactly.

Lives here: the format. Does not live here: which quantities a table has.

    # a comment line for each remark and parameter
    t [s],X [m],…            one header line: each name with its unit
    0.0,0.04,…               one line for each row

A number is written with the fewest digits that give back the very same double.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from typing import Any

import numpy as np


def csv_table(columns: Mapping[str, Any], comments: Iterable[str] = ()) -> str:
    """Return columns of equal length as comma-separated values, below lines of comment.

    Parameters
    ----------
    columns : header (a name with its unit) → the column, numbers of shape (n,)
    comments : remarks, one for each line, written after a # sign

    The first comment says how many lines numpy has to skip: `numpy.loadtxt(file, delimiter=",", skiprows=…)`.

    Raises
    ------
    ValueError : there is no column, two differ in length, one is not a row of numbers, or a text would break its line.
    """
    arrays = {header: np.asarray(column, dtype=float) for header, column in columns.items()}
    if not arrays:
        raise ValueError("columns must hold at least one column")
    for header, array in arrays.items():
        if array.ndim != 1 or array.shape != next(iter(arrays.values())).shape:
            raise ValueError(f"columns must all be rows of numbers of one length; {header!r:.60} is not")
    texts = [*comments, *arrays]
    for text in texts:
        # A comma in a comment would spread it over the cells of a spreadsheet.
        if set(text) & set(',"\r\n'):
            raise ValueError(f"a header or comment must be one line without commas and quotes, not {text!r:.60}")
    notes = texts[: len(texts) - len(arrays)]
    skipped = len(notes) + 2
    lines = [f"# numbers begin after {skipped} lines; numpy.loadtxt takes that as skiprows", *map("# {}".format, notes)]
    lines.append(",".join(arrays))
    rows = zip(*(array.tolist() for array in arrays.values()), strict=True)
    lines.extend(",".join(map(repr, row)) for row in rows)
    return "\n".join(lines) + "\n"

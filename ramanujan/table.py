"""A table of numbers as comma-separated values, which a spreadsheet opens and numpy reads back exactly.

    # a comment line for each remark and parameter
    t [s],X [m],…            one header line: each name with its unit
    0.0,0.04,…               one line for each row

A number is written with the fewest digits that give back the very same double.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping

from numpy.typing import ArrayLike

from ramanujan.translation import _
from ramanujan.validation import finite_array, instance, sequence, shown


def csv_table(columns: Mapping[str, ArrayLike], comments: Iterable[str] = ()) -> str:
    """Return columns of equal length as comma-separated values, below lines of comment.

    Parameters
    ----------
    columns : header (a name with its unit) → the column, numbers of shape (n,)
    comments : remarks, one for each line, written after a # sign

    Returns
    -------
    the table; its first line says how many lines numpy has to skip: `numpy.loadtxt(file, delimiter=",", skiprows=…)`

    Raises
    ------
    ValueError : there is no column, two differ in length, one is not a sequence of finite numbers, or a text is not a
        single line without commas and quotes.

    >>> print(csv_table({"t [s]": [0, 0.1]}, ["two times"]), end="")
    # numbers begin after 3 lines; numpy.loadtxt takes that number as skiprows
    # two times
    t [s]
    0.0
    0.1
    """
    arrays = {
        header: finite_array(f"columns[{shown(header)}]", column)
        for header, column in instance("columns", columns, Mapping).items()
    }
    if not arrays:
        raise ValueError(_("columns must hold at least one column"))
    for header, array in arrays.items():
        if array.ndim != 1 or array.shape != next(iter(arrays.values())).shape:
            sentence = _("columns must all be sequences of numbers of equal length, but {column} is not")
            raise ValueError(sentence.format(column=shown(header)))
    comments = sequence("comments", comments)
    for name, texts in (("comments", comments), ("columns", arrays)):
        for text in texts:
            # A comma in a comment would spread it over the cells of a spreadsheet.
            if not isinstance(text, str) or set(text) & set(',"') or text.splitlines() not in ([], [text]):
                sentence = _("{name} must hold single lines of text without commas and quotes, unlike {text}")
                raise ValueError(sentence.format(name=name, text=shown(text)))
    skipped = len(comments) + 2
    first = _("numbers begin after {n} lines; numpy.loadtxt takes that number as skiprows").format(n=skipped)
    comments = [first, *comments]
    lines = list(map("# {}".format, comments))
    lines.append(",".join(arrays))
    rows = zip(*(array.tolist() for array in arrays.values()), strict=True)
    lines.extend(",".join(map(repr, row)) for row in rows)
    return "\n".join(lines) + "\n"

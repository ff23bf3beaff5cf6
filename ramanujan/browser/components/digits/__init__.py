"""A slider over computed samples: two formulas, their critical steps, and the correct digits of their values."""

from collections.abc import Mapping
from typing import Any

from ramanujan.browser import modules


def mount(key: str, data: Mapping[str, Any]) -> Any:
    """Put the slider and its table on the page. A drag does not send any message.

    Parameters
    ----------
    key : Streamlit's key of the element. A new key starts the slider again.
    data : label, start : label of the slider, and number of the first sample shown
        locked : whether the slider is hidden
        head : titles of the four columns
        rows : name and formula of both formulas and of the exact value, as HTML
        all : the number of digits of a value that is right to all its digits
        samples : for each sample, its text, for each row [critical step, correct digits, wrong digits, power of ten,
            number of correct digits], and the number of its note
        notes : sentences on the samples
    """
    return modules.component("components/digits/digits")(key=key, data=dict(data))

"""Every name of Streamlit's own that our style rules and scripts use is in the scripts of Streamlit's page."""

import re
from pathlib import Path

import streamlit

from tests.browser import ROOT

_NAME = re.compile(r"data-testid[$^]?=\W?(st\w+)|\.(st[A-Z]\w+)")


def test_every_name_is_known_to_streamlit_s_page():
    page = ROOT / "ramanujan" / "browser" / "page"
    used = {
        first or second
        for path in (*page.glob("*.css"), *page.glob("*.js"))
        for first, second in _NAME.findall(path.read_text(encoding="utf-8"))
    }
    assert len(used) > 10
    scripts = (Path(streamlit.__file__).parent / "static" / "static" / "js").glob("*.js")
    known = "".join(path.read_text(encoding="utf-8") for path in scripts)
    # Some names are the beginning of a whole family.
    assert [name for name in sorted(used) if name not in known] == []

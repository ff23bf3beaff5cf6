"""Every Streamlit name that the app uses exists in Streamlit, in the files that upgrading.md lists."""

import re
from dataclasses import fields
from pathlib import Path

import streamlit
from streamlit.runtime.scriptrunner_utils.script_run_context import ScriptRunContext

from ramanujan.browser.containers import ROLES
from ramanujan.shell.parameters import PARAMETERS
from tests.checks.browser import ROOT

_NAME = re.compile(r"data-testid[$^]?=\W?(st\w+)|\.(st[A-Z]\w+)")
_INSIDE = re.compile(r"^from streamlit\.(?:proto|runtime)\b|\bst\.__file__", re.MULTILINE)
_TABLE_ROW = re.compile(r"^\| `([\w/.*]+)` \|", re.MULTILINE)
_BESIDE = re.compile(r"(components|pages)/\w+/(\w+\.css)")
"""The sheet of a component or of a page; those of the same name share a row."""
SOURCES = {
    str(path.relative_to(ROOT / "ramanujan")): path.read_text(encoding="utf-8")
    for path in (ROOT / "ramanujan").rglob("*")
    if path.suffix in {".py", ".js", ".css", ".html"}
}


def test_every_selector_matches_streamlits_page():
    used = {first or second for text in SOURCES.values() for first, second in _NAME.findall(text)}
    assert len(used) > 10
    scripts = (Path(streamlit.__file__).parent / "static" / "static" / "js").glob("*.js")
    known = "".join(path.read_text(encoding="utf-8") for path in scripts)
    # Some names are a common prefix of several names.
    assert [name for name in sorted(used) if name not in known] == []
    assert "is_history_navigation" in {field.name for field in fields(ScriptRunContext)}


def test_the_selectors_are_in_the_files_that_upgrading_lists():
    listed = _TABLE_ROW.findall((ROOT / ".github" / "upgrading.md").read_text(encoding="utf-8"))
    using = [name for name, text in SOURCES.items() if _NAME.search(text) or _INSIDE.search(text)]
    assert listed == sorted({_BESIDE.sub(r"\1/*/\2", name) for name in using})


def test_every_role_has_rules_and_every_rule_has_a_role_or_a_key():
    sheets = "".join(text for name, text in SOURCES.items() if name.endswith(".css"))
    others = "".join(text for name, text in SOURCES.items() if name.endswith((".py", ".js")))
    selected = set(re.findall(r"st-key-([a-z]+)-[a-z]*", sheets))
    # Elements without a visible part are not containers.
    assert selected == {*ROLES, "unseen"}
    for role in ROLES:
        assert f'container("{role}", ' in others


def test_the_first_track_of_m_prime_has_the_range_of_its_parameters():
    m, m_prime = PARAMETERS["m"], PARAMETERS["m_prime"]
    whole = m_prime.most - m_prime.least
    shown = m_prime.shown_ratio * m.default - m_prime.least
    assert f"var(--zoom, {whole:g} / {shown:g})" in SOURCES["browser/streamlit.css"]

"""Containers in a role. The style sheets have one rule for all containers in a role, whatever page they are on.

A container has the key ROLE-NAME. Streamlit turns the key into a class, and a rule selects it by
`[class*="st-key-ROLE-"]`. A container whose rules apply to no other has a plain key.
"""

from typing import Any

import streamlit as st

ROLES = {
    "click": "a hint about clicks, which is not printed",
    "columns": "a text and its figure: side by side, or one below the other on a narrow screen",
    "equations": "equations for a wide screen, hidden on a phone",
    "lead": "a question, its options and the verdict, above the machine on a phone",
    "list": "a long list, in several columns if they fit",
    "narrow": "equations for a phone, hidden on a wide screen",
    "observed": "the machines of a stop, a task or a race",
    "question": "a question of the worksheet, with letters at its options",
    "route": "the steps of a derivation, beside the machine",
    "slide": "a slide of the projector view",
    "step": "one step of a lecture, hidden until turn.js shows it",
    "table": "a table that scrolls in its own box",
    "wall": "the machines on the wall of a class",
}
"""Role → description."""


def container(role: str, name: str, **options: Any) -> Any:
    """Return a container in a role.

    Parameters
    ----------
    role : one of ROLES
    name : name of the container, unique for this role and page
    options : arguments of `st.container`
    """
    if role not in ROLES:
        raise ValueError(role)
    return st.container(key=f"{role}-{name}", **options)

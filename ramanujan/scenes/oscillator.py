"""Page 1: the machine in motion, its frequency on the curve, and the derivation in six steps."""

from __future__ import annotations

import math

import streamlit as st

from ramanujan import page, stage
from ramanujan.scenes import controls, look, view
from ramanujan.scenes.cached import oscillator as cached
from ramanujan.words import _


def take_clicked(point: dict[str, float]) -> None:
    """Take the mass ratio of the clicked point: exactly that of a mark if one lies there, else with round masses."""
    marks = (base.equal.ratio, base.unit.ratio)
    mark = next((mark for mark in marks if math.isclose(point["x"], mark, rel_tol=0.02)), None)
    if mark is None:
        controls.take_ratio(point["x"], digits=3)
    else:
        controls.take_ratio(mark)


def opening() -> None:
    """Say what this is, what it asks and what to do first; beside it, the way into the lesson."""
    words, lesson = st.container(key="opening").columns([4, 1], vertical_alignment="bottom")
    with words:
        st.title("Ramanujan’s oscillator", anchor=False)
        first = _("Drag the slab and let go.")
        if not view.hides("clocks"):
            first = _("Drag the slab and let go. Then move m′ until both clock hands turn together.")
        question = _("When does this machine of five bodies keep time with a plain mass on the same spring?")
        st.markdown(f"**{question}** {first}")
    with lesson:
        view.way("ramanujan/scenes/lesson.py", _("Take the lesson"), ":material/school:")


def scene() -> None:
    """Draw the machine in motion."""
    stage.mount(
        stage.payload(machine, controls.compression()),
        name="oscillator",
        limits=controls.limits("compression"),
        watch=controls.WATCH,
        hide=view.on_stage(),
        on_released=controls.set_compression,
    )


def curve() -> None:
    """Draw Ω²m/k over the mass ratio, where a click builds a machine."""
    st.subheader("When is it in step with √(k/m)?", anchor=False)
    page.ring("oscillator")
    st.plotly_chart(
        cached.figure(look.theme()),
        key="curve",
        theme=None,
        config={"displayModeBar": False},
        # What changes with the machine is said by the ring: so the figure is sent to a page only once.
        alt=_("Ω²m/k over the mass ratio ε: it falls from {light} to {heavy}.").format(
            light=base.light_label, heavy=base.heavy_label.replace("<br>", " ")
        ),
    )
    page.pick("curve", take_clicked)
    st.caption("Click on the curve to build the machine with that mass ratio.")


def six_steps() -> None:
    """Draw the derivation in short, with the present numbers unless these are hidden."""
    st.subheader("In six steps", anchor=False)
    present = None if view.hides("numbers") else (machine.m, machine.m_prime, machine.k)
    if present:
        st.caption(f"Each step in symbols, then with numbers. {cached.numbers_stated(*present)}")
    # One text: each element of a page costs the server a message.
    st.container(key="steps").markdown(
        "\n\n".join(
            f"##### {number}. {step.heading}\n{step.reason}\n\n$$\n{step.equations}\n$$"
            for number, step in enumerate(cached.summary(present), start=1)
        )
    )
    st.page_link(
        "ramanujan/scenes/derivation.py", label="The whole derivation, by five routes", icon=":material/function:"
    )


machine, base = controls.oscillator(), cached.curve()
opening()
scene()
if not view.hides("curve"):
    curve()
if not view.hides("steps"):
    six_steps()

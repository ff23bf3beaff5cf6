"""Page 1: the machine in motion, its frequency on the curve, and the derivation in six steps."""

from __future__ import annotations

import math

import streamlit as st

from ramanujan import page, stage
from ramanujan.scenes import controls, look
from ramanujan.scenes.cached import oscillator as cached


def take_clicked(point: dict[str, float]) -> None:
    """Take the mass ratio of the clicked point: exactly that of a mark if one lies there, else with round masses."""
    marks = (base.equal.ratio, base.unit.ratio)
    mark = next((mark for mark in marks if math.isclose(point["x"], mark, rel_tol=0.02)), None)
    if mark is None:
        controls.take_ratio(point["x"], digits=3)
    else:
        controls.take_ratio(mark)


machine, base = controls.oscillator(), cached.curve()

st.title("Ramanujan’s oscillator", anchor=False)
stage.mount(
    stage.payload(machine, controls.compression()),
    name="oscillator",
    limits=controls.limits("compression"),
    watch=controls.WATCH,
    on_released=controls.set_compression,
)

st.subheader("When is it in step with √(k/m)?", anchor=False)
page.ring("oscillator")
st.plotly_chart(
    cached.figure(look.theme()),
    key="curve",
    theme=None,
    config={"displayModeBar": False},
    # What changes with the machine is said by the ring: so the figure is sent to a page only once.
    alt=f"Ω²m/k over the mass ratio ε: it falls from {base.light_label} to {base.heavy_label.replace('<br>', ' ')}.",
)
page.pick("curve", take_clicked)
st.caption("Click on the curve to build the machine with that mass ratio.")

st.subheader("In six steps", anchor=False)
st.caption(f"Each step in symbols, then with numbers. {cached.numbers_stated(machine.m, machine.m_prime, machine.k)}")
# One text: each element of a page costs the server a message.
st.container(key="steps").markdown(
    "\n\n".join(
        f"##### {number}. {step.heading}\n{step.reason}\n\n$$\n{step.equations}\n$$"
        for number, step in enumerate(cached.summary(machine.m, machine.m_prime, machine.k), start=1)
    )
)
st.page_link("ramanujan/scenes/derivation.py", label="The whole derivation, by five routes", icon=":material/function:")

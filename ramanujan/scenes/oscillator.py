"""Page 1: the machine in motion, its frequency on the curve, and the derivation in six steps."""

from __future__ import annotations

import math

import streamlit as st

from ramanujan import stage
from ramanujan.scenes import controls, look
from ramanujan.scenes.cached import oscillator as cached
from ramanujan.scenes.ring import ring


def ratio_clicked() -> None:
    """Take the mass ratio of the point that was clicked on the curve, exactly that of a mark if it lies under one."""
    points = st.session_state["curve"].selection.points
    if points:
        ratio = points[0]["x"]
        marks = (base.equal.ratio, base.unit.ratio)
        controls.take_ratio(
            next((mark for mark in marks if math.isclose(ratio, mark, rel_tol=0.02)), float(f"{ratio:.4g}"))
        )


machine, base = controls.oscillator(), cached.curve()

st.title("Ramanujan’s oscillator", anchor=False)
stage.mount(
    stage.payload(machine, controls.compression()),
    limits=controls.limits("compression"),
    watch=controls.WATCH,
    on_released=controls.set_compression,
)

st.subheader("When is it in step with √(k/m)?", anchor=False)
ring()
st.plotly_chart(
    cached.figure(look.theme()),
    key="curve",
    on_select=ratio_clicked,
    selection_mode="points",
    theme=None,
    config={"displayModeBar": False},
    # What changes with the machine is said by the ring: so the figure is sent to a page only once.
    alt=f"Ω²m/k over the mass ratio ε: it falls from {base.light_label} to {base.heavy_label.replace('<br>', ' ')}.",
)
st.caption("Click on the curve to build the machine with that mass ratio.")

st.subheader("In six steps", anchor=False)
st.caption(
    f"In symbols, then with your m = {machine.m:.7g} kg, m′ = {machine.m_prime:.7g} kg and k = {machine.k:.7g} N/m."
)
# One text: each element of a page costs the server a message.
st.container(key="steps").markdown(
    "\n\n".join(
        f"##### {number}. {step.heading}\n{step.reason}\n\n$$\n{step.equations}\n$$"
        for number, step in enumerate(cached.summary(machine.m, machine.m_prime, machine.k), start=1)
    )
)
st.page_link("ramanujan/scenes/derivation.py", label="The whole derivation, by five routes", icon=":material/function:")

"""One stop of the lesson on the page: predict, observe, explain.

Before the prediction the stage gets neither what `stop.hides` names nor the samples of a computed motion, and the words
of the explanation are not worked out.
"""

from __future__ import annotations

import string
from functools import partial

import streamlit as st

from ramanujan import page, stage
from ramanujan.contact import drawn_spacing, first_to_slip
from ramanujan.lesson import Run, Stop
from ramanujan.number_theory import BODIES, BodyChoice
from ramanujan.scenes import classroom, controls, progress
from ramanujan.words import _, ngettext

_PLACES = ("hoop", "cylinder", "top")


def draw(stop: Stop, number: int) -> None:
    """Draw a stop, the one of that number."""
    chosen = progress.predictions().get(stop.id)
    predicted = chosen is not None
    st.title(f"{number}. {stop.heading}", anchor=False)
    words, picture = st.columns([1, 1] if stop.size == "small" else [2, 3], gap="medium")
    with words:
        st.markdown(stop.question)
        solved = classroom.panel(stop)
        if solved is not None:
            # A lecturer's page predicts with the class, and shows nothing before the class has seen it.
            predicted = solved
            if solved:
                why(stop)
        elif chosen is None:
            ask(stop)
        else:
            explain(stop, chosen)
    with picture:
        observe(stop, predicted)


def ask(stop: Stop) -> None:
    """Draw the options and the hints."""
    st.markdown(_("**Predict.** Choose before you see it."))
    with st.container(key="options", gap="small"):
        for option in stop.options:
            st.button(
                option.label,
                key=f"option_{stop.id}_{option.id}",
                on_click=partial(progress.predict, stop.id, option.id),
                width="stretch",
            )
    hints(stop.id, stop.hints)


def explain(stop: Stop, chosen: str) -> None:
    """Say whether the prediction was right, which option is, and why."""
    answer = stop.answer()
    right = stop.option(answer).label
    if chosen == answer:
        said = _("Your prediction was right.")
        st.markdown(f":green[:material/check_circle: **{said}**]  \n{right}")
    else:
        said = _("You predicted something else.")
        st.markdown(f":red[:material/cancel: **{said}**]  \n{stop.option(chosen).label}")
        st.markdown(f":green[:material/check_circle: **{_('Right:')}**]  \n{right}")
    # With the option that was clicked the focus has gone: who cannot see the page is told here.
    page.feed(f"told_{stop.id}_feed", {"say": {"sentence": f"{said} {right}", "urgent": True}})
    why(stop)
    st.button(
        _("Predict again"), key=f"again_{stop.id}", on_click=partial(progress.predict, stop.id, None), type="tertiary"
    )


def why(stop: Stop) -> None:
    """Say why the right option is right, and where all of it is seen."""
    st.markdown(f"**{_('Why')}**  \n{stop.explanation()}")
    st.page_link(
        f"ramanujan/scenes/{stop.page}.py",
        label=stop.link_label,
        icon=":material/open_in_full:",
        query_params={**_in_link(stop), **stop.link},
    )


def hints(name: str, sentences: tuple[str, ...]) -> None:
    """Draw the hints that have been asked for, and a button for the next one."""
    key = f"hints_shown_{name}"
    shown = st.session_state.get(key, 0)
    for sentence in sentences[:shown]:
        st.markdown(f":material/lightbulb: {sentence}")
    left = len(sentences) - shown
    if left > 0:
        label = ngettext("Hint ({n} left)", "Hint ({n} left)", left).format(n=left)
        st.button(label, key=f"hint_{name}", on_click=partial(_show_hint, key, shown + 1), type="tertiary")


def observe(stop: Stop, predicted: bool) -> None:
    """Draw the machine, or after the prediction all machines of the stop, on one clock."""
    runs = stop.runs if predicted else stop.runs[:1]
    several = len(stop.runs) > 1
    with st.container(key="observed"):
        for number, run in enumerate(runs):
            key = f"stage_{stop.id}_{number}"
            stage.mount(
                payload(run, predicted),
                # Where it is released belongs to the stop: the slab cannot be dragged.
                limits=controls.limits("compression") if several else (run.compression, run.compression),
                watch={},
                key=key,
                clock=f"stop_{stop.id}",
                layers=stop.layers,
                compact=several,
                dials=stop.dials,
                narrow=True,
                label=run.label if several and predicted else None,
                hide=() if predicted else stop.hides,
            )


def payload(run: Run, predicted: bool) -> dict[str, object]:
    """Return what the stage is sent of a run; before the prediction, the released machine alone."""
    machine, choice = run.machine, BodyChoice(*run.bodies)
    slips = run.slipping and predicted
    return stage.payload(
        machine,
        run.compression,
        initial=run.initial() if run.initial and predicted else None,
        shape_factors={place: float(BODIES[body]) for place, body in zip(_PLACES, run.bodies, strict=True)},
        samples=run.samples() if run.samples and predicted else None,
        slipping=first_to_slip(machine, run.compression, drawn_spacing(machine.radius)) if slips else None,
        unity=f"1 ↔ √{choice.discriminant}" if predicted and choice != BodyChoice() else None,
    )


def _show_hint(key: str, count: int) -> None:
    st.session_state[key] = count


def _in_link(stop: Stop) -> dict[str, str]:
    """Return the stop's machine as an address says it."""
    machine = stop.machine
    values = {"m": machine.m, "m_prime": machine.m_prime, "k": machine.k, "radius": machine.radius}
    values["compression"] = stop.compression
    return {key: repr(_in_units(key, value)) for key, value in values.items()}


def _in_units(key: str, value: float) -> float:
    """Return an SI value in the unit of its slider; ε* keeps all of its digits."""
    scale = controls.CONTROLS[key].scale
    return value if scale == 1 else round(value / scale, 10)


def plain(text: str) -> str:
    """Return text such that Markdown shows it as it is."""
    return "".join(f"\\{character}" if character in string.punctuation else character for character in text)

"""One stop of the lesson on the page: predict, observe, explain.

The sliders have the values of the stop’s machine, so that a reader can change it afterwards. Before the prediction the
stage receives neither the parts in `stop.hides` nor a computed motion. The explanation is computed afterwards.
"""

import math
from collections.abc import Callable
from contextlib import AbstractContextManager
from functools import partial
from typing import Any

import streamlit as st

from ramanujan import Oscillator, drawn_spacing
from ramanujan.browser import stage, topics
from ramanujan.browser.components import moment
from ramanujan.browser.containers import container
from ramanujan.lesson import Run, Stop
from ramanujan.number_theory import BODIES
from ramanujan.pages.classroom import shared_elements
from ramanujan.pages.classroom.shared_elements import add_letters, last_sentence
from ramanujan.physics.contact import first_to_slip
from ramanujan.shell import class_session, display_mode, messages, progress, sidebar, stages, widgets
from ramanujan.shell.display_mode import slide
from ramanujan.shell.menu import PAGES
from ramanujan.shell.parameters import PARAMETERS
from ramanujan.text.translation import _

_PLACES = ("hoop", "cylinder", "top")
"""Names of the three rollers in the data of a stage: left, right and top, whatever their shape."""
_SEVERAL = {2: "several-2", 3: "several-3"}
"""Number of machines → their arrangement in the style sheets."""
_LOADED = "lesson_loaded"
"""Session state: the stop whose machine was last loaded into the sliders, and whether its machine was running."""
_OBSERVED = "lesson_observed"
"""Session state: the stop whose machine the reader has just started. Its result waits for the question's moment."""


def load_machine(stop: Stop, running: bool) -> None:
    """Set the sliders to the machine of a stop in the next run, and release it."""
    st.session_state[_LOADED] = (stop.id, running)
    stages.release()
    sidebar.request_machine(choose_machine(stop, running), stop.compression)


def load_new_machine(stop: Stop, running: bool) -> None:
    """Set the sliders to the machine of a newly opened stop, unless the link contains another machine."""
    if st.session_state.get(_LOADED) == (stop.id, running):
        return
    st.session_state[_LOADED] = (stop.id, running)
    if not (sidebar.has_linked_machine() or sidebar.shows_machine(choose_machine(stop, running), stop.compression)):
        load_machine(stop, running)
        messages.run_again()


def choose_machine(stop: Stop, running: bool) -> Oscillator:
    """Return the machine of a stop's question, or the one that runs after the prediction."""
    return stop.final_machine if running else stop.machine


def is_running(phase: str) -> bool:
    """Return whether the machine runs: the reader has made a prediction and started the machine."""
    return phase in (progress.MISSED, progress.ANSWERED)


def set_prediction(stop: Stop, option: str | None, phase: str) -> None:
    """Callback: make, delete or advance a prediction. A machine that already runs goes on."""
    was_running = is_running(progress.read_prediction(stop)[1])
    progress.predict(stop, option, phase)
    st.session_state[_OBSERVED] = stop.id if stop.periods and not was_running else None
    if not (was_running and is_running(phase)):
        load_machine(stop, is_running(phase))


def draw(
    stop: Stop, number: int, chosen: str | None, phase: str, *, draw_desk: Callable[[], None] | None = None
) -> None:
    """Draw a stop.

    Parameters
    ----------
    stop : the stop
    number : its number in this lesson
    chosen : the option that the reader has selected, or None
    phase : the phase of the stop (see `progress`)
    draw_desk : function that draws the lecturer's desk of a class, instead of options and verdict
    """
    running = is_running(phase)
    is_brief = running and (draw_desk is not None or display_mode.is_projector())
    # At the desk in the projector view, machine and reason have their own slide, because the votes need much room.
    has_own_slide = display_mode.is_projector() and draw_desk is not None and (running or not stop.exhibit)
    with slide("question", stop.heading):
        if not has_own_slide:
            words, picture = draw_containers(stop)
        else:
            words = st.container()
        with words, container("lead", "question"):
            st.title(f"{number}. {stop.heading}", anchor=False)
            # Votes and reason need the room on a desk and a slide; the style sheet also hides the first sentences on a
            # phone.
            question = last_sentence(stop.question)
            setting = stop.question.removesuffix(question)
            st.markdown(question if is_brief else f"{setting}\n\n{question}" if running else stop.question)
        with words:
            if draw_desk:
                draw_desk()
            else:
                _draw_answers(stop, chosen, phase)
    if has_own_slide:
        with slide("machine", _("The machine")):
            words, picture = draw_containers(stop)
    with words:
        if phase == progress.ANSWERED:
            with st.container(key=_result_key(stop, "explanation")):
                draw_explanation(stop)
    load_new_machine(stop, running)
    # A machine with a label does not follow the sliders. The desk needs its room for the votes.
    if not (stop.exhibit or stop.runs[0].label or draw_desk or display_mode.is_projector()):
        with words, st.container(key="lesson_caption"):
            st.markdown(f":small[{_write_caption(stop, running)}]")
    with picture:
        # A message of the desk's stage reruns only this fragment.
        st.fragment(draw_observation)(stop, running)


def _draw_answers(stop: Stop, chosen: str | None, phase: str) -> None:
    """Draw the options as buttons, or after a choice as a list with the verdict."""
    if chosen is None:
        draw_options(stop)
    else:
        draw_verdict(stop, chosen, phase)


def draw_observation(stop: Stop, running: bool, fixed: bool = False) -> None:
    """Draw the exhibit of a stop, if any, and its machines.

    Parameters
    ----------
    stop : the stop
    running : whether the machine runs, as `is_running` returns
    fixed : whether the slab cannot be dragged
    """
    if stop.exhibit:
        st.markdown(stop.outcome if running and stop.outcome else stop.exhibit)
    with container("observed", _arrangement(stop, running)):
        draw_machines(stop, running, fixed)


def draw_containers(stop: Stop) -> tuple[AbstractContextManager[Any], ...]:
    """Return the containers for the words, and for the picture beside them."""
    if display_mode.is_projector():
        # A clock below the machine needs much height, so words are beside it in longer lines.
        picture, words = display_mode.picture_and_words(2.3 if stop.shows_dials or stop.exhibit else 2.5)
    else:
        # Without a clock below it, the machine is as wide as the words allow.
        widths = [5, 6] if stop.shows_dials or stop.exhibit else [2, 3]
        words, picture = st.container(key=None if stop.exhibit else "beside").columns(widths, gap="medium")
    return words, picture


def _arrangement(stop: Stop, running: bool) -> str:
    """Return the key with which the style sheets select the size of the picture."""
    if len(stop.runs) > 1:
        return _SEVERAL[len(stop.runs)] if running else f"first-of-{len(stop.runs)}"
    # Beside dials or an exhibit, the machine has only a part of the height.
    if stop.shows_dials or stop.exhibit:
        return "part"
    return "energy" if "energy" in stop.layers else "one"


def draw_options(stop: Stop) -> None:
    """Draw the options and the hints."""
    with container("lead", "options", gap="xsmall"):
        st.markdown(_("**Predict** before you see it:"))
        with st.container(key="options", gap="xsmall"):
            for option, label in add_letters(stop).items():
                st.button(
                    label,
                    key=f"option_{stop.id}_{option}",
                    on_click=partial(set_prediction, stop, option, progress.PREDICTED),
                    width="stretch",
                )
    widgets.draw_hints(stop.id, [widgets.escape(hint) for hint in stop.hints])


def draw_verdict(stop: Stop, chosen: str, phase: str) -> None:
    """Draw all options with the prediction marked, after the run a verdict on it, and on request the right answer."""
    is_right = chosen == stop.right
    is_answered = phase == progress.ANSWERED
    # On a phone both parts are above the machine.
    with container("lead", "marked"), st.container(key=_result_key(stop, "marked")):
        shared_elements.draw_options(_mark_options(stop, chosen, is_answered))
    with container("lead", "verdict"):
        if phase == progress.PREDICTED:
            _draw_moves(stop, chosen, stop.observation, progress.ANSWERED if is_right else progress.MISSED)
            return
        with st.container(key="outcome"):
            if _is_observed(stop):
                with st.container(key="watch"):
                    watch = _("The result follows after {n} periods, or when you pause.")
                    st.markdown(watch.format(n=stop.periods))
            with st.container(key=_result_key(stop, "result")):
                sentence = _draw_result(stop, chosen, is_answered)
    # The clicked button has disappeared with the focus, so announce the result to a screen reader.
    topics.publish(f"verdict_{stop.id}", {"announce": {"sentence": sentence.replace("*", ""), "urgent": True}})


def _draw_result(stop: Stop, chosen: str, is_answered: bool) -> str:
    """Draw the verdict on a prediction, and return its last sentence. A wrong one can be made again."""
    if chosen == stop.right:
        sentence = _("Your prediction was right.")
        st.markdown(f":green[**{sentence}**]")
        return sentence
    # TRANSLATORS: {option} is a sentence, and {reply} begins with its consequence: Then …
    template = _("**Not right.** You predicted: *{option}* {reply}")
    # A sentence follows each option, and some have no full stop.
    option = stop.options[chosen].removesuffix(".") + "."
    sentence = template.format(option=option, reply=stop.reply(chosen))
    # A slide has shown the reply, and its room is for the explanation.
    st.markdown(_("**Not right.**") if is_answered and display_mode.is_projector() else sentence)
    if is_answered:
        return _("Right answer: {label}").format(label=add_letters(stop)[stop.right])
    _draw_moves(stop, chosen, _("Show the answer"), progress.ANSWERED)
    return sentence


def _is_observed(stop: Stop) -> bool:
    """Return whether the reader has just started the machine of a question about its hands; a link has not."""
    return st.session_state.get(_OBSERVED) == stop.id


def _result_key(stop: Stop, name: str) -> str:
    """Return the key of a part of the result. The style sheet hides a part that waits while the hands are observed."""
    return f"{name}_waits" if _is_observed(stop) else name


def _mark_options(stop: Stop, chosen: str, is_answered: bool) -> dict[str, str]:
    """Return option → label, with the prediction and in the end the right answer marked."""
    labels = add_letters(stop)
    labels[chosen] = _("**{label}** –\u00a0*your\u00a0prediction*").format(label=labels[chosen])
    if is_answered and chosen == stop.right:
        labels[chosen] = f":green[:material/check_circle:] {labels[chosen]}"
    elif is_answered:
        right = _("**{label}** –\u00a0*right\u00a0answer*").format(label=labels[stop.right])
        labels[stop.right] = f":green[:material/check_circle:] {right}"
    return labels


def _draw_moves(stop: Stop, chosen: str, label: str, phase: str) -> None:
    """Draw a button that continues with the next phase, and a button that reopens the options."""
    with st.container(horizontal=True, gap="small"):
        st.button(label, key=f"on_{stop.id}", type="primary", on_click=partial(set_prediction, stop, chosen, phase))
        st.button(
            _("Predict again"), key=f"again_{stop.id}", on_click=partial(set_prediction, stop, None, progress.ASKED)
        )


def draw_explanation(stop: Stop) -> None:
    """Explain the right option, and link to the page with the details."""
    if stop.periods and stop.shows_dials and not display_mode.is_projector():
        _draw_hands_button(stop)
    st.markdown(stop.explanation())
    label, page, query = stop.onward
    if not (display_mode.is_projector() or class_session.lecturer_key()):
        st.page_link(PAGES[page].file, label=label, icon=":material/open_in_full:", query_params=dict(query))


def _draw_hands_button(stop: Stop) -> None:
    """Draw a button that sets both hands to the moment of the question."""
    machine = sidebar.oscillator()
    time = stop.periods * 2 * math.pi * math.sqrt(machine.m / machine.k)
    label = _("Show the hands after {n} periods").format(n=stop.periods)
    moment.mount(f"stage_{stop.id}_0", time, label)


def draw_machines(stop: Stop, running: bool, fixed: bool) -> None:
    """Draw the machine of the sliders, or after the prediction all machines of the stop with a common clock."""
    has_several = len(stop.runs) > 1
    hidden = {*stop.hides, *stage.LAYERS}
    if running:
        hidden = set(stage.LAYERS).difference(stop.layers)
    if not stop.shows_dials:
        hidden.add("plain")
    # A machine with a label belongs to the stop. One without a label follows the sliders.
    is_labelled = bool(stop.runs[0].label)
    options: dict[str, Any] = {}
    if is_labelled:
        options["watch"] = {}
    if fixed or is_labelled:
        # Equal limits of x₀ fix the slab.
        _least, most = stages.LIMITS
        options["limits"] = most, most
    if class_session.lecturer_key():
        options["on_view"] = partial(class_session.send_view, stop)
    for number, run in enumerate(stop.runs if running else stop.runs[:1]):
        machine = run.machine if is_labelled else sidebar.oscillator()
        compression = run.compression if is_labelled else sidebar.compression()
        stages.mount(
            make_payload(run, machine, compression, running),
            key=f"stage_{stop.id}_{number}",
            clock=f"stop_{stop.id}",
            layers=stop.layers,
            compact=has_several,
            dials=stop.shows_dials,
            narrow=True,
            rest_after=stop.periods or None,
            label=run.label if running or not has_several else None,
            largest_radius=max(run.machine.radius for run in stop.runs) if running and has_several else None,
            hide=hidden,
            **options,
        )


def make_payload(run: Run, machine: Oscillator, compression: float, running: bool) -> dict[str, object]:
    """Return the data of a run for the stage; before the prediction, only the machine at release."""
    slipping = None
    if run.slipping and running:
        slipping = first_to_slip(machine, compression, drawn_spacing(machine.radius))
    return stage.payload(
        machine,
        compression,
        initial=run.initial,
        shape_factors={place: float(BODIES[body]) for place, body in zip(_PLACES, run.bodies, strict=True)},
        samples=run.samples() if run.samples and running else None,
        most_energy=run.most_energy() if run.most_energy and running else None,
        slipping=slipping,
    )


def _write_caption(stop: Stop, running: bool) -> str:
    """Return the caption with the masses and the stiffness of the machine."""
    machine = choose_machine(stop, running)
    if not sidebar.shows_machine(machine, stop.compression):
        # TRANSLATORS: {machine} is a list such as: m = 1 kg, m′ = 2 kg, k = 10 N/m.
        return _("You have changed the machine. The question is about {machine}.").format(
            machine=_write_machine(machine)
        )
    # TRANSLATORS: {machine} is a list such as: m = 1 kg, m′ = 2 kg, k = 10 N/m.
    sentence = _("This machine has {machine}.") if running else _("The machine: {machine}.")
    return sentence.format(machine=_write_machine(machine))


def _write_machine(machine: Oscillator) -> str:
    values = {"m": machine.m, "m_prime": machine.m_prime, "k": machine.k}
    return ", ".join(PARAMETERS[key].equation(value) for key, value in values.items())

"""What several screens of a class draw alike: how it has voted, the right answer, who is there, a QR code."""

from collections import Counter
from collections.abc import Mapping

import segno
import streamlit as st

from ramanujan import lesson
from ramanujan.lesson.classes import ClassError, Question, Seats, Vote, shared
from ramanujan.lesson.stop import Stop
from ramanujan.numerals import quantity
from ramanujan.translation import _, ngettext


def show(access: str, stop: Stop, vote: Vote, solved: bool, chosen: str | None = None, alone: bool = False) -> None:
    """Draw the result of a question.

    Parameters
    ----------
    access : the class's code
    stop : the question
    vote : the last one
    solved : whether to say which answer is right, and how many have found it
    chosen : a student's own answer in the last vote
    alone : show only how many have found the right answer
    """
    try:
        all_votes, changes = _result(access, stop.id, vote)
    except ClassError as error:
        st.warning(str(error))
        return
    with st.container(key="class_result"):
        if solved and (said := _changes(changes)):
            with st.container(key="class_changes"):
                st.markdown(said)
        right = stop.right if solved else None
        for option, text in stop.options.items():
            if not alone:
                label, *places = st.columns([3, *(2 for _vote in all_votes)], gap="small")
                label.markdown(_label(text, option == right, option == chosen))
            elif option == right:
                places = st.columns(len(all_votes), gap="small")
            else:
                continue
            for number, (place, votes) in enumerate(zip(places, all_votes, strict=True)):
                total = sum(votes.values())
                share = votes[option] / total if total else 0.0
                place.progress(share, _share(number, len(all_votes), share, votes[option], total))


@st.cache_data(show_spinner=False, max_entries=256)
def _result(access: str, stop: str, vote: Vote) -> tuple[list[Mapping[str, int]], Counter[tuple[bool, bool]]]:
    """Return the votes on a question, option → number, and the changes; what is revealed stays as it is."""
    votes = [shared().distribution(access, stop, Vote(vote.asking, number)) for number in range(1, vote.number + 1)]
    right = lesson.stop(stop).right
    return votes, shared().changes(access, stop, right, vote.asking) if vote.is_second else Counter()


def _label(label: str, right: bool, own: bool) -> str:
    if right and own:
        return _(":green[:material/check_circle:] **{label}** – This is right, and it was your answer.").format(
            label=label
        )
    if right:
        return _(":green[:material/check_circle:] **{label}** – This is right.").format(label=label)
    if own:
        return _("{label} – *This was your answer.*").format(label=label)
    return label


def _share(number: int, votes: int, share: float, people: int, total: int) -> str:
    """Return what stands at a bar: which vote it is, if there were two, and its share."""
    one_of_two = (_("First vote: {people} of {total}, {share}"), _("Second vote: {people} of {total}, {share}"))
    words = one_of_two[number] if votes > 1 else _("{people} of {total}, {share}")
    return words.format(people=people, total=total, share=quantity(round(100 * share), "%"))


def _changes(changes: Counter[tuple[bool, bool]]) -> str:
    """Return how many have changed their answers, a sentence for each kind of change; nothing if nobody voted twice."""
    if not changes:
        return ""
    up, down, right = (changes[each] for each in ((False, True), (True, False), (True, True)))
    to_right = ngettext(
        "**{n} student changed from a wrong answer to the right one.**",
        "**{n} students changed from a wrong answer to the right one.**",
        up,
    )
    to_wrong = ngettext(
        "{n} student changed from the right answer to a wrong one.",
        "{n} students changed from the right answer to a wrong one.",
        down,
    )
    stayed = ngettext("{n} student was right both times.", "{n} students were right both times.", right)
    sentences = ((to_right, up), (to_wrong, down), (stayed, right))
    return " ".join(sentence.format(n=n) for sentence, n in sentences if n or sentence == to_right)


def explain(stop: Stop, chosen: str | None = None) -> None:
    """Name the right answer and its reason; whoever has chosen another one reads a word on that first."""
    if chosen and chosen != stop.right:
        st.markdown(stop.reply(chosen))
    st.markdown(f":green[:material/check_circle:] **{stop.options[stop.right]}**")
    st.markdown(stop.explanation())


def answered(now: Question) -> str:
    """Return how many of those present have answered, as a sentence."""
    numbers = {"answered": now.answered, "present": now.present}
    if now.vote.is_second:
        return ngettext(
            "Second vote: {answered} of {present} here has answered.",
            "Second vote: {answered} of {present} here have answered.",
            now.present,
        ).format(**numbers)
    return ngettext(
        "{answered} of {present} here has answered.", "{answered} of {present} here have answered.", now.present
    ).format(**numbers)


def joined(people: int) -> str:
    """Return how many have joined, as a sentence."""
    return ngettext("{n} student has joined.", "{n} students have joined.", people).format(n=people)


def lately(seats: Seats) -> str:
    """Return how many have joined in the last minute, as a sentence; nothing if nobody has."""
    said = ngettext("{n} student joined in the last minute.", "{n} students joined in the last minute.", seats.lately)
    return said.format(n=seats.lately) if seats.lately else ""


def taken(seats: Seats) -> str:
    """Return how many seats there are, and how many of them are empty, as sentences."""
    said = ngettext("{n} seat is taken. Empty: {empty}.", "{n} seats are taken. Empty: {empty}.", seats.taken)
    return f"{said.format(n=seats.taken, empty=seats.taken - seats.present)} {lately(seats)}"


def qr_code(address: str) -> None:
    """Draw an address as a QR code."""
    st.image(segno.make(address, micro=False).svg_inline(scale=8, border=3, light="white"), width="stretch")

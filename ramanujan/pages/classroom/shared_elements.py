"""Elements that several screens of a class share: votes, right answer, results, attendance, QR code."""

import re
import string
from collections import Counter
from collections.abc import Mapping, Sequence
from typing import NamedTuple

import segno
import streamlit as st
from streamlit.delta_generator import DeltaGenerator

from ramanujan.classroom.results import find_stop
from ramanujan.classroom.rules import ClassError, Vote, shared
from ramanujan.classroom.states import ClassView
from ramanujan.lesson.stop import Stop
from ramanujan.shell import address, local_time, widgets
from ramanujan.text.numerals import quantity
from ramanujan.text.translation import _, ngettext

RESULTS_HEADING = _("What the class has learned")
MISTAKE = _("**You may have thought:** *{label}* {reply}")


class _Result(NamedTuple):
    """The result of each vote (option → number of votes), and how answers changed between the two votes.

    The key of a change is whether the first answer was right, and whether the second one was.
    """

    votes: list[Counter[str]]
    changes: Counter[tuple[bool, bool]]


def add_letters(stop: Stop) -> dict[str, str]:
    """Return option → label after a letter, such as “A. It is faster.”, so that a class can speak about the options."""
    letters = dict(zip(stop.options, string.ascii_uppercase, strict=False))
    return {option: f"{letters[option]}. {label}" for option, label in stop.options.items()}


def last_sentence(question: str) -> str:
    """Return the last sentence of a question, which recalls it beside the running machine."""
    return re.split(r"(?<=[.:?!]) ", question)[-1]


def draw_options(labels: Mapping[str, str]) -> None:
    """Draw the options of a question as a list. Each label begins with its letter, so it needs no other mark."""
    with st.container(key="class_options"):
        st.markdown("\n".join(f"- {label}" for label in labels.values()))


def show(code: str, stop: Stop, vote: Vote, is_solved: bool, chosen: str | None = None) -> None:
    """Draw the result of a question.

    Parameters
    ----------
    code : code of the class
    stop : stop with the question
    vote : the last vote
    is_solved : whether to show the right answer and its number of votes
    chosen : the student's own answer in the last vote
    """
    right = stop.right if is_solved else None
    letters = add_letters(stop).items()
    labels = {option: _mark_label(label, option == right, option == chosen) for option, label in letters}
    result = _find_votes(code, stop, vote, labels)
    if not result:
        return
    all_votes, changes = result
    # In a narrow chart the style sheet shows the names of the votes in the bars instead of the headings.
    templates = (_("*First vote:* {share}"), _("*Second vote:* {share}")) if vote.is_second else ("{share}",)
    with st.container(key="class_result"):
        if is_solved:
            _draw_changes(changes)
        if vote.is_second:
            with st.container(key="class_votes"):
                headings = st.columns(_widths(all_votes), gap="small")[1:]
                for heading, name in zip(headings, (_("First vote"), _("Second vote")), strict=True):
                    heading.markdown(f"**{name}**")
        for option, label in labels.items():
            _draw_option(option, label, all_votes, templates)


def draw_options_with_shares(code: str, stop: Stop, vote: Vote) -> None:
    """Draw the options as a list, each with its share in each vote. A bar behind it shows the last share."""
    labels = add_letters(stop)
    result = _find_votes(code, stop, vote, labels)
    if not result:
        return
    rules = []
    for number, (option, label) in enumerate(labels.items(), start=1):
        percentages = [_percent(votes[option], votes.total()) for votes in result.votes]
        labels[option] = f"{label} **{' → '.join(percentages)}**"
        share = _fraction(result.votes[-1], option)
        rules.append(f".st-key-class_options li:nth-child({number}) {{ --share: {share:.1%} }}")
    draw_options(labels)
    st.html(f"<style>{' '.join(rules)}</style>")


def draw_answer(code: str, stop: Stop, vote: Vote) -> None:
    """Draw the share of each option in the last vote, the most common mistake, and the right answer with its reason.

    The wall has shown the sentences of all options before. Here their letters suffice, so that the reasons are large.
    """
    try:
        votes = _result(code, stop.id, vote).votes[-1]
    except ClassError as error:
        st.warning(str(error))
        return
    # A sentence follows each label, and some labels have no full stop.
    labels = {option: label.removesuffix(".") + "." for option, label in add_letters(stop).items()}
    mistake = find_commonest_mistake(code, stop, vote)
    if votes.total():
        with st.container(key="wall_shares"):
            for option, column in zip(stop.options, st.columns(len(stop.options), gap="small"), strict=True):
                letter = f"**{labels[option].partition('.')[0]}**"
                mark = f":green[:material/check_circle:] {letter}" if option == stop.right else letter
                _draw_share(column, votes, option, f"{mark} {{percent}}")
    with st.container(key="wall_reason"):
        # The reply ends with a question, which the reason answers.
        if mistake:
            st.markdown(MISTAKE.format(label=labels[mistake], reply=stop.reply(mistake)))
        st.markdown(f"{_mark_label(labels[stop.right], is_right=True, is_own=False)} {stop.explanation()}")


def _widths(votes: Sequence[object]) -> list[int]:
    """Return the relative widths of the columns: the label of an option, and its share in each vote."""
    label_width, chart_width = (3, 2) if len(votes) == 1 else (2, 1)
    return [label_width, *(chart_width for _vote in votes)]


def _draw_option(option: str, text: str, all_votes: Sequence[Counter[str]], templates: Sequence[str]) -> None:
    """Draw the label of an option, and its share in each vote."""
    label, *charts = st.columns(_widths(all_votes), gap="small")
    label.markdown(text)
    for chart, votes, template in zip(charts, all_votes, templates, strict=True):
        _draw_share(chart, votes, option, template)


def _draw_share(place: DeltaGenerator, votes: Counter[str], option: str, template: str) -> None:
    """Draw the share of an option in a vote as a bar, with its numbers in the text `template`."""
    people, total = votes[option], votes.total()
    text = template.format(share=_share(people, total), percent=_percent(people, total))
    place.progress(_fraction(votes, option), text)


def _fraction(votes: Counter[str], option: str) -> float:
    """Return the share of an option, from 0 to 1; 0 if nobody voted."""
    return votes[option] / votes.total() if votes.total() else 0.0


def _find_votes(code: str, stop: Stop, vote: Vote, labels: Mapping[str, str]) -> _Result | None:
    """Return the result of a question. If there is none to draw, say why, and return None."""
    try:
        result = _result(code, stop.id, vote)
    except ClassError as error:
        st.warning(str(error))
        return None
    if any(votes.total() for votes in result.votes):
        return result
    draw_options(labels)
    st.markdown(_("Nobody has voted."))
    return None


@st.cache_data(show_spinner=False, max_entries=256)
def _result(code: str, stop: str, vote: Vote) -> _Result:
    """Return the result of a question. A revealed result is final, so it is cached."""
    votes_so_far = [vote._replace(number=number) for number in range(1, vote.number + 1)]
    # A class may have voted under another version of the app, with other options.
    distributions = [Counter(shared().read_distribution(code, stop, earlier)) for earlier in votes_so_far]
    if not vote.is_second:
        return _Result(distributions, Counter())
    right = find_stop(stop).right
    return _Result(distributions, shared().count_changes(code, stop, right, vote.times_asked))


def _mark_label(label: str, is_right: bool, is_own: bool) -> str:
    """Return the label of an option, marked if it is right or the student's own answer."""
    marked = f":green[:material/check_circle:] **{label}**" if is_right else label
    return _("{label} – *This was your answer.*").format(label=marked) if is_own else marked


def _share(people: int, total: int) -> str:
    """Return the number and percentage of these voters; a dash if nobody voted."""
    if not total:
        return "–"
    # TRANSLATORS: how many chose this answer: 12 of 30, 40 %.
    return _("{people} of {total}, {share}").format(people=people, total=total, share=_percent(people, total))


def _percent(people: int, total: int) -> str:
    """Return the percentage of these voters; a dash if nobody voted."""
    return quantity(round(100 * people / total), "%") if total else "–"


def _draw_changes(changes: Counter[tuple[bool, bool]]) -> None:
    """Draw the number of students for each kind of change between two votes. Do nothing without a second vote."""
    if not changes:
        return
    sentence = _("**Wrong, then right: {up}.** Right, then wrong: {down}. Right both times: {both}.")
    with st.container(key="class_changes"):
        st.markdown(sentence.format(up=changes[False, True], down=changes[True, False], both=changes[True, True]))


def find_commonest_mistake(code: str, stop: Stop, vote: Vote) -> str | None:
    """Return the most frequent wrong answer of a vote; None without a wrong answer."""
    votes = _result(code, stop.id, vote).votes[-1]
    wrong_options = [option for option in stop.options if option != stop.right]
    commonest = max(wrong_options, key=votes.__getitem__)
    return commonest if votes[commonest] else None


def draw_commonest_mistake(code: str, stop: Stop, vote: Vote) -> None:
    """Name the most frequent wrong answer of a vote, with the reply to it. Do nothing without a wrong answer."""
    mistake = find_commonest_mistake(code, stop, vote)
    if mistake:
        sentence = _("**Most common wrong answer:** {label}\\\n{reply}")
        st.markdown(sentence.format(label=add_letters(stop)[mistake], reply=stop.reply(mistake)))


def draw_whole_lesson(code: str, view: ClassView) -> None:
    """Draw the share of right answers before and after the discussion, for each question with a revealed answer."""
    try:
        results = [(stop, _result(code, stop, vote).votes) for stop, vote in view.list_solved()]
    except ClassError as error:
        st.warning(str(error))
        return
    if not results:
        st.markdown(_("No right answer was shown to this class."))
        return
    twice = [(stop, all_votes) for stop, all_votes in results if len(all_votes) > 1]
    if twice:
        before = _share_of_right([(stop, all_votes[0]) for stop, all_votes in twice])
        after = _share_of_right([(stop, all_votes[1]) for stop, all_votes in twice])
        sentence = _("Right before students talked to their neighbours: {before}. Right after it: {after}.")
        st.markdown(sentence.format(before=before, after=after))
    # Without any second vote, the last column would be empty.
    columns = 3 if twice else 2
    rows = [(_("Question"), _("Right at first"), _("After talking"))[:columns]]
    for stop, all_votes in results:
        shares = [_share_of_right([(stop, votes)]) for votes in all_votes]
        rows.append((find_stop(stop).heading, *shares, "–")[:columns])
    # The letters of a long table are smaller on the wall (projector.css).
    widgets.table(rows, key="learned_at_many" if len(results) > 8 else "learned")


def _share_of_right(results: Sequence[tuple[str, Mapping[str, int]]]) -> str:
    """Return the share of right answers in several votes.

    Parameters
    ----------
    results : id of the stop, and its votes (option → number)
    """
    right = total = 0
    for stop, votes in results:
        right += votes[find_stop(stop).right]
        total += sum(votes.values())
    return _share(right, total)


def draw_reason(stop: Stop, chosen: str | None = None) -> None:
    """Name the right answer and its reason. If `chosen` is wrong, comment on it first."""
    labels = add_letters(stop)
    if chosen and chosen != stop.right:
        st.markdown(_("**You chose:** {label}\\\n{reply}").format(label=labels[chosen], reply=stop.reply(chosen)))
    st.markdown(f":green[:material/check_circle:] **{labels[stop.right]}**")
    st.markdown(stop.explanation())


def storage_sentence(expires: float) -> str:
    """Return what is stored about the students of a class that is deleted at this time [s since 1970]."""
    mark = _("A random number in a cookie prevents extra votes for 30 days.")
    votes = _("The votes are stored without names until {date}.").format(date=local_time.date(expires))
    return f"{mark} {votes}"


def answers_sentence(view: ClassView) -> str:
    """Return the number of students present and of answers, as a sentence."""
    if not view.present:
        return joined_sentence(0)
    # TRANSLATORS: how many of the students have answered: 12 of 30.
    sentence = _("Answers: {answered} of {present}.").format(answered=view.answered, present=view.present)
    return " ".join((_("Second vote."), sentence)) if view.current.vote.is_second else sentence


def votes_sentence(code: str, stop: str, vote: Vote) -> str:
    """Return the number of votes behind the percentages of a revealed question, as a sentence."""
    try:
        votes = _result(code, stop, vote).votes[-1]
    except ClassError as error:
        return str(error)
    return ngettext("{n} vote", "{n} votes", votes.total()).format(n=votes.total())


def joined_sentence(people: int) -> str:
    """Return the number of students who joined, as a sentence."""
    return ngettext("{n} student has joined.", "{n} students have joined.", people).format(n=people)


def seats_sentence(view: ClassView) -> str:
    """Return the number of seats and of empty seats, as sentences."""
    sentence = ngettext("{n} seat is taken. Empty: {empty}.", "{n} seats are taken. Empty: {empty}.", view.taken)
    return sentence.format(n=view.taken, empty=view.taken - view.present)


def warn_of_local_address() -> None:
    """Draw a warning if students' phones cannot open the address of this page."""
    if address.is_only_for_this_computer():
        st.warning(
            _(
                "Phones cannot open the address of this page, because it means this computer only. Start the app "
                "without `--server.address`, and open it under this computer’s address in the network."
            )
        )


def draw_qr_code(address: str) -> None:
    """Draw an address as a QR code."""
    st.image(segno.make(address, micro=False).svg_inline(scale=8, border=3, light="white"), width="stretch")

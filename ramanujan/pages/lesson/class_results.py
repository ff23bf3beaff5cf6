"""Elements that several screens of a class share: votes, right answer, results, attendance, QR code."""

from collections import Counter
from collections.abc import Mapping, Sequence

import segno
import streamlit as st

from ramanujan import lesson
from ramanujan.lesson.classes import ClassError, ClassQuestion, Phase, Seats, Vote, shared
from ramanujan.lesson.stop import Stop
from ramanujan.numerals import quantity
from ramanujan.shell import address, local_time, widgets
from ramanujan.translation import _, ngettext

RESULTS_HEADING = _("What the class has learned")


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
    try:
        all_votes, changes = _result(code, stop.id, vote)
    except ClassError as error:
        st.warning(str(error))
        return
    right = stop.right if is_solved else None
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
        for option, text in stop.options.items():
            _draw_option(option, _mark_label(text, option == right, option == chosen), all_votes, templates)


def draw_answer(code: str, stop: Stop, vote: Vote) -> None:
    """Draw the right answer and the most common wrong one, with their last votes and the reasons.

    The wall has shown all votes before. Without the other options, the reasons fit in large letters.
    """
    try:
        all_votes, changes = _result(code, stop.id, vote)
    except ClassError as error:
        st.warning(str(error))
        return
    mistake = find_commonest_mistake(code, stop, vote)
    with st.container(key="class_result"):
        _draw_changes(changes)
        for option, text in stop.options.items():
            if option in (stop.right, mistake):
                _draw_option(
                    option, _mark_label(text, option == stop.right, is_own=False), all_votes[-1:], ("{share}",)
                )
    with st.container(key="wall_reason"):
        st.markdown(stop.explanation())
        if mistake:
            st.markdown(_("**Most common mistake:** {reply}").format(reply=stop.reply(mistake)))


def _widths(votes: Sequence[object]) -> list[int]:
    """Return the relative widths of the columns: the label of an option, and its share in each vote."""
    label_width, chart_width = (3, 2) if len(votes) == 1 else (2, 1)
    return [label_width, *(chart_width for _vote in votes)]


def _draw_option(option: str, text: str, all_votes: Sequence[Mapping[str, int]], templates: Sequence[str]) -> None:
    """Draw the label of an option, and its share in each vote."""
    label, *charts = st.columns(_widths(all_votes), gap="small")
    label.markdown(text)
    for chart, votes, template in zip(charts, all_votes, templates, strict=True):
        total = sum(votes.values())
        share = votes[option] / total if total else 0.0
        chart.progress(share, template.format(share=_share(votes[option], total)))


@st.cache_data(show_spinner=False, max_entries=256)
def _result(code: str, stop: str, vote: Vote) -> tuple[Sequence[Mapping[str, int]], Counter[tuple[bool, bool]]]:
    """Return the result of each vote (option → number of votes), and how answers changed between the two votes.

    The key of a change is whether the first answer was right, and whether the second one was. A revealed result is
    final, so it is cached.
    """
    votes_so_far = [vote._replace(number=number) for number in range(1, vote.number + 1)]
    distributions = [shared().read_distribution(code, stop, earlier) for earlier in votes_so_far]
    if not vote.is_second:
        return distributions, Counter()
    right = lesson.find_stop(stop).right
    return distributions, shared().count_changes(code, stop, right, vote.times_asked)


def _mark_label(label: str, is_right: bool, is_own: bool) -> str:
    """Return the label of an option, marked if it is right or the student's own answer."""
    if is_right and is_own:
        return _(":green[:material/check_circle:] **{label}** – This is right, and it was your answer.").format(
            label=label
        )
    if is_right:
        return _(":green[:material/check_circle:] **{label}** – This is right.").format(label=label)
    if is_own:
        return _("{label} – *This was your answer.*").format(label=label)
    return label


def _share(people: int, total: int) -> str:
    """Return the number and percentage of these voters."""
    share = quantity(round(100 * people / total) if total else 0, "%")
    # TRANSLATORS: how many chose this answer: 12 of 30, 40 %.
    return _("{people} of {total}, {share}").format(people=people, total=total, share=share)


def _draw_changes(changes: Counter[tuple[bool, bool]]) -> None:
    """Draw the number of students for each kind of change between two votes. Do nothing without a second vote."""
    if not changes:
        return
    sentence = _("**Wrong, then right: {up}.** Right, then wrong: {down}. Right both times: {both}.")
    with st.container(key="class_changes"):
        st.markdown(sentence.format(up=changes[False, True], down=changes[True, False], both=changes[True, True]))


def find_commonest_mistake(code: str, stop: Stop, vote: Vote) -> str | None:
    """Return the most frequent wrong answer of a vote; None without a wrong answer."""
    all_votes, _changes = _result(code, stop.id, vote)
    votes = all_votes[-1]
    wrong_options = [option for option in stop.options if option != stop.right]
    commonest = max(wrong_options, key=votes.__getitem__)
    return commonest if votes[commonest] else None


def draw_commonest_mistake(code: str, stop: Stop, vote: Vote) -> None:
    """Name the most frequent wrong answer of a vote, with the reply to it. Do nothing without a wrong answer."""
    mistake = find_commonest_mistake(code, stop, vote)
    if mistake:
        sentence = _("**Most common wrong answer:** {label}\\\n{reply}")
        st.markdown(sentence.format(label=stop.options[mistake], reply=stop.reply(mistake)))


def draw_whole_lesson(code: str) -> None:
    """Draw the share of right answers before and after the discussion, for each question with a revealed answer."""
    revealed = [result for result in shared().read_results(code, Phase.SOLVED) if lesson.has_stop(result.stop)]
    if not revealed:
        st.markdown(_("No right answer was shown to this class."))
        return
    twice = [result for result in revealed if result.second]
    if twice:
        before = _share_of_right([(result.stop, result.first) for result in twice])
        after = _share_of_right([(result.stop, result.second) for result in twice if result.second])
        sentence = _("Right before students talked to their neighbours: {before}. Right after it: {after}.")
        st.markdown(sentence.format(before=before, after=after))
    rows = [(_("Question"), _("Right at first"), _("After talking"))]
    for result in revealed:
        first, second = (
            _share_of_right([(result.stop, vote)]) if vote else "–" for vote in (result.first, result.second)
        )
        rows.append((lesson.find_stop(result.stop).heading, first, second))
    # The letters of a long table are smaller on the wall (projector.css).
    widgets.table(rows, key="learned_at_many" if len(revealed) > 8 else "learned")


def _share_of_right(results: Sequence[tuple[str, Mapping[str, int]]]) -> str:
    """Return the share of right answers in several votes.

    Parameters
    ----------
    results : id of the stop, and its votes (option → number)
    """
    right = total = 0
    for stop, votes in results:
        right += votes[lesson.find_stop(stop).right]
        total += sum(votes.values())
    return _share(right, total)


def draw_reason(stop: Stop, chosen: str | None = None) -> None:
    """Name the right answer and its reason. If `chosen` is wrong, comment on it first."""
    if chosen and chosen != stop.right:
        st.markdown(_("**You chose:** {label}\\\n{reply}").format(label=stop.options[chosen], reply=stop.reply(chosen)))
    st.markdown(f":green[:material/check_circle:] **{stop.options[stop.right]}**")
    st.markdown(stop.explanation())


def unknown_stop_sentence() -> str:
    """Return a sentence about a class whose current question is missing in this version of the app."""
    return _("The class is at a question that this version of the app does not have.")


def storage_sentence(expires: float, *, is_browser_storing: bool = True) -> str:
    """Return a description of the stored data about the students of a class, in two sentences.

    Parameters
    ----------
    expires : time at which the class is deleted [s since 1970]
    is_browser_storing : whether the browser stores a cookie; a frame of another site may have none
    """
    if is_browser_storing:
        mark = _("A random number in a cookie lasts 30 days; a one-way mark of the network prevents extra votes.")
    else:
        mark = _("This browser stores nothing; a one-way mark of the network prevents extra votes.")
    votes = _("The votes are stored without names until {date}.").format(date=local_time.date(expires))
    return f"{mark} {votes}"


def answers_sentence(current: ClassQuestion) -> str:
    """Return the number of students present and of answers, as a sentence."""
    # TRANSLATORS: how many of the students have answered: 12 of 30.
    sentence = _("Answers: {answered} of {present}.").format(answered=current.answered, present=current.present)
    return " ".join((_("Second vote."), sentence)) if current.vote.is_second else sentence


def joined_sentence(people: int) -> str:
    """Return the number of students who joined, as a sentence."""
    return ngettext("{n} student has joined.", "{n} students have joined.", people).format(n=people)


def recent_sentence(seats: Seats) -> str:
    """Return the number of students who joined in the last minute, as a sentence; an empty text for none."""
    sentence = ngettext(
        "{n} student joined in the last minute.", "{n} students joined in the last minute.", seats.newcomers
    )
    return sentence.format(n=seats.newcomers) if seats.newcomers else ""


def seats_sentence(seats: Seats) -> str:
    """Return the number of seats and of empty seats, as sentences."""
    sentence = ngettext("{n} seat is taken. Empty: {empty}.", "{n} seats are taken. Empty: {empty}.", seats.taken)
    return f"{sentence.format(n=seats.taken, empty=seats.taken - seats.present)} {recent_sentence(seats)}"


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

"""The lesson: one path through the machine in 45 minutes, and tasks that the physics itself judges. No Streamlit here.

    stop        what a stop is: a machine, a question, options, an answer that is worked out, an explanation
    clocks, bodies, modes, ratio, computing   the stops, in the order of the lesson
    task        what a task is: what a student has set, and the verdict on it
    machine_tasks, answer_tasks   the tasks: those done with the machine alone, those with an answer of their own
    classes     the class's votes, with their codes (class_codes), states (class_states) and file (class_record)

>>> from ramanujan import lesson
>>> lesson.stop("stiffness").answer()
'same'
"""

from ramanujan.lesson import answer_tasks, bodies, clocks, computing, machine_tasks, modes, ratio
from ramanujan.lesson.stop import Run, Stop
from ramanujan.lesson.task import Setting, Task, Verdict
from ramanujan.translation import _

CHAPTERS = (clocks.STOPS, bodies.STOPS, modes.STOPS, ratio.STOPS, computing.STOPS)
"""The stops by subject; a worksheet takes one of a chapter at most, because they would answer each other."""

STOPS: tuple[Stop, ...] = tuple(stop for chapter in CHAPTERS for stop in chapter)
"""The stops in their order: two clocks, who is faster, what can move, where the energy is, the ratio, computers."""

TASKS: tuple[Task, ...] = (*machine_tasks.TASKS, *answer_tasks.TASKS)
"""The tasks, the easier ones first."""

SOURCES = (
    "C. H. Crouch, A. P. Fagen, J. P. Callan, E. Mazur, “Classroom demonstrations: Learning tools or entertainment?”, "
    "Am. J. Phys. 72, 835 (2004).",
    "E. Mazur, Peer Instruction: A User’s Manual (Prentice Hall, 1997).",
    "R. White, R. Gunstone, Probing Understanding (Falmer, 1992).",
    "E. Hairer, C. Lubich, G. Wanner, Geometric Numerical Integration (Springer, 2006).",
)
"""Students who only watch a demonstration understand it no better than those who never saw it [1]; voting twice, with a
discussion between the votes, is from [2]; predict, observe, explain from [3]."""

INTRODUCTION = _(
    "Let everyone commit to an answer before the machine runs. Students who only watch a demonstration understand it "
    "no better than students who never saw it [1]. Where the answers differ, let neighbours discuss and vote again "
    "[2]. The order predict, observe, explain is from [3]. What students are expected to answer is a guess, except "
    "where a source is named."
)
"""The beginning of the lecturer's notes; each stop says what it is for."""


def stop(name: str) -> Stop:
    """Return the stop with this id."""
    return {stop.id: stop for stop in STOPS}[name]


def has_stop(name: str) -> bool:
    """Return whether there is a stop with this id; another version of the app may have others."""
    return any(stop.id == name for stop in STOPS)


def task(name: str) -> Task:
    """Return the task with this id."""
    return {task.id: task for task in TASKS}[name]

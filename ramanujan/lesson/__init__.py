"""The lesson: one path through the machine in 45 minutes, and tasks with computed verdicts, without Streamlit.

    stop        the parts of a stop: machine, question, options, computed answer, explanation
    clocks, directions, modes, ratio, computing   the stops, in the order of the lesson
    task        the parts of a task: a student's attempt and the verdict on it
    machine_tasks, answer_tasks   the tasks that need only the machine, and those with a typed or chosen answer

>>> from ramanujan import lesson
>>> lesson.find_stop("stiffness").answer()
'same'
"""

from ramanujan.lesson import answer_tasks, clocks, computing, directions, machine_tasks, modes, ratio
from ramanujan.lesson.stop import Run, Stop
from ramanujan.lesson.task import Attempt, Task, TaskVerdict
from ramanujan.text.translation import _

CHAPTERS = (clocks.STOPS, directions.STOPS, modes.STOPS, ratio.STOPS, computing.STOPS)
"""The stops by subject. Stops of one chapter answer each other, so a worksheet has at most one of each."""

STOPS: tuple[Stop, ...] = tuple(stop for chapter in CHAPTERS for stop in chapter)
"""All stops, in the order of the lesson."""

TASKS: tuple[Task, ...] = (*machine_tasks.TASKS, *answer_tasks.TASKS)
"""The tasks, the easier ones first."""

SOURCES = (
    "C. H. Crouch, A. P. Fagen, J. P. Callan, E. Mazur, “Classroom demonstrations: Learning tools or entertainment?”, "
    "Am. J. Phys. 72, 835 (2004).",
    "E. Mazur, Peer Instruction: A User’s Manual (Prentice Hall, 1997).",
    "R. White, R. Gunstone, Probing Understanding (Falmer, 1992).",
    "E. Hairer, C. Lubich, G. Wanner, Geometric Numerical Integration (Springer, 2006).",
)
"""The references of the lecturer's notes, in the order of their numbers."""

INTRODUCTION = _(
    "Let everyone commit to an answer before the machine runs. Students who only watch a demonstration understand it "
    "no better than students who never saw it [1]. Where the answers differ, let neighbours discuss and vote again "
    "[2]. The order predict, observe, explain is from [3]. What students are expected to answer is a guess, except "
    "where a source is named."
)
"""The beginning of the lecturer's notes, before the notes on each stop."""


def find_stop(name: str) -> Stop:
    """Return the stop with this id."""
    return {stop.id: stop for stop in STOPS}[name]


def find_task(name: str) -> Task:
    """Return the task with this id."""
    return {task.id: task for task in TASKS}[name]

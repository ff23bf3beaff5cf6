"""The lecturer's notes: what each stop is for, and what students usually answer."""

from __future__ import annotations

from dataclasses import dataclass

from ramanujan.translation import _

SOURCES = (
    "C. H. Crouch, A. P. Fagen, J. P. Callan, E. Mazur, “Classroom demonstrations: Learning tools or entertainment?”, "
    "Am. J. Phys. 72, 835 (2004).",
    "E. Mazur, Peer Instruction: A User’s Manual (Prentice Hall, 1997).",
    "R. White, R. Gunstone, Probing Understanding (Falmer, 1992).",
    "E. Hairer, C. Lubich, G. Wanner, Geometric Numerical Integration (Springer, 2006).",
)
"""Students who only watch a demonstration understand it no better than those who never saw it [1]; voting twice, with a
discussion between the votes, is from [2]; predict, observe, explain from [3]."""


@dataclass(frozen=True)
class Note:
    """What a lecturer should know of a stop: its purpose, and what students often answer and why."""

    stop: str
    purpose: str
    expect: str


INTRODUCTION = _(
    "Let everyone commit to an answer before the machine runs. Students who only watch a demonstration understand "
    "it no better than students who never saw it [1]. Where the answers differ, let neighbours discuss and vote "
    "again [2]. The order predict, observe, explain is from [3]. What students are expected to answer is a guess, "
    "except where a source is named."
)

NOTES = (
    Note(
        "two-clocks",
        _("It sets the question of the lesson: how much mass does the spring feel?"),
        _(
            "Many add up all masses and expect a far slower machine. The answer “exactly together” appeals to "
            "those who know the title."
        ),
    ),
    Note(
        "light-rollers",
        _("It separates travelling from spinning."),
        _("Those who noticed that the lower rollers hardly move often answer that their mass cannot matter."),
    ),
    Note(
        "heavy-rollers",
        _("It shows that the order of the two clocks changes, so there must be a ratio at which they agree."),
        _("Most get it right after the previous stop. Ask for the argument with the intermediate value."),
    ),
    Note(
        "stiffness",
        _("It is dimensional analysis: k can enter a period only as 1/√k."),
        _("“More” is common: a stiff spring is thought to favour the complicated machine."),
    ),
    Note(
        "radius",
        _("It shows that rolling couples spin to travel, so that R drops out."),
        _("“Longer” is common, because the moment of inertia is four times as large."),
    ),
    Note(
        "block",
        _("It is conservation of momentum without any calculation."),
        _("Some let the slab carry the block along, as friction would on a rough floor."),
    ),
    Note(
        "rollers",
        _("It is practice with relative velocities, with a surprising result."),
        _(
            "Few expect that the two velocities nearly cancel. Let the class watch the centre of the hoop against "
            "the ruler."
        ),
    ),
    Note(
        "turning-point",
        _("It shows that released from rest, only one mode is excited, so all bodies stop together."),
        _("Some expect that the free top cylinder still moves."),
    ),
    Note(
        "middle",
        _("It makes students compare kinetic energy of translation and of rotation."),
        _("The hoop is a popular answer, and it comes second. The machine may run while the class thinks."),
    ),
    Note(
        "zero-modes",
        _("It prepares the spectrum: one oscillating mode and two zero modes."),
        _("“One” is common: the gliding machine is found first, the rolling top cylinder is overlooked."),
    ),
    Note(
        "contact",
        _("It asks what friction is for: it makes the rollers turn."),
        _("Many choose the top cylinder, because nothing else drives it. For very light lower rollers they are right."),
    ),
    Note(
        "by-hand",
        _("It is bisection: how one finds a number without a formula."),
        _("Let a student call out values while you drag the slider on the page Oscillator."),
    ),
    Note(
        "exactly",
        _("It turns the search into a quadratic equation."),
        _("The sign of b is the usual slip. Let students put their answer into the equation."),
    ),
    Note(
        "1729",
        _("It separates what follows from the coefficients from what is a coincidence."),
        _("Many expect a deep reason for both sums. Say clearly that none is known."),
    ),
    Note(
        "other-body",
        _("It shows how fragile the number is: one other body, and it is gone."),
        _("Many believe that a body that rolls freely cannot matter."),
    ),
    Note(
        "steps",
        _("It shows that the structure of a method can matter more than its step size [4]."),
        _("Nearly everyone trusts the thousand steps. Ask where the additional energy comes from."),
    ),
    Note(
        "huge-ratio",
        _("It shows that a correct formula can fail without a warning."),
        _(
            "“An error message” is common, and some languages give one: Python’s power raises an OverflowError, "
            "NumPy warns. JavaScript, C and Fortran return zero. Let the class name other programs in which this could "
            "happen."
        ),
    ),
)

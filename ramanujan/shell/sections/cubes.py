"""The two stacks of cubes, on page 4 and at the last step of the derivation."""

from ramanujan.browser import components
from ramanujan.number_theory import BodyChoice
from ramanujan.translation import _

PAPER = BodyChoice()
"""The paper's machine."""


def draw_stacks() -> None:
    """Draw the two stacks, each with its sum. A line breaks only before an equals sign."""
    components.cubes(
        [(larger, smaller) for smaller, larger in PAPER.cubes],
        [in_words(*cubes) for cubes in PAPER.cubes],
        [f"{x}³ + {y}³ =\u00a0{x**3}\u00a0+\u00a0{y**3} =\u00a0{PAPER.discriminant}" for x, y in PAPER.cubes],
    )


def in_words(smaller: int, larger: int) -> str:
    """Return the text alternative of two cubes that add up to the number."""
    sees = _(
        "Two cubes built of unit cubes, {larger} and {smaller} along each edge. Together they have {volumes} = "
        "{number} unit cubes."
    )
    volumes = f"{smaller**3} + {larger**3}"
    return sees.format(larger=larger, smaller=smaller, volumes=volumes, number=PAPER.discriminant)

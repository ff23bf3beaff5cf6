"""The two sums of cubes, in words and as two stacks of cubes."""

from ramanujan.browser.components import cubes
from ramanujan.number_theory import BodyChoice, smallest_taxicab, sums_of_two_cubes
from ramanujan.text.translation import _

PAPER = BodyChoice()
"""The paper's machine."""


def reason() -> str:
    """Return why the ratio in step is remarkable, in Markdown."""
    sentence = _("{number} = {sums} is the smallest number with two such sums: the number of Hardy’s taxi.")
    number = smallest_taxicab()
    sums = " = ".join(f"{x}³\u00a0+\u00a0{y}³" for x, y in sums_of_two_cubes(number))
    return sentence.format(number=number, sums=sums)


def draw_stacks(*, with_values: bool = True) -> None:
    """Draw the two stacks, each with its sum, also of its terms `with_values`. A line breaks before an equals sign."""
    cubes.mount(
        [(larger, smaller) for smaller, larger in PAPER.cubes],
        [describe_cubes(smaller, larger) for smaller, larger in PAPER.cubes],
        [write_sum(x, y, with_values) for x, y in PAPER.cubes],
        PAPER.discriminant,
    )


def write_sum(x: int, y: int, with_values: bool) -> str:
    """Return the sum of two cubes up to its last equals sign, such as 1³ + 12³ = 1 + 1728 =."""
    values = f" =\u00a0{x**3}\u00a0+\u00a0{y**3}" if with_values else ""
    return f"{x}³ + {y}³{values} =\u00a0"


def describe_cubes(smaller: int, larger: int) -> str:
    """Return the text alternative of a stack: two cubes whose volumes add up to 1729."""
    template = _(
        "Two cubes built of unit cubes, {larger} and {smaller} along each edge. Together they have {volumes} = "
        "{number} unit cubes."
    )
    volumes = f"{smaller**3} + {larger**3}"
    return template.format(larger=larger, smaller=smaller, volumes=volumes, number=PAPER.discriminant)

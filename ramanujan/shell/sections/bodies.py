"""The names for a choice of the three rolling bodies, on page 4 and in tasks."""

from ramanujan.number_theory import BodyChoice
from ramanujan.translation import _

PAPER = dict(zip(("left", "right", "top"), BodyChoice().bodies, strict=True))
"""Position → the paper's body."""
PLACE_WORDS = {"left": _("Left roller"), "right": _("Right roller"), "top": _("Body on top")}

"""The three places of rolling bodies, on the page 1729 and in tasks."""

from ramanujan.number_theory import BodyChoice
from ramanujan.text.translation import _

PLACES = ("left", "right", "top")
"""The places, in the order of `BodyChoice.bodies`."""
PAPER_BODIES = dict(zip(PLACES, BodyChoice().bodies, strict=True))
"""Place → the body of the paper's machine."""
PLACE_WORDS = {"left": _("Left roller"), "right": _("Right roller"), "top": _("Body on top")}
"""Place → its label."""

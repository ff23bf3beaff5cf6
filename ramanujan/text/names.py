"""The names of the bodies and of the contacts in all texts: one table of each."""

from typing import NamedTuple

from ramanujan.text.translation import _, pgettext


class BodyNames(NamedTuple):
    """The names of a body.

    Parameters
    ----------
    label : without an article
    in_sentence : with its article
    subscript : in a formula
    """

    label: str
    in_sentence: str
    subscript: str


BODIES = {
    # TRANSLATORS: bodies, inside of a sentence. Names with an article fill the slots {body}, {name} and {roller}.
    "block": BodyNames(_("block"), _("the block"), pgettext("subscript", "block")),
    "hoop": BodyNames(_("hoop"), _("the hoop"), pgettext("subscript", "hoop")),
    "cylinder": BodyNames(_("lower cylinder"), _("the lower cylinder"), pgettext("subscript", "cylinder")),
    "slab": BodyNames(_("slab"), _("the slab"), pgettext("subscript", "slab")),
    "top": BodyNames(_("top cylinder"), _("the top cylinder"), pgettext("subscript", "top")),
}
"""Body → its names."""

SPRING = _("spring")

_ORDER = ("block", "hoop", "cylinder", "slab", "spring", "top")
PARTS = {part: SPRING if part == "spring" else BODIES[part].label for part in _ORDER}
"""The five bodies and the spring, in the order of figures: id → label."""

SHAPES = {"hoop": _("hoop"), "shell": _("spherical shell"), "cylinder": _("cylinder"), "sphere": _("sphere")}
"""Shape of a rolling body → its name without an article."""


class ContactNames(NamedTuple):
    """The names of a contact.

    Parameters
    ----------
    pair : the two bodies, as in "hoop and slab"
    between : the place in a sentence, as in "between hoop and slab"
    """

    pair: str
    between: str


# TRANSLATORS: two bodies that touch: hoop and slab.
_PAIR = _("{body} and {other}")


def _name_contact(body: str, other: str, between: str) -> ContactNames:
    """Return the names of the contact of two bodies."""
    return ContactNames(_PAIR.format(body=PARTS[body], other=PARTS[other]), between)


CONTACTS = {
    # TRANSLATORS: inside a sentence, after "the contact".
    "hoop_slab": _name_contact("hoop", "slab", _("between hoop and slab")),
    "cylinder_slab": _name_contact("cylinder", "slab", _("between lower cylinder and slab")),
    "hoop_block": _name_contact("hoop", "block", _("between hoop and block")),
    "cylinder_block": _name_contact("cylinder", "block", _("between lower cylinder and block")),
    "top_block": _name_contact("top", "block", _("between top cylinder and block")),
}
"""Contact → its names."""

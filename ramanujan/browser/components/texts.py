"""The texts for the slots of the components' HTML. Other texts are part of the components' data."""

from ramanujan.text.translation import _

TEXTS = {
    "cubes": {"apart": _("Pull the layers apart"), "turn": _("Turn the stacks")},
    "cursor": {"cursor": _("Time cursor")},
    "link": {
        "share": _("Share"),
        "copy": _("Copy link"),
        "copy_hint": _("The link contains everything that you set."),
        "save": _("Save as one file"),
        "save_hint": _("The machine as it is set, for any browser, without a server or a network."),
        "embed": _("Copy code to embed"),
        "embed_hint": _("It shows this machine on a page of your own, such as a course page."),
        "link": _("Text to copy"),
        "language": _("Language"),
    },
    "pager": {"slides": _("Slides of this page"), "back": _("Back"), "next": _("Next")},
    "drawer": {"handle": _("Sliders and presets")},
    "stopwatch": {"stopwatch": _("Stopwatch")},
    "turn": {"back": _("Back"), "next": _("Next")},
}
"""Component → slot of its HTML → text."""

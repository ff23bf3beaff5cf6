"""The texts for the slots of the components' HTML; what the components say besides comes with their data."""

from ramanujan.translation import _, pgettext

TEXTS = {
    "cubes": {"apart": _("Pull the layers apart"), "turn": _("Turn the stacks")},
    "cursor": {"cursor": _("Time cursor")},
    "link": {"copy": _("Copy link"), "link": _("Link"), "language": _("Language")},
    "pager": {"slides": _("Slides of this page"), "back": _("Back"), "next": _("Next")},
    "drawer": {"handle": _("Sliders and presets")},
    "steps": {"steps": _("Steps"), "step": _("Step"), "back": _("Back"), "next": _("Next")},
    "stopwatch": {"stopwatch": _("Stopwatch")},
    "turn": {
        "steps": _("Stops of the lesson"),
        "step": pgettext("of the lesson", "Stop"),
        "back": _("Back"),
        "next": _("Next"),
    },
}
"""Component → slot of its HTML → text."""

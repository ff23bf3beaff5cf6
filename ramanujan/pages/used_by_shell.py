"""The parts of each page that the shell uses. app.py passes them, because the shell imports no page."""

from ramanujan.pages.derivation import page as derivation
from ramanujan.pages.lesson import page as lesson
from ramanujan.pages.motion import page as motion
from ramanujan.pages.oscillator import page as oscillator
from ramanujan.pages.speed import page as speed
from ramanujan.pages.taxicab import page as taxicab
from ramanujan.pages.worksheet import page as worksheet
from ramanujan.shell.menu import Entry

ENTRIES = {
    "oscillator": Entry(draw_header=oscillator.draw_header),
    "derivation": Entry(derivation.URL_PARAMETERS, uses_sidebar=derivation.uses_sidebar),
    "motion": Entry(motion.URL_PARAMETERS, uses_sidebar=lambda: False),
    "taxicab": Entry(taxicab.URL_PARAMETERS, uses_sidebar=lambda: False),
    "speed": Entry(speed.URL_PARAMETERS, uses_sidebar=lambda: False),
    "lesson": Entry(
        lesson.URL_PARAMETERS,
        draw_header=lesson.draw_header,
        uses_sidebar=lesson.uses_sidebar,
        withheld_presets=lesson.withheld_presets,
    ),
    "worksheet": Entry(worksheet.URL_PARAMETERS, uses_sidebar=worksheet.uses_sidebar),
}
"""Name of a page → its parts that the shell uses."""


def warm_up() -> None:
    """Fill the caches that the first visitor would wait for."""
    oscillator.warm_up()

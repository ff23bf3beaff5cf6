"""Colours and themes of the page."""

from tests.checks.bare import THEME
from tests.checks.browser import until


def rgb(color: str) -> tuple[int, int, int]:
    """Return red, green and blue, from 0 to 255, of a colour such as #1D2430."""
    return tuple(int(color[i : i + 2], 16) for i in (1, 3, 5))


def switch(page, theme: str) -> None:
    """Switch the theme, and wait for the colours from the server."""
    page.emulate_media(color_scheme=theme, reduced_motion="reduce")
    paper = THEME[theme]["backgroundColor"]
    until(
        page,
        """([theme, paper]) => document.documentElement.dataset.theme === theme &&
          getComputedStyle(document.documentElement).getPropertyValue('--paper') === paper""",
        [theme, paper],
        120,  # Plotly measures each word of five figures in both themes and at both widths
    )


RING = """(node) => {
  node.focus({ focusVisible: true });
  const styles = [node, node.parentElement].map((each) => getComputedStyle(each));
  const ring = styles.find((each) => each.outlineStyle === "solid");
  const seen = ring ? [parseFloat(ring.outlineWidth), ring.outlineColor] : null;
  node.blur();
  return seen;
}"""

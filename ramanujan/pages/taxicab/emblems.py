"""Small drawings of the four bodies that can roll: where the colour is, there is the mass."""

from base64 import b64encode

from ramanujan.number_theory import BODIES
from ramanujan.translation import _

WORDS = {"hoop": _("hoop"), "shell": _("shell"), "cylinder": _("cylinder"), "sphere": _("sphere")}
"""Body → what one calls it."""


def legend(color: str) -> str:
    """Return all bodies with their names and shape factors β, as HTML."""
    figures = (
        f'<figure style="margin:0;display:flex;gap:.4rem;align-items:center">'
        f'<img width="38" height="38" alt="" src="{_address(body, color)}">'
        f"<figcaption>{WORDS[body]}<br>β = {beta}</figcaption></figure>"
        for body, beta in BODIES.items()
    )
    return f'<div style="display:flex;flex-wrap:wrap;gap:.6rem 1rem">{"".join(figures)}</div>'


def _address(body: str, color: str) -> str:
    """Return the drawing of a body as an address that holds it."""
    ink = f'stroke="{color}" fill="none"'
    drawings = {
        "hoop": f'<circle cx="24" cy="24" r="19" stroke-width="5" {ink}/>',
        "shell": f'<circle cx="24" cy="24" r="20" stroke-width="2.5" stroke="{color}" fill="{color}" '
        f'fill-opacity=".15"/><ellipse cx="24" cy="24" rx="20" ry="7" stroke-width="1.5" {ink}/>'
        f'<ellipse cx="24" cy="24" rx="7" ry="20" stroke-width="1.5" {ink}/>',
        "cylinder": f'<g fill="{color}"><g opacity=".5"><circle cx="29" cy="19" r="15"/>'
        '<path d="M8.4 18.4 18.4 8.4 39.6 29.6 29.6 39.6z"/></g><circle cx="19" cy="29" r="15"/></g>',
        "sphere": f'<circle cx="24" cy="24" r="21" fill="{color}"/>'
        '<circle cx="18" cy="17" r="7" fill="#fff" fill-opacity=".4"/>'
        '<circle cx="16" cy="15" r="3" fill="#fff" fill-opacity=".6"/>',
    }
    svg = f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 48 48">{drawings[body]}</svg>'
    return f"data:image/svg+xml;base64,{b64encode(svg.encode()).decode()}"

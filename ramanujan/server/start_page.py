"""The start page: Streamlit's own page, with the app's fonts, style sheets and first modules.

If Streamlit loaded these files, they would arrive after the first headings, on a slow computer seconds later. Then the
page would jump.
"""

import re
from base64 import b64encode
from hashlib import sha256
from html import escape
from pathlib import Path

import streamlit as st

from ramanujan.browser import modules
from ramanujan.text.translation import LANGUAGE, _

_STREAMLIT = Path(st.__file__).parent / "static"
_FRAME = Path(modules.__file__).parent / "frame.js"
_STREAMLIT_PRELOAD = re.compile(rb'<link\s[^>]*as="font"[^>]*>')
"""Streamlit's link that preloads its own font. The app replaces this font with a smaller one (page.css)."""
_NO_SCRIPT = re.compile(rb"<noscript>.*?</noscript>", re.DOTALL)
"""Streamlit's sentence for a browser without scripts."""
_FIRST_MODULES = ("begin", "publish", "stage/stage", "components/services/services")
"""Modules that draw the machine, then the services, and import the others. A preload of all would delay the machine."""


def content_security_policy() -> str:
    """Return the content security policy: only files of the app's server, data URLs, and blobs of the page's scripts.

    Streamlit imports the scripts of components from blobs and computes with WebAssembly. Streamlit and Plotly write
    style rules into the page. Data URLs contain images, never scripts. Of the inline scripts, only those of the start
    page may run.
    """
    inline = re.findall(rb"<script>(.*?)</script>", html(has_formulas=True), re.DOTALL)
    hashes = " ".join(f"'sha256-{b64encode(sha256(script).digest()).decode()}'" for script in inline)
    return (
        f"default-src 'self' blob: data:; script-src 'self' blob: 'wasm-unsafe-eval' {hashes}; "
        "style-src 'self' 'unsafe-inline'; object-src 'none'; base-uri 'self'; form-action 'self'"
    )


def html(*, has_formulas: bool) -> bytes:
    """Return the page. A page without formulas loads fewer fonts."""
    folder = f"./{modules.folder_url()}"
    fonts = [f"{folder}/{name}" for name in sorted(modules.collect_files()) if "fonts/" in name]
    if has_formulas:
        # KaTeX measures formulas with these fonts. If they arrived late, lines would change their length.
        letters = re.compile(r"KaTeX_(Main-Regular|Math-Italic|Size1-Regular)\..*woff2")
        names = sorted(path.name for path in _STREAMLIT.glob("static/media/*"))
        fonts += [f"./static/media/{name}" for name in names if letters.match(name)]
    preloads = [f'<link rel="preload" as="font" crossorigin href="{name}">' for name in fonts]

    # pager.js switches the projector's style sheet on.
    media = {
        "contrast.css": "(forced-colors: active)",
        "print.css": "print",
        "projector.css": "not all",
    }
    sheets = [name for name in sorted(modules.collect_files()) if name.endswith(".css")]
    links = [f'<link rel="stylesheet" href="{folder}/{name}" media="{media.get(name, "all")}">' for name in sheets]
    scripts = [f'<script type="module" async src="{folder}/{name}.js"></script>' for name in _FIRST_MODULES]

    page = (_STREAMLIT / "index.html").read_bytes()
    page = page.replace(b'<html lang="en"', f'<html lang="{LANGUAGE}"'.encode(), 1)
    # frame.js runs before Streamlit's own scripts, which read the address.
    page = page.replace(b"<head>", f"<head><script>{_FRAME.read_text(encoding='utf-8')}</script>".encode(), 1)
    page = _STREAMLIT_PRELOAD.sub("".join(preloads).encode(), page, count=1)
    # frame.js shows this sentence, too.
    page = _NO_SCRIPT.sub(f"<noscript>{_explain_scripts()}</noscript>".encode(), page, count=1)
    # Append the sheets to the body: Streamlit adds its rules to the head, and the later of two equal rules applies.
    return page.replace(b"</body>", "".join([*links, *scripts, "</body>"]).encode(), 1)


def _explain_scripts() -> str:
    """Return the sentence for a reader without scripts, with a link to the same address."""
    sentence = _("The app cannot run here, because the browser or the page around it blocks its scripts.")
    link = _("Open the app in a tab of its own")
    # Without scripts, #root shows the outlines of a page that is being loaded.
    style = "<style>#root { display: none; }</style>"
    return f'{style}<p>{escape(sentence)}</p><p><a href="" target="_blank">{escape(link)}</a></p>'

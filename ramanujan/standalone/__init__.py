"""The first page as one HTML file that needs no server: `python -m ramanujan.standalone --output oscillator.html`.

The file contains the app's modules. An import map assigns a `data:` address to each of them. page.js stores the values
of the sliders, in place of the server; curve.js moves the ring on the curve. The file makes no request, and its
content security policy forbids requests. Without scripts, as in the preview of a mail, it shows still pictures.

All characters are ASCII, so that the file survives any encoding on its way: of a shell, of a mail, of a web host.

The settings of the machine follow `#` in the address, with the same names as in the app. Without them the attribute
`data-standalone` contains the settings. The app writes it when a visitor saves the file, and the page updates it, for a
visitor who saves the page.
"""

import json
import posixpath
import re
import unicodedata
from base64 import b64encode
from collections.abc import Iterable, Iterator
from hashlib import sha256
from html import escape, unescape
from pathlib import Path
from string import Template
from typing import Any
from urllib.parse import quote
from xml.etree import ElementTree as ET

from latex2mathml.converter import convert

from ramanujan import Oscillator
from ramanujan.browser import modules, stage
from ramanujan.derivation import model
from ramanujan.derivation.nomenclature import DOTS, nomenclature
from ramanujan.derivation.printers import latex
from ramanujan.figures import still_machine
from ramanujan.pages.oscillator import cache as first_page
from ramanujan.pages.oscillator import shared_with_file, story
from ramanujan.shell import address, stages, theme, widgets
from ramanujan.shell.address import URLParameter
from ramanujan.shell.parameters import PARAMETERS, SENTENCES, WATCH, Parameter
from ramanujan.shell.sections import cubes
from ramanujan.shell.shared_cache import route
from ramanujan.standalone import curve
from ramanujan.text.translation import LANGUAGE, _, pgettext

_HERE = Path(__file__).parent
_MARKUP = ("stage/stage", "components/exact/exact", "components/story/story")
"""The components of the page; each has a module, HTML and a style sheet."""
_SLIDERS = ("m_prime", "m", "k", "compression")
_SYMBOLS = (model.X, model.phi, model.Phi, model.R)
"""The symbols of the derivation that are at no slider."""
_IMPORT = re.compile(r"""(?<=(?:from |port |port\()["`])\.{1,2}/[^"`]+""")
"""The path of a module relative to the one that imports it."""
_PLACEHOLDER = "w"
"""A letter that occurs in no formula."""
_SIGN = re.compile("(<mrow>|<mo>=</mo>|<mtext>\u00a0</mtext>)<mo>−</mo>")
"""A minus sign without a left operand."""
_SINGLE = re.compile("<mrow>(<m[ino]>[^<]*</m[ino]>)</mrow>")
"""A row with a single symbol or number."""
_DOTTED = re.compile("<mover><mi>(.)</mi><mo>([˙¨])</mo></mover>")
_COMBINING = {"˙": "\u0307", "¨": "\u0308"}
_SPACE = '<mspace width="0.167em" />'
_NOT_ASCII = re.compile(r"[^\x00-\x7f]")
_COMMENT = re.compile(r"^\s*(//.*|/\*[^*]*(\*+[^*/][^*]*)*\*+/)\n", re.MULTILINE)


def html() -> str:
    """Return the file, in the language of this process."""
    imports = json.dumps({"imports": _list_imports()})
    script = 'import "ramanujan/standalone/page.js";'
    # A browser without import maps shows the page as it is without scripts.
    start = 'HTMLScriptElement.supports?.("importmap") && document.documentElement.classList.add("starting")'
    slots = {
        "title": _("Ramanujan’s oscillator"),
        "question": _convert_bold(shared_with_file.question()),
        "reason": escape(cubes.reason()),
        "machine": _("The machine"),
        "still_machine": _draw_still_machine(),
        "how_to_open": _("To see the machine move, save this file and open it in a web browser."),
        "curve_heading": shared_with_file.CURVE_HEADING,
        "curve_text": _convert_formulas(shared_with_file.CURVE_TEXT),
        "curve": curve.draw_svg(first_page.curve()),
        "curve_hint": shared_with_file.CURVE_HINT,
        "steps_heading": shared_with_file.STEPS_HEADING,
        "symbols_heading": pgettext("list of them", "Symbols"),
        "symbols": "".join(_explain_symbols()),
        "dots": escape(DOTS),
        "steps": "".join(_write_steps()),
        "language": LANGUAGE,
        "style": _write_style(),
        "policy": _write_policy(imports, script, start),
        "settings": json.dumps(_collect_settings()).replace("<", "\\u003c"),
        "imports": imports,
        "script": script,
        "start": start,
    }
    page = Template((_HERE / "page.html").read_text(encoding="utf-8")).substitute(slots)
    return page.encode("ascii", "xmlcharrefreplace").decode("ascii")


def _list_imports() -> dict[str, str]:
    """Return name → `data:` address of each module that the page needs."""
    contents = _collect_scripts()
    contents["browser/markup.js"] = modules.markup(_MARKUP, f"<style>{_write_contrast_rules()}</style>")
    waiting = ["standalone/page.js", *(f"browser/{name}.js" for name in _MARKUP)]
    addresses: dict[str, str] = {}
    while waiting:
        name = waiting.pop()
        if name in contents and f"ramanujan/{name}" not in addresses:
            script = _with_absolute_imports(name, _COMMENT.sub("", contents[name]))
            addresses[f"ramanujan/{name}"] = _make_data_address(script)
            waiting += re.findall(r'["`]ramanujan/([^"`]+)', script)
    return addresses


def _collect_scripts() -> dict[str, str]:
    """Return path below `ramanujan` → script, for the modules of the app and those of this file."""
    shared = {
        f"browser/{name}": content.decode() for name, content in modules.collect_files().items() if name.endswith(".js")
    }
    own = {f"standalone/{path.name}": path.read_text(encoding="utf-8") for path in _HERE.glob("*.js")}
    return shared | own


def _with_absolute_imports(name: str, script: str) -> str:
    """Return a module that imports others by absolute names, because a `data:` address has no folder."""
    folder = posixpath.dirname(f"ramanujan/{name}")
    return _IMPORT.sub(lambda path: posixpath.normpath(posixpath.join(folder, path[0])), script)


def _make_data_address(script: str) -> str:
    """Return the `data:` address of a script."""
    return "data:text/javascript;charset=utf-8," + quote(script, safe=" !$&'()*+,-./:;=?@[]^_`{|}~>")


def _write_policy(*scripts: str) -> str:
    """Return the content security policy: it allows these scripts and the modules in the file, but no requests."""
    hashes = " ".join(f"'sha256-{b64encode(sha256(script.encode()).digest()).decode()}'" for script in scripts)
    return (
        f"default-src 'none'; script-src data: {hashes}; style-src 'unsafe-inline'; font-src data:; "
        "img-src data: blob:; base-uri 'none'; form-action 'none'"
    )


def _collect_settings() -> dict[str, Any]:
    """Return the data of page.js."""
    machine = stage.payload(Oscillator(), 0)["parameters"]
    return {
        "parameters": [_describe_parameter(PARAMETERS[key]) for key in (*_SLIDERS, "radius")],
        "view": [
            {"key": parameter.name, "pattern": _find_pattern(parameter), "refusal": parameter.message()}
            for parameter in stages.URL_PARAMETERS
        ],
        "sentences": SENTENCES,
        "machine": machine,
        "stage": stage.settings("stage", name="oscillator", layers=(), limits=stages.LIMITS, watch=WATCH),
        "story": story.collect_data(),
        "curve": curve.describe_panel(first_page.curve()),
    }


def _describe_parameter(parameter: Parameter) -> dict[str, Any]:
    """Return the range of a parameter, the heading of its box, and the message about a refused value."""
    names = ("symbol", "unit", "least", "most", "default", "step", "scale", "label")
    attributes = {name: getattr(parameter, name) for name in names}
    head = widgets.box_settings(parameter) | {"key": parameter.name} if parameter.name in _SLIDERS else None
    return {"key": parameter.name, **attributes, "head": head, "refusal": parameter.message()}


def _find_pattern(parameter: URLParameter) -> str:
    """Return the regular expression of the valid texts of a parameter of the stage."""
    if isinstance(parameter, address.Text):
        return parameter.pattern
    assert isinstance(parameter, address.Choice)
    option = f"({'|'.join(map(re.escape, parameter.options))})"
    return f"{option}(,{option})*" if isinstance(parameter, address.Several) else option


def _draw_still_machine() -> str:
    """Return the picture of the machine for a reader without scripts."""
    compression = PARAMETERS["compression"]
    return still_machine.draw_svg(Oscillator(), compression.default * compression.scale, theme.paper_colors())


def _explain_symbols() -> Iterator[str]:
    """Yield the meaning of each symbol of the derivation that is at no slider."""
    meanings = nomenclature(route("euler_lagrange"))
    for symbol in map(latex, _SYMBOLS):
        yield f"<li>{_convert_to_mathml(symbol)}: {_convert_formulas(meanings[symbol])}</li>"


def _write_steps() -> Iterator[str]:
    """Yield the six steps of the derivation: their results, and when opened their reasons and other equations."""
    for step in first_page.summary(None):
        results = _write_equations(step.results)
        details = "".join(
            f"<p>{_convert_formulas(detail.reason)}</p>{_write_equations(row.unmarked.latex for row in detail.details)}"
            for detail in step.steps
        )
        heading = f"<h3>{escape(step.heading)} <small>{escape(step.idea)}</small></h3>"
        yield f"<li><details><summary>{heading}{results}</summary>{details}</details></li>"


def _write_equations(equations: Iterable[str]) -> str:
    """Return equations in MathML, each in a box of its own."""
    return "".join(f"<div>{_split(_convert_to_mathml(equation))}</div>" for equation in equations)


def _split(formula: str) -> str:
    """Split a formula before its terms: a browser breaks lines between formulas, but not in one."""
    [row] = ET.fromstring(formula)
    terms, depth = [ET.Element("mrow")], 0
    for part in row:
        depth += {"(": 1, ")": -1}.get(part.text or "", 0)
        if part.text in ("+", "−") and depth == 0 and "form" not in part.attrib:
            part.set("form", "infix")
            terms.append(ET.Element("mrow"))
        terms[-1].append(part)
    return "<wbr>".join(f"<math>{ET.tostring(term, encoding='unicode')}</math>" for term in terms)


def _convert_bold(text: str) -> str:
    """Convert bold words from Markdown to HTML."""
    return re.sub(r"\*\*(.*?)\*\*", r"<b>\1</b>", escape(text))


def _convert_formulas(text: str) -> str:
    """Convert the formulas of a text to MathML."""
    # The parts with odd indices are formulas.
    parts = text.split("$")
    return "".join(_convert_to_mathml(part) if i % 2 else escape(part) for i, part in enumerate(parts))


def _convert_to_mathml(latex: str) -> str:
    """Return a formula as MathML in few bytes. A placeholder protects m′, which the converter would split."""
    # Chromium adds a wide space beside parentheses that can grow. These formulas do not need such parentheses.
    fixed = latex.replace(r"\left", "").replace(r"\right", "").replace(r"\mathcal L", r"\mathcal{L}")
    formula = unescape(convert(fixed.replace("m'", _PLACEHOLDER)))
    formula = _SINGLE.sub(r"\1", f"<math>{formula.partition('>')[2]}")
    formula = formula.replace(f"<mi>{_PLACEHOLDER}</mi>", "<mi>𝑚′</mi>").replace(_SPACE, '<mspace width=".17em"/>')
    formula = formula.replace("<mo>/</mo>", '<mo lspace="0" rspace="0">/</mo>')
    formula = formula.replace("<mi>cos</mi>", '<mo lspace=".17em" rspace=".17em">cos</mo>')
    # Browsers place a dot at different heights. In the file's font, a letter with its dots is one character.
    formula = _DOTTED.sub(lambda match: f"<mi>{_find_italic(match[1])}{_COMBINING[match[2]]}</mi>", formula)
    # Capital Greek letters are upright, as in KaTeX.
    formula = re.sub("<mi>([Α-Ω])</mi>", r'<mi mathvariant="normal">\1</mi>', formula)
    return _SIGN.sub(r'\1<mo form="prefix">−</mo>', formula)


def _find_italic(letter: str) -> str:
    """Return the italic letter that a symbol has in MathML; a capital Greek letter is upright."""
    if "Α" <= letter <= "Ω":
        return letter
    kind = "SMALL" if letter.islower() else "CAPITAL"
    return unicodedata.lookup(f"MATHEMATICAL ITALIC {kind} {unicodedata.name(letter).rpartition(' ')[2]}")


def _write_style() -> str:
    """Return the style sheet with the colours of both themes and the fonts in it."""
    contents = modules.collect_files()
    fonts = re.findall(r"@font-face \{.*?\n\}", contents["page.css"].decode(), re.DOTALL)
    light, dark = (f":root {{ {_write_colors(theme)} }}" for theme in ("light", "dark"))
    themes = f"{light}\n@media (prefers-color-scheme: dark) {{ {dark} }}"
    style = "\n".join([*fonts, themes, _read_page_css(), _write_contrast_rules()])
    # The file embeds its own fonts, which have the same names as the app's.
    style = re.sub(r"url\(fonts/(.*?)\)", lambda match: _embed_font((_HERE / match[1]).read_bytes()), style)
    # A style sheet has escapes of its own for characters; a space ends each.
    return _NOT_ASCII.sub(lambda character: f"\\{ord(character[0]):x} ", style)


def _write_contrast_rules() -> str:
    """Return the style sheet for forced colours with its media query."""
    return f"@media (forced-colors: active) {{ {modules.collect_files()['contrast.css'].decode()} }}"


def _embed_font(content: bytes) -> str:
    return f"url(data:font/woff2;base64,{b64encode(content).decode()})"


def _write_colors(theme: str) -> str:
    """Return the colours of a theme that the file uses, as custom properties with Streamlit's names."""
    style_sheets = modules.collect_files()["markup.js"].decode() + _read_page_css()
    colors = modules.theme_colors(theme, style_sheets)
    colors["--st-widget-border-color"] = colors["--st-border-color"]
    return " ".join(f"{name}: {color};" for name, color in colors.items())


def _read_page_css() -> str:
    return (_HERE / "page.css").read_text(encoding="utf-8")

"""The first page as one HTML file that needs no server: `python -m ramanujan.browser.standalone > oscillator.html`.

The file contains the app's modules. An import map assigns a `data:` address to each of them. page.js stores the values
of the sliders, in place of the server; curve.js draws the curve. The file makes no request, and its content security
policy forbids requests.

The settings of the machine follow `#` in the address, with the same names as in the app. Without them the attribute
`data-standalone` contains the settings; the app writes it when a visitor saves the file.
"""

import json
import posixpath
import re
from base64 import b64encode
from collections.abc import Iterator
from hashlib import sha256
from html import escape
from pathlib import Path
from string import Template
from typing import Any
from urllib.parse import quote

from latex2mathml.converter import convert

from ramanujan import Oscillator
from ramanujan.browser import modules, stage
from ramanujan.figures import MASS_RATIO
from ramanujan.figures.oscillator import limit_labels
from ramanujan.pages.oscillator import cache as first_page
from ramanujan.pages.oscillator import story, texts
from ramanujan.shell import address, stages, widgets
from ramanujan.shell.address import URLParameter
from ramanujan.shell.parameters import PARAMETERS, SENTENCES, WATCH, Parameter
from ramanujan.translation import LANGUAGE, _

_HERE = Path(__file__).parent
_MARKUP = ("stage/stage", "components/exact", "components/story")
"""The components of the page; each has a module, HTML and a style sheet."""
_SLIDERS = ("m_prime", "m", "k", "compression")
_IMPORT = re.compile(r"""(?<=(?:from |port |port\()["`])\.{1,2}/[^"`]+""")
"""The path of a module relative to the one that imports it."""
_PLACEHOLDER = "w"
"""A letter that occurs in no formula."""
_SIGN = re.compile("(<mrow>|<mo>&#x0003D;</mo>|<mtext>&#x000A0;</mtext>)<mo>&#x02212;</mo>")
"""A minus sign without a left operand."""
_CAPITAL = re.compile("<mi>(&#x003A[0-9];)")
"""A capital Greek letter, which is upright in KaTeX."""
_COMMENT = re.compile(r"^\s*//.*\n", re.MULTILINE)


def html() -> str:
    """Return the file, in the language of this process."""
    condition = first_page.curve()
    imports = json.dumps({"imports": _list_imports()}, ensure_ascii=False)
    script = 'import "ramanujan/standalone/page.js";'
    slots = {
        "title": _("Ramanujan’s oscillator"),
        "question": _convert_bold(texts.question()),
        "machine": _("The machine"),
        "curve_heading": texts.CURVE_HEADING,
        "curve_text": _convert_formulas(texts.CURVE_TEXT),
        "curve_alt": escape(texts.curve_alternative(condition)),
        "curve_hint": texts.CURVE_HINT,
        "steps_heading": texts.STEPS_HEADING,
        "steps": "".join(_write_steps()),
        "language": LANGUAGE,
        "style": _write_style(),
        "policy": _write_policy(imports, script),
        "settings": json.dumps(_collect_settings(), ensure_ascii=False).replace("<", "\\u003c"),
        "imports": imports,
        "script": script,
    }
    return Template((_HERE / "page.html").read_text(encoding="utf-8")).substitute(slots)


def _list_imports() -> dict[str, str]:
    """Return name → `data:` address of each module that the page needs."""
    contents = {name: content.decode() for name, content in modules.collect_files().items() if name.endswith(".js")}
    contents["markup.js"] = modules.markup(_MARKUP, f"<style>{_write_contrast_rules()}</style>")
    waiting = ["standalone/page.js", *(f"{name}.js" for name in _MARKUP)]
    addresses: dict[str, str] = {}
    while waiting:
        name = waiting.pop()
        if name in contents and f"ramanujan/{name}" not in addresses:
            script = _with_absolute_imports(name, _COMMENT.sub("", contents[name]))
            addresses[f"ramanujan/{name}"] = _make_data_address(script)
            waiting += re.findall(r'["`]ramanujan/([^"`]+)', script)
    return addresses


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
        "sentences": SENTENCES | {"unknown": address.UNKNOWN},
        "machine": machine,
        "stage": stage.settings("stage", name="oscillator", layers=(), limits=stages.LIMITS, watch=WATCH),
        "story": story.collect_data(),
        "curve": _describe_curve() | {"shape": {name: machine[name] for name in machine if name.startswith("beta_")}},
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


def _describe_curve() -> dict[str, Any]:
    """Return the range of the curve, its limits, its marked ratios, and its labels."""
    curve = first_page.curve()
    light, heavy = limit_labels(curve)
    words = {
        "light": light,
        "heavy": heavy.replace("<br>", " "),
        "equal": curve.equal.label.replace("<br>", ": "),
        "number": str(first_page.discriminant()),
        "unit": f"ε = {first_page.unit_ratio()}",
        "step": _("in step"),
        "axis": re.sub("<[^>]*>", "", MASS_RATIO),
    }
    marks = {"equal": curve.equal.ratio, "unit": curve.unit.ratio}
    # The asymptote for heavy rollers is a constant divided by ε.
    heavy_constant = float(curve.heavy_limit[-1] * curve.ratios[-1])
    limits = {"light": curve.light_limit, "heavy": heavy_constant}
    return {"range": first_page.CURVE_RANGE, **limits, **marks, "words": words}


def _write_steps() -> Iterator[str]:
    """Yield the six steps of the derivation, with their results in MathML."""
    for step in first_page.summary(None):
        results = "".join(f"<div>{_convert_to_mathml(result)}</div>" for result in step.results)
        yield f"<li><h3>{escape(step.heading)}</h3>{results}</li>"


def _convert_bold(text: str) -> str:
    """Convert bold words from Markdown to HTML."""
    return re.sub(r"\*\*(.*?)\*\*", r"<b>\1</b>", escape(text))


def _convert_formulas(text: str) -> str:
    """Convert the formulas of a text to MathML."""
    # The parts with odd indices are formulas.
    parts = text.split("$")
    return "".join(_convert_to_mathml(part) if i % 2 else escape(part) for i, part in enumerate(parts))


def _convert_to_mathml(latex: str) -> str:
    """Return a formula as MathML, with large fractions. A placeholder protects m′, which the converter would split."""
    # Chromium adds a wide space beside parentheses that can grow. These formulas do not need such parentheses.
    fixed = latex.replace(r"\left", "").replace(r"\right", "")
    converted = convert(fixed.replace(r"\frac", r"\dfrac").replace("m'", _PLACEHOLDER))
    converted = converted.replace(f"<mi>{_PLACEHOLDER}</mi>", "<mi>𝑚′</mi>")
    converted = converted.replace("<mo>&#x0002F;</mo>", '<mo lspace="0" rspace="0">/</mo>')
    converted = converted.replace("<mover>", '<mover accent="true">')  # otherwise Chromium's dots are small
    converted = _CAPITAL.sub(r'<mi mathvariant="normal">\1', converted)
    return _SIGN.sub(r'\1<mo form="prefix">&#x02212;</mo>', converted)


def _write_style() -> str:
    """Return the style sheet with the colours of both themes and the fonts in it."""
    contents = modules.collect_files()
    rules = re.findall(r"@font-face \{.*?\n\}", contents["components/page.css"].decode(), re.DOTALL)
    # The file embeds its own fonts, which have the same names.
    fonts = re.sub(
        r"url\(fonts/(.*?)\)", lambda match: _embed_font(contents[f"standalone/{match[1]}"]), "\n".join(rules)
    )
    light, dark = (f":root {{ {_write_colors(theme)} }}" for theme in ("light", "dark"))
    themes = f"{light}\n@media (prefers-color-scheme: dark) {{ {dark} }}"
    return "\n".join([fonts, themes, _read_page_css(), _write_contrast_rules()])


def _write_contrast_rules() -> str:
    """Return the style sheet for forced colours with its media query."""
    return f"@media (forced-colors: active) {{ {modules.collect_files()['components/contrast.css'].decode()} }}"


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

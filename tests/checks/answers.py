"""The right answers to the questions, worked out by hand, and texts that must not break the judge."""

import sympy as sp

OMEGA, RATIO, POTENTIAL = "natural_frequency_squared", "unit_mass_ratio", "potential_energy"
BLOCK, HOOP, CYLINDER, SLAB, TOP = (f"kinetic_energy_{body}" for body in ("block", "hoop", "cylinder", "slab", "top"))
EQUATIONS = ("block_equation", "unit_quadratic")
RIGHT_RATIO = (sp.sqrt(1729) - 1) / 36
RIGHT = {
    BLOCK: ["½mX'²", "0.5 m Ẋ²", "½ m (-X')²", "mX'X'/2"],
    HOOP: [
        "½m'(Rφ'-X')² + ½m'R²φ'²",
        "m'(2R²φ'² - 2RX'φ' + X'²)/2",
        r"\frac12 m'\left(R\,\dot{\varphi}-\dot X\right)^{2} + \tfrac{1}{2}m^{\prime} R^2\dot\varphi^2",
    ],
    CYLINDER: ["½m'(Rφ'-X')² + ¼m'R²φ'²", "1/2 m' (R phi' - X')^2 + 1/2*1/2 m' R^2 phi'^2"],
    SLAB: ["½m(2Rφ'-X')²", "m/2*(X' - 2R phi')^2", "2mR²φ'² - 2mRφ'X' + ½mX'²"],
    TOP: ["½m(RΦ'-X')² + ¼mR²Φ'²", "m(3R²Phi'^2 - 4R Phi' X' + 2X'^2)/4"],
    POTENTIAL: ["2kR²φ²", "½k(2Rφ)²", "2 k (R phi)^2"],
    "lagrangian": [
        "½mX'² + ½m'(Rφ'-X')² + ½m'R²φ'² + ½m'(Rφ'-X')² + ¼m'R²φ'² + ½m(2Rφ'-X')² + ½m(RΦ'-X')² + ¼mR²Φ'² - 2kR²φ²",
        "½(3m+2m')X'² + ¼(8m+7m')R²φ'² + ¾mR²Φ'² - 2(m+m')RX'φ' - mRX'Φ' - 2kR²φ²",
    ],
    "block_momentum": ["(3m+2m')X' - 2(m+m')Rφ' - mRΦ'", "3mX' + 2m'X' - 2mRφ' - 2m'Rφ' - mRΦ'"],
    "block_equation": [
        "(3m+2m')X'' - 2(m+m')Rφ'' - mRΦ'' = 0",
        "(3m+2m')Ẍ = 2(m+m')Rφ̈ + mRΦ̈",
        "2(m+m')R d²φ/dt² - (3m+2m')d²X/dt² + mR d²Φ/dt²",
    ],
    "phi_equation": ["R(8m+7m')/2", "4mR + 7/2 m'R", "R(4m + 3.5m')", "(8m+7m')R 0.5", "R(4m + 3,5m')"],
    "block_coupling": ["6R(m+m')/(7m+6m')", "6R(1+ε)/(7+6ε)", "R(6m+6m')/(6m'+7m)"],
    "top_coupling": ["4(m+m')/(7m+6m')", "4(1+eps)/(7+6eps)"],
    OMEGA: [
        "8k(7m+6m')/(32m²+49mm'+18m'²)",
        "(56km+48km')/(18m'^2+49m m'+32m^2)",
        "(k/m) 8(7+6ε)/(18ε²+49ε+32)",
        r"\frac{8k(7m+6m')}{32m^2+49mm'+18m'^2}",
        r"$\frac{8\,k\,\left(7\,m + 6\,m'\right)}{32\,m^{2} + 49\,m\,m' + 18\,{m'}^{2}}$",
    ],
    "unit_quadratic": ["18ε²+ε-24=0", "18 eps^2 + eps = 24", "48 - 2ε = 36ε²", "(36ε+1)² = 1729"],
    RATIO: [
        "(sqrt(1729) - 1)/36",
        "48/(1+√1729)",
        "-(1-√1729)/36",
        r"\frac{\sqrt{1729}-1}{36}",
        "(√6916-2)/72",
    ],
}
HOSTILE = [
    "__import__('os')",
    "9**9**9",
    "(" * 10**6,
    "\x00",
    "1e999999",
    "9" * 10**5,
    "-" * 299 + "m",
    "√" * 20 + "m",
    "sqrt(m-m-1)",
    "0^-1",
    "1/(m-m)",
    "1/(√2*√2-2)",
    "m\u0301",
    "\ud800",
    "<script>alert(1)</script>",
    "[a](javascript:b)",
    "/".join("(m^12+k)" for _ in range(9)),
    "(m+k+R+m'+1)^12*(m+k+R+m'+2)^12/99999999999999999999",
    "√(m+" * 20 + "k" + ")" * 20,
    "k/(m/m)^(-2)",
    "^".join("1" * 150),
    "1/(" + "+".join(f"√{n}" for n in (2, 3, 5, 7, 11, 13, 17, 19)) + ")",
    "√(99999999999999999989*99999999999999999971)",
    "(X+X'+phi+phi'+Phi+Phi'+m+m'+k+R)^4/(X+X'+phi+phi'+Phi+Phi'+m+m'+k+2R)^4",
    "".join(f"+1/(m+{n})" for n in range(30)),
    r"\frac" * 60,
    "(m+k+R+m')^4*99999999999999999999^12 = eps",
    "=" * 300,
]


def zero_on_the_right(text: str) -> str:
    """Return a formula, or the left side of an equation minus its right side."""
    left, equals, right = text.partition("=")
    return f"{left} - ({right})" if equals else text

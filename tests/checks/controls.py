"""Sliders and boxes under a hand."""

from tests.checks.browser import inside, next_frame, settle, thumb


def box(page, key: str):
    return page.locator(f".st-key-{key}_exact input")


def slider(page, key: str):
    return page.locator(f".st-key-{key} input[type=range]")


def normalized(page) -> float:
    return float(inside(page, "root.querySelector('[data-read=normalized]').textContent"))


def write(page, key: str, text: str) -> None:
    box(page, key).fill(text)
    box(page, key).press("Enter")
    settle(page)


def hold(page, key: str, by: int, steps: int) -> tuple[float, float]:
    """Press on a slider's thumb and drag it by `by` pixels. Return its position before the drag."""
    slider(page, key).scroll_into_view_if_needed()
    x, y = thumb(page, key)
    page.mouse.move(x, y)
    page.mouse.down()
    next_frame(page)
    for i in range(1, steps + 1):
        page.mouse.move(x + by * i / steps, y)
        next_frame(page)
    return x, y

"""Modules without the app, imported one by one in a browser: begin, publish and clock."""

import pytest

from tests.checks.bare import Bare
from tests.checks.browser import module
from tests.checks.engines import ANY_ENGINE

pytestmark = ANY_ENGINE


@pytest.fixture
def page(bare) -> Bare:
    return bare()


def run(bare: Bare, name: str, body: str, argument: object = None) -> object:
    """Run the body of a JavaScript function; `tested` is the module, `given` the argument. Return the result."""
    return bare.page.evaluate(f"async (given) => {{ const tested = await {module(name)}; {body} }}", argument)


def test_a_component_begins_once_and_only_the_clean_up_of_its_last_call_ends_it(page):
    received = run(
        page,
        "begin",
        """
        const parentElement = document.createElement("div"), seen = [], { bus } = await BUS;
        const call = (c) => tested.begin({ name: "publish", parentElement, data: { c } });
        const ends = [await call(1), await call(2)];
        seen.push(bus.last("c"));
        ends[0](); // a clean-up that comes late
        seen.push(bus.last("c"));
        ends[1]();
        seen.push(bus.last("c") ?? "ended");
        await call(3);
        return [...seen, bus.last("c")];
        """.replace("BUS", module("bus")),
    )
    assert received == [2, 2, "ended", 3]


def test_a_published_value_remains_when_a_double_of_the_component_ends(page):
    """A change of the view briefly puts a component on the page twice. A later stage still needs the value."""
    received = run(
        page,
        "begin",
        """
        const { bus } = await BUS;
        const begin = () => tested.begin({
          name: "publish", parentElement: document.createElement("div"), data: { machine: 1 },
        });
        const first = await begin(), double = await begin();
        double();
        const stayed = bus.last("machine");
        first();
        return [stayed, bus.last("machine") ?? "forgotten"];
        """.replace("BUS", module("bus")),
    )
    assert received == [1, "forgotten"]


def test_stages_on_one_clock_run_together_and_the_clock_ends_with_the_last_one(page):
    result = run(
        page,
        "stage/clock",
        """
        const stops = [new AbortController(), new AbortController()], ticks = [[], []], busy = [true, true];
        const go = (i, elapsed) => ticks[i].push(elapsed) && busy[i];
        const stage = (i, period) => ({ period: () => period, advance: (elapsed) => go(i, elapsed) });
        const clocks = [0.35, 1e9].map((period, i) => tested.joinClock("c", stage(i, period), true, stops[i].signal));
        const frames = async (n) => { for (let i = 0; i < n; i++) await new Promise(requestAnimationFrame); };
        await frames(4);
        const shared = clocks[0] === clocks[1], { slowing } = clocks[0];
        busy[1] = false;
        await frames(3);
        const together = ticks[0].length === ticks[1].length;
        busy[0] = false;
        await frames(2);
        const rested = ticks[0].length;
        await frames(3);
        const isIdle = ticks[0].length === rested;
        tested.wake();
        await frames(3);
        const woken = ticks[0].length - rested;
        busy[0] = busy[1] = true;
        tested.wake();
        await frames(2);
        const each = ticks.map((list) => list.length);
        stops[0].abort();
        await frames(3);
        const alone = ticks.map((list, i) => list.length - each[i]);
        const quick = clocks[1].slowing;
        stops[1].abort();
        await frames(3);
        const last = ticks[1].length;
        await frames(3);
        const fresh = tested.joinClock("c", stage(0, 1), false, AbortSignal.abort());
        return { shared, slowing, each, alone, quick, ended: ticks[1].length === last, another: fresh !== clocks[0],
          together, isIdle, woken,
          least: Math.min(...ticks.flat()), most: Math.max(...ticks.flat()) };
        """,
    )
    assert result["shared"]
    # The shortest period that the eye can follow is 0.7 s.
    assert result["slowing"] == pytest.approx(0.5)
    assert result["quick"] == 1
    assert result["each"][0] == result["each"][1] > 0
    assert result["alone"][0] == 0 < result["alone"][1]
    # The loop runs for both while one moves, stops when neither does, and runs one frame after `wake`.
    assert result["together"]
    assert result["isIdle"]
    assert result["woken"] == 1
    assert result["ended"]
    assert result["another"]
    assert 0 <= result["least"] <= result["most"] <= 0.1

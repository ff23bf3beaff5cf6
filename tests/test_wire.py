"""What goes over the wire, without a browser: few bytes, and nothing that a page forgets and needs again."""

import asyncio
import json
import random
from concurrent.futures import ThreadPoolExecutor

import pytest
from streamlit.proto.Element_pb2 import Element
from streamlit.proto.WidgetStates_pb2 import WidgetState

from ramanujan.pages.motion.cache import VIEWS
from ramanujan.shell import navigation
from tests.benchmarks.visitor import Visitor

PAGES = tuple(page.address for page in navigation.PAGES.values())


@pytest.mark.parametrize("page", [*PAGES, *(f"motion?figure={figure}" for figure in VIEWS)])
def test_a_page_keeps_no_message_that_changes_and_forgets_none(server: str, page: str) -> None:
    """The cause: what a page forgets between its question and the answer can no longer be answered by its name.

    Wherever a slider is moved to, the motion page's figures come in 60 kB, even where the whole page is drawn anew.
    """

    async def visit() -> None:
        visitor, chance = Visitor(server, page), random.Random(1729)
        await visitor.open()
        await visitor.move("m", chance)
        kept = set(visitor.cache)
        for key in ("m", "m_prime", "k", "compression", *(("glide", "spin", "mu") if "figure" in page else ())):
            before = visitor.received
            await visitor.move(key, chance)
            assert "figure" not in page or 0 < visitor.received - before <= 60_000, key
        assert set(visitor.cache) == kept
        assert visitor.max_age > 10**9
        await visitor.close()

    # In a thread of its own: the browser of other tests keeps an event loop in this one.
    with ThreadPoolExecutor(1) as thread:
        thread.submit(asyncio.run, visit()).result()


class Forger(Visitor):
    """Remembers every widget of the page; an exception there, or none to an answer, is a `VisitError`."""

    def _take_element(self, element: Element) -> None:
        super()._take_element(element)
        if name := getattr(getattr(element, element.WhichOneof("type")), "id", ""):
            self.seen = {**getattr(self, "seen", {}), name: element.WhichOneof("type")}


def forged() -> list[WidgetState]:
    """States of every kind that a widget may have, with contents that few of them can have."""
    numbers, words = ([], [float("nan")], [1.0, 2.0, 3.0]), ([], ["nobody", "<b>"])
    states = [WidgetState(double_array_value={"data": each}) for each in numbers]
    states += [WidgetState(string_array_value={"data": each}) for each in words]
    states += [WidgetState(int_array_value={"data": [99]}), WidgetState(string_trigger_value={"data": "nobody"})]
    states += [WidgetState(file_uploader_state_value={}), WidgetState(bytes_value=b"\xff"), WidgetState()]
    states += [WidgetState(string_value="nobody"), WidgetState(double_value=float("nan")), WidgetState(int_value=-7)]
    values = ("nobody", -1, 1e300, [1], {"x": 0, "y": 0}, {"route": [], "step": "1"})
    told = [{event: value} for value in values for event in ("typed", "picked", "to", "at", "seconds")]
    states += [WidgetState(json_value=json.dumps(each)) for each in (*told, "nobody", [told], None)]
    events = [[{"event": event, "value": value} for event, value in each.items()] for each in told]
    states += [WidgetState(json_trigger_value=json.dumps(each)) for each in (*events, "nobody", 7, None)]
    return [*states, WidgetState(json_value="{"), WidgetState(json_trigger_value="{"), WidgetState(bool_value=True)]


@pytest.mark.parametrize("page", ["", "worksheet", "lesson?view=projector"])
def test_states_that_no_widget_has_leave_the_page_as_it_was(server: str, page: str) -> None:
    """Sent as no browser does, for all widgets at once; after each the page still answers its sliders."""

    async def visit() -> None:
        visitor = Forger(server, page)
        await visitor.open()
        assert "bidi_component" in visitor.seen.values()
        honest = dict(visitor.widgets)
        names = [*visitor.seen, *(f"$$STREAMLIT_INTERNAL_KEY_{name}__events" for name in visitor.seen)]
        for state in forged():
            for name in names:
                state.id = name
                visitor.widgets[name] = WidgetState.FromString(state.SerializeToString())
            await visitor._ask()
            await visitor._finished()
        visitor.widgets = honest
        await visitor.move("k", random.Random(1729))
        await visitor.close()

    with ThreadPoolExecutor(1) as thread:
        thread.submit(asyncio.run, visit()).result()

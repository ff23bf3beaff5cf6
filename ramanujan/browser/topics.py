"""Publish values from Python on the bus of the page (bus.js).

The topics of the bus, where NAME is the name of a stage, CLOCK of a clock, and KEY the key of a slider:

    machine/NAME      the message of `stage.publish`; removed when the visitor leaves the page
    time/NAME         {time [s], phase, plainPhase [rad], periods, playing}, published by the stage in every frame with
                      a change: angles of both hands, and periods of the plain mass, since the hands started together. A
                      change of the machine leaves all three. time is phase/Ω, since a release of the present machine
    story/NAME        while a story runs, the duration of a period of the plain mass on the screen [s]; null at its end
    drawn/NAME        {ratio, normalized, parameters}: ε, Ω²m/k and the machine as drawn, also during a drag
    seek/NAME         {time [s]}: a request to pause at this time
    view/CLOCK        the view of a class's desk, for all stages on this clock: `stage.VIEW`, with `ago`, its age [s],
                      and `own`, whether this page is the desk
    enter/KEY         a text to enter into a slider's box
    exact/KEY         {value, text, processed}: the value, text and number of processed inputs of a slider's box
    announce          {sentence, urgent}: a sentence for the page's live region
    turned            the new stop of a lesson
    step              the number of the step that a lecture shows
    slide             the name of the slide that the projector shows
    slides            {has(by)}: has(by) returns whether the projector has a slide `by` slides after the present one
"""

from collections.abc import Mapping
from typing import Any

from ramanujan.browser import modules


def publish(key: str, topics: Mapping[str, Any]) -> Any:
    """Publish values on the bus of the page. A change of these values does not send any other element again.

    Parameters
    ----------
    key : key of the element, unique among the published ones
    topics : topic → value; a value equal to that of the last run is not published again
    """
    return modules.component("publish")(key=f"unseen-published_{key}", data=dict(topics))

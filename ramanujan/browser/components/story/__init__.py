"""A button that starts a story, which moves a slider until a stage's machine is in step."""

from collections.abc import Mapping
from typing import Any

from ramanujan.browser import modules


def mount(data: Mapping[str, Any]) -> Any:
    """Put a button on the page that starts a story, which moves a slider until a stage's machine is in step.

    The page moves the slider, and sends only the last value. Once the slider has reached the ratio, in the story or by
    hand, the page marks the ratio on the slider.

    Parameters
    ----------
    data :
        stage : name of the stage
        slider : key of the slider of m′
        ratio : ε = m′/m of the machine in step
        scenes : {sentence, ratios, periods} of each scene
        screen_period : duration of a period of the plain mass on the screen [s]
        stills : {label, turns} of each clock for a reader who prefers reduced motion
        words : `ratio`, a template for ε; `in_step`, the sentence in step; `stills`, the sentence above the clocks;
            `mark`, the word at the mark on the slider; `begin`, `again`, `stop` and `hint` of the button
    """
    return modules.component("components/story/story")(key="story", data=dict(data))

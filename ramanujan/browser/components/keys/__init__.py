"""The keyboard focus after clicks."""

from ramanujan.browser import modules


def return_focus(*keys: str) -> None:
    """Return the keyboard focus to the page after each click on one of these widgets."""
    modules.component("components/keys/keys")(
        key="unseen-keys", data={"choices": ", ".join(f".st-key-{key}" for key in keys)}
    )

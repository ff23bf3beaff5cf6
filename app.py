"""Ramanujan's oscillator: the app. Start it with `streamlit run app.py`."""

import streamlit as st

if __name__ != "__main__":
    # The server loads this file once, under its own name, and runs it for each visitor as the main script.
    try:
        from ramanujan.shell import server
    except LookupError as unknown_language:
        raise SystemExit(unknown_language) from None

    app = st.App(__file__, middleware=server.MIDDLEWARE, lifespan=server.warmed_up)
else:
    from ramanujan.shell import (
        address,
        class_keys,
        display_mode,
        first_run,
        links,
        messages,
        navigation,
        sidebar,
    )

    # Before the pages bring their own icons to the menu: for the tab, Streamlit would fetch these from another server.
    st.set_page_config(page_icon="🚕")
    alone = first_run.begin()
    page, runner = navigation.navigate(hidden=alone)
    said = address.opened(page.name, links.parameters_of(page))
    display_mode.begin(page.name)
    address.keep(*display_mode.URL_PARAMETERS, *class_keys.URL_PARAMETERS)
    shown = 272 if page.uses_sidebar() and not display_mode.is_projector() else "collapsed"
    st.set_page_config(navigation.tab_title(page), layout="wide", initial_sidebar_state=shown)
    if display_mode.is_projector():
        display_mode.pager()
    sidebar.begin(said)
    if not page.lead():
        sidebar.draw(page.withheld(), page.aside())
    try:
        runner.run()
    finally:
        # A page that has said all that it has to say stops.
        if not (alone or display_mode.is_projector()):
            messages.show_how_much_is_translated()
            display_mode.bar()

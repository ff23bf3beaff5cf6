"""Ramanujan's oscillator: the app. Start it with `streamlit run app.py`."""

import streamlit as st

if __name__ != "__main__":
    # The server loads this file once, under its own name, and runs it for each visitor as the main script.
    from ramanujan.scenes.server import Compressed, Dressed, Middleware, warmed_up

    app = st.App(__file__, middleware=[Middleware(Compressed), Middleware(Dressed)], lifespan=warmed_up)
else:
    from ramanujan.scenes import cached, class_keys, complaints, controls, given, links, look, pages, quantities, view

    # Before the pages bring their own icons to the menu: for the tab, Streamlit would fetch these from another server.
    st.set_page_config(page_icon="🚕")
    page, runner = pages.navigate()
    view.take_old()
    said = links.opened(page.name, (*quantities.KEYS, *view.KEYS, *class_keys.KEYS, *page.keys))
    links.keep(*view.KEYS, *class_keys.KEYS)
    sidebar = "collapsed" if view.is_projector() else 340
    st.set_page_config(pages.tab_title(page), layout="wide", initial_sidebar_state=sidebar)
    cached.warm_up()
    look.dress(controls.BOXES)
    controls.take_typed()
    complaints.begin(said)
    controls.sidebar(page.withheld())
    runner.run()
    given.drawn()

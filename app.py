"""Ramanujan's oscillator: the app. Start it with `streamlit run app.py`.

Streamlit uses this file in two ways: the server imports it once and serves `app`, and each run of a visitor's page
executes it as the main script.
"""

import streamlit as st

if __name__ == "__main__":
    from ramanujan.shell import address, display_mode, first_run, links, messages, navigation, sidebar

    # Set the app's icon first, because Streamlit would load a font from another server for a page's icon.
    st.set_page_config(page_icon="🚕")
    only_machine = first_run.begin()
    page, script = navigation.navigate(hidden=only_machine)
    problems = address.read_once(page.name, links.parameters_of(page))
    display_mode.begin(page.name)
    address.update(*links.EVERY_PAGE)
    navigation.configure(page)
    if display_mode.is_projector():
        display_mode.pager()
    sidebar.begin(problems)
    if not page.draw_header():
        sidebar.draw(page.withheld_presets(), page.folded_parameters())
    try:
        script.run()
    finally:
        # A page may end its run early with st.stop().
        if not (only_machine or display_mode.is_projector()):
            messages.show_how_much_is_translated()
            display_mode.draw_bar()
else:
    try:
        from ramanujan.shell import server
    except LookupError as unknown_language:
        raise SystemExit(unknown_language) from None

    app = st.App(__file__, **server.settings())

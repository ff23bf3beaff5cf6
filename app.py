"""Ramanujan's oscillator: the app. Start it with `streamlit run app.py`.

Streamlit uses this file in two ways: the server imports it once and serves `app`, and each run of a visitor's page
executes it as the main script.
"""

import streamlit as st

if __name__ == "__main__":
    from ramanujan.pages.used_by_shell import ENTRIES
    from ramanujan.shell import address, display_mode, first_run, menu, messages, sidebar

    # Set the app's icon first, because Streamlit would load a font from another server for a page's icon.
    st.set_page_config(page_icon="🚕")
    only_machine = first_run.begin()
    page, script = menu.navigate(hidden=only_machine)
    entry = ENTRIES[page.name]
    problems = address.read_once(page.name, entry.all_url_parameters)
    display_mode.begin(page.name)
    address.update(*menu.EVERY_PAGE)
    menu.configure(page, entry.uses_sidebar())
    if display_mode.is_projector():
        display_mode.draw_pager()
    sidebar.begin(problems)
    if not entry.draw_header():
        sidebar.draw(entry.withheld_presets(), page.folded_parameters)
    try:
        script.run()
    finally:
        # A page may end its run early with st.stop().
        if not (only_machine or display_mode.is_projector()):
            messages.show_how_much_is_translated()
            display_mode.draw_bar()
else:
    try:
        # The import of a page takes seconds, and a class opens every page within a minute.
        from ramanujan.pages import used_by_shell
        from ramanujan.server import asgi
    except LookupError as unknown_language:
        raise SystemExit(unknown_language) from None

    app = st.App(__file__, **asgi.settings(used_by_shell.warm_up))

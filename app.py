"""Ramanujan's oscillator: the app. Start it with `streamlit run app.py`."""

import streamlit as st

if __name__ != "__main__":
    # The server loads this file once, under its own name, and runs it for each visitor as the main script.
    from ramanujan.scenes.server import Compressed, Middleware, warmed_up

    app = st.App(__file__, middleware=[Middleware(Compressed)], lifespan=warmed_up)
else:
    from ramanujan.scenes import cached, controls, look, view

    view.begin()
    sidebar = "collapsed" if view.is_projector() else 340
    st.set_page_config("Ramanujan’s oscillator", "🚕", layout="wide", initial_sidebar_state=sidebar)
    page = st.navigation(
        [
            st.Page("ramanujan/scenes/oscillator.py", title="Oscillator", icon=":material/waves:", default=True),
            st.Page("ramanujan/scenes/derivation.py", title="Derivation", icon=":material/function:"),
            st.Page("ramanujan/scenes/motion.py", title="Motion", icon=":material/timeline:", url_path="motion"),
            st.Page("ramanujan/scenes/taxicab.py", title="1729", icon=":material/local_taxi:", url_path="1729"),
            st.Page("ramanujan/scenes/lesson.py", title="Lesson", icon=":material/school:", url_path="lesson"),
            st.Page("ramanujan/scenes/speed.py", title="Speed and accuracy", icon=":material/speed:"),
            st.Page("ramanujan/scenes/worksheet.py", title="Worksheet", icon=":material/print:", url_path="worksheet"),
        ],
        position="top",
    )
    cached.warm_up()
    look.dress()
    controls.sidebar()
    page.run()

"""The browser's side: the animated stage, and the components of the pages around it.

Streamlit sends a component's HTML, CSS and script with every run of the page. Therefore a component's script has only
two lines. They import its module, which the server offers as a file (`ramanujan.browser.modules`).

These files of the folder are for several components:

    bus.js, topics.py   messages between the components
    mounting.py         values that components send to the server
    streamlit_dom.js    the selectors into the pages of Streamlit
    sliders.js          the same for its sliders
    plotly.js           the same for the graphs of Plotly
    marks.js            marks over these graphs that move without a new drawing
    page_address.js     the settings in the address, and the browser's history
    streamlit.css       style rules for the elements of Streamlit and Plotly, with their reasons
    page.css            style rules that all pages share; those of a page or a component are in its folder
    narrow.js           whether the style rules for a narrow screen apply
    sentences.js        templates of sentences, and notation of numbers
    numbers.js          reading of typed numbers
    lasting.js          observers and timers that end with their component
"""

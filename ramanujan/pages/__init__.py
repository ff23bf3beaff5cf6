"""The pages, a folder each: `page.py` draws it where Streamlit runs it, `cache.py` keeps what it computes."""

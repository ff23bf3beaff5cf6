"""The pages. Each has a folder: `page.py` is its Streamlit script, and `cache.py` contains its cached functions."""

"""The pages: one file each (`pages` lists them), run by Streamlit, and what they share."""

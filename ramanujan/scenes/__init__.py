"""The pages: one file each, run by Streamlit, and what they share (`controls`, `cached`, `look`)."""

"""A class without Streamlit: its rules, its stored votes, its states, codes and results."""

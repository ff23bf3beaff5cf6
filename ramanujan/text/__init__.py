"""The texts of the app: its language, numbers as people write them, and tables as files."""

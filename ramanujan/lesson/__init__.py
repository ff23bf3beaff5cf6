"""The lesson: its stops and tasks, and the class's votes. Nothing here knows of a page."""

"""The components beside the machine.

Each component has a folder with its module, its HTML, its style sheet and its mounting function. No physics here.
"""

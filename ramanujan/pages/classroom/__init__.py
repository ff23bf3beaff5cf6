"""A class on the lesson's page, with the screens desk, phone and wall, which read its state every few seconds."""

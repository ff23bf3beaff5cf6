"""The browser's side: the animated stage, and the components of the pages around it."""

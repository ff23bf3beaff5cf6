"""Page 5: accuracy and its cost."""

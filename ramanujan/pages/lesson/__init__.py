"""Page 6: the lesson."""

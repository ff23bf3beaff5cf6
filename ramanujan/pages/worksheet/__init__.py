"""Page 7: the worksheet."""

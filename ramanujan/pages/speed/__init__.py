"""Page 5: accuracy and what it costs."""

"""Page 3: the motion over time."""

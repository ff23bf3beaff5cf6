"""Page 4: why 1729."""

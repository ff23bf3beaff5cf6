"""Page 2: the routes to Ω²."""

"""Page 2: five routes to Ω²."""

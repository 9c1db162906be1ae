"""Which frame is now."""

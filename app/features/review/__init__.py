"""The review queue: what may be wrong, decisions, what was watched."""

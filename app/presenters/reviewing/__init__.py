"""The review queue: what is left, what was watched, how it gets on."""

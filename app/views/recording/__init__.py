"""One open recording: its page laid out, and everything on it wired together."""

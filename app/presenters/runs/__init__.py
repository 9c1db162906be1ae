"""The runs of a session, and the tracker at work, in words."""

"""Trackers at work and the runs of a session."""

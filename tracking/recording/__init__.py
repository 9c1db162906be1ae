"""Recordings: frames by number, from every kind of source."""

"""A change of tracks and labels, and what it is made for."""

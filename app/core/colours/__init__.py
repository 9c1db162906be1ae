"""Colours of tracks and scales: fixed per id, distinct for the colour-blind."""

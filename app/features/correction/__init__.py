"""Correcting tracks: gestures become edits; the panels of the edit and of the track."""

"""Accuracy of tracks against truth."""

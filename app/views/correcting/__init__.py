"""Correcting tracks: keys and drags, the edit that waits, the card of a track."""

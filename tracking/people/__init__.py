"""Regions of the foreground as people."""

"""Labelling: tools and sheets to draw with, what was said and drawn."""

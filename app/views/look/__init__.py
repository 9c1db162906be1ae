"""Colours of dark and light, and the icons drawn in them."""

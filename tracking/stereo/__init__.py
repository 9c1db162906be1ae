"""Subtraction stereo: range inside the foreground."""

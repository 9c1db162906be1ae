"""Plots over time: axis, curves, strips."""

"""Boxes of people: drawn, moved, dragged, interpolated between keyframes, thinned, deleted."""

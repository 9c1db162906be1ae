"""Drawing on pictures and the floor: canvas, viewport, and the marks of every scene."""

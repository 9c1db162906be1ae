"""Detections of another program over the pictures."""

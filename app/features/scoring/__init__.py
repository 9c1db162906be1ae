"""Scores against ground truth, errors by frame."""

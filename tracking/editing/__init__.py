"""Reversible edits of the tracks and their history."""

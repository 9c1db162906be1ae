"""Scenes of people rendered with exact truth."""

"""Trackers: started with their settings, watched at work, their runs and scores."""

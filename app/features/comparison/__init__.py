"""Two versions of the tracks side by side: runs, tracking again, another person's session."""

"""Body parts as a tracker saw them: in the picture, over time, and where they failed."""

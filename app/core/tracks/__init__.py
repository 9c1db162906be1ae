"""The tracks that are shown, whoever made them, one frame of them, and who is selected."""

"""Set-up: from videos to a recording with metres, in the window."""

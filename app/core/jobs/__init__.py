"""Work off the window's thread: progress, cancel, the newest request wins."""

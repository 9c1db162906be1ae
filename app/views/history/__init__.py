"""What was done: listed, gone back to, undone alone."""

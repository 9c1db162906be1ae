"""Two versions of the tracks beside each other: what differs, what of it is taken."""

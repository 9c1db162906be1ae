"""Places on the floor in the pictures of both cameras, and people as marks there."""

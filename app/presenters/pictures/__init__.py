"""What is drawn on the pictures of both eyes and on the floor from above."""

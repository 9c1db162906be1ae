"""What is drawn on the pictures of both cameras and on the floor from above."""

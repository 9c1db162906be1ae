"""The pictures of both cameras and the floor from above, with what is drawn on them."""

"""The pictures of both eyes and the floor from above, with what is drawn on them."""

"""The pictures of both cameras and the overhead view."""

"""The particle filter, batched over people."""

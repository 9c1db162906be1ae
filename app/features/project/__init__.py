"""A project: a folder of recordings as a list."""

"""What the catalogue says of our own trackers: a module a folder, imported when asked for."""

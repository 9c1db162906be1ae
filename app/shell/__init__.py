"""The window: it composes the features, and opens, saves and closes documents."""

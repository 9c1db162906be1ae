"""A folder for each subject. Features do not import each other; they meet in `app.core`."""

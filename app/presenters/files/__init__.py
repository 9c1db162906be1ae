"""Documents opened, kept, exported; backups; the first page."""

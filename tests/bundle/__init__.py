"""A folder with its own Python, as an archive and as a Debian package: `python -m tests.bundle`."""

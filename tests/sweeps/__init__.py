"""Long searches for what breaks: not part of `make test`, see `make help`."""

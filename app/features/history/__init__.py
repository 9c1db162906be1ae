"""The log of edits: list, filter, undo of one edit."""

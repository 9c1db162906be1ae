"""The session document, its file and its journal."""

"""How long what is said of tracks may be."""

LONGEST_NAME, LONGEST_KEY, LONGEST_VALUE = 200, 100, 2_000
"""Characters of a name, and of an attribute's key and text."""

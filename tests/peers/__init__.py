"""Other programs of the field, each in an environment of its own, to compare with."""

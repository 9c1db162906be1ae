"""Labelling: which tool is at work, and what people drew and said."""

"""The log of edits: as text, undone and redone, one edit undone alone, what each touches."""

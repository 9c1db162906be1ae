"""What a run and its edits tell of people, and places that are worth a look."""

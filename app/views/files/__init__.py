"""Documents on their way from disk and back: open, save, restore, export, leave."""

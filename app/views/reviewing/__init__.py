"""The review queue: looked for, listed, walked and decided."""

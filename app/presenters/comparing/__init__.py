"""Other versions of the tracks beside the corrected ones: runs, and other sessions."""

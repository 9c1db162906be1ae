"""The published trackers, a module each, behind one protocol."""

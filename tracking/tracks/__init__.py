"""The columnar track table, runs and labels."""

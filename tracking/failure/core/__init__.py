"""The detector, what it judges by, and the samples it learns from."""

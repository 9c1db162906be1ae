"""Counting people in the open recording: what is counted, and what the views show of it."""

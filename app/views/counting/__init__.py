"""Counting people in the open recording: the panel, its plots and its table, the flow map."""

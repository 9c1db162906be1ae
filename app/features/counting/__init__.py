"""Passages over lines, people in regions, the flow map."""

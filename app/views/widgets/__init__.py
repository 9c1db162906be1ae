"""Pieces that every part of the window is made of or speaks through."""

"""Kinds of recordings that other programs make: a module each, and the catalogue."""

"""Cameras, the floor and calibration files."""

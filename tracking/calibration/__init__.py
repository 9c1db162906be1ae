"""Cameras calibrated and floors found from footage: boards, matched points, people, planes."""

"""Whose definitions hold where the field's programs differ."""

from __future__ import annotations

from enum import StrEnum


class Conventions(StrEnum):
    """The program whose numbers are reproduced.

    They differ in CLEAR and in the treatment of don't-cares; HOTA is always TrackEval's.
    """

    TRACKEVAL = "trackeval"
    MOTMETRICS = "py-motmetrics"

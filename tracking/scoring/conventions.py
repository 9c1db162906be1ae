"""Whose definitions hold where the field's programs differ."""

from __future__ import annotations

from enum import StrEnum


class Conventions(StrEnum):
    """The program whose numbers are reproduced.

    They differ in CLEAR and in the treatment of don't-cares; HOTA is always TrackEval's.
    """

    TRACKEVAL = "trackeval"
    MOTMETRICS = "py-motmetrics"

    def reported_matches(self, matches: int, id_switches: int) -> int:
        """The figure `matches`: py-motmetrics reports a switch as a switch alone.

        Args:
            matches: rows of people with a partner, switches among them.
        """
        return matches - id_switches if self is Conventions.MOTMETRICS else matches

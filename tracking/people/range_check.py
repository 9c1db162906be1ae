"""Whether what moves can be ranged at all, over a whole run."""

from __future__ import annotations

from tracking.people.observation import Overlays

_EVERY_PX = 8
_LEAST_SHARE = 0.2
"""Of cameras in their places a quarter is ranged at the least, of swapped ones hardly a sixth."""
_LEAST_SEEN = 200


class RangedShare:
    """Counts how much of the foreground gets a distance, on a coarse grid of pixels."""

    def __init__(self) -> None:
        """Nothing is seen yet."""
        self._seen = self._ranged = 0

    def add(self, overlays: Overlays) -> None:
        """Take in one frame; without stereo it says nothing."""
        seen, ranged = overlays.ranged(_EVERY_PX)
        self._seen += seen
        self._ranged += ranged

    @property
    def is_too_small(self) -> bool:
        """Whether enough moved to tell, and hardly any of it could be ranged."""
        return self._seen >= _LEAST_SEEN and self._ranged < _LEAST_SHARE * self._seen

"""Which lanes of the timeline are in sight: how high they are, and how far down one looks."""

from __future__ import annotations

from PySide6.QtCore import QRectF

from app.features.timeline.rows import LaneRows
from app.features.timeline.scroll_bars import LanesBar

_LEAST_LOWERED = 0.7
"""Lanes lower than this share of their height would be hard to read."""


class LaneScroll:
    """Moves the bar beside the lanes; heights are in widget units."""

    def __init__(self, bar: LanesBar, rows: LaneRows) -> None:
        self._bar, self._rows = bar, rows
        self._area, self._chosen = QRectF(), 1.0
        self._lowered = 1.0

    @property
    def height(self) -> float:
        """Of a lane, by font and the user's choice; lower where all selected must be seen."""
        return float(round(self._chosen * self._lowered))

    @property
    def offset(self) -> float:
        """How far down one looks."""
        return float(self._bar.value())

    @property
    def in_sight(self) -> tuple[int, int]:
        """The rows of which anything is seen, half-open; may go past the last."""
        lowest = self.offset + self._area.height()
        return int(self.offset // self.height), int(lowest // self.height) + 1

    def fit(self, area: QRectF, chosen: float) -> None:
        """Lanes lie in another area, or are to be of another height."""
        self._area, self._chosen = area, chosen
        self._bar.fit(area, len(self._rows) * self.height, self.height)

    def scroll(self, lanes: float) -> None:
        """Further down by so many lanes, or up."""
        self._bar.setValue(round(self._bar.value() + lanes * self.height))

    def reveal(self, tracks: tuple[int, ...]) -> bool:
        """Scroll to the lanes of these; a little lower ones where only so all of them are seen.

        Returns:
            Whether lanes are of another height now.
        """
        rows = [row for row in map(self._rows.row_of, tracks) if row is not None]
        lowered = self._lower_for(1 + max(rows) - min(rows) if rows else 1)
        for row in sorted(rows, reverse=True):
            self._reveal_row(row)
        return lowered

    def follow(self, frame: int) -> None:
        """Scroll to somebody who is there at a frame where nobody in sight is."""
        there = self._rows.living_at(frame)
        first, stop = self.in_sight
        if len(there) and not ((there >= first) & (there < stop)).any():
            self._reveal_row(int(there[-1]))
            self._reveal_row(int(there[0]))

    def row_at(self, down: float) -> int:
        """The row so far below the upper edge of the lanes."""
        return int((down + self.offset) // self.height)

    def _lower_for(self, lanes: int) -> bool:
        """Make lanes so low that so many are seen at once, where they stay readable."""
        before, self._lowered = self._lowered, 1.0
        share = self._area.height() / (lanes * self.height)
        if _LEAST_LOWERED <= share < 1.0:
            self._lowered = int(share * self.height) / self.height
        if self._lowered == before:
            return False
        self.fit(self._area, self._chosen)
        return True

    def _reveal_row(self, row: int) -> None:
        top = round(row * self.height)
        lowest = top - self._area.height() + self.height
        self._bar.setValue(min(max(self._bar.value(), round(lowest)), top))

"""What follows the tracks of a document as they change."""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence

from app.core.scenes import TimelineMark
from app.core.tracks.track_reader import WholeTracks
from tracking.editing import Change
from tracking.trackers import StepResult
from tracking.tracks import ReviewedRange

Marks = Mapping[int, tuple[TimelineMark, ...]]
"""Marks of edits, by track."""


class DocumentListener:
    """Is told of every change of the tracks that are shown. Does nothing where not overridden."""

    def take_tracks(
        self, tracks: WholeTracks, marks: Marks, reviewed: tuple[ReviewedRange, ...]
    ) -> None:
        """Other tracks are shown."""

    def take_live(self, tracks: WholeTracks, results: Iterable[StepResult]) -> None:
        """The tracker at work, whose tracks are shown, is further."""

    def take_change(
        self,
        change: Change,
        tracks: WholeTracks,
        marks: Marks,
        reviewed: tuple[ReviewedRange, ...],
    ) -> None:
        """Some tracks were edited."""

    def take_review_items(self, review_items: Sequence[TimelineMark]) -> None:
        """What may be wrong is marked, instead of what was marked before."""

    def colour_anew(self) -> None:
        """Tracks have other colours by now."""

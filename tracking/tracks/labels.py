"""What people say about tracks and the picture: frozen values, changed by making new ones."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field, replace


@dataclass(frozen=True, slots=True)
class TrackLabel:
    """What is known of one track besides its rows.

    Attributes:
        name: e.g. "red coat"; "" where none was given.
        attributes: own fields, e.g. {"bag": "yes"}.
        notes: free text.
    """

    name: str = ""
    attributes: Mapping[str, str] = field(default_factory=dict)
    notes: str = ""

    @property
    def is_empty(self) -> bool:
        """Whether nothing was said."""
        return not (self.name or self.attributes or self.notes)


@dataclass(frozen=True, slots=True)
class Occluder:
    """Something in the picture people pass behind.

    Attributes:
        name: e.g. "pillar".
        polygon: corners u, v in pixels of the left image as recorded; at least three.
    """

    name: str
    polygon: tuple[tuple[float, float], ...]


@dataclass(frozen=True, slots=True, order=True)
class ReviewedRange:
    """Frames a person has looked at and found right.

    Attributes:
        track: the track looked at; 0: all of them.
        start, end: half-open range of frames.
    """

    track: int
    start: int
    end: int


@dataclass(frozen=True, slots=True)
class Labels:
    """Everything people said. A track without an entry has an empty label."""

    tracks: Mapping[int, TrackLabel] = field(default_factory=dict)
    occluders: tuple[Occluder, ...] = ()
    reviewed: tuple[ReviewedRange, ...] = ()

    def of_track(self, track: int) -> TrackLabel:
        """The track's label; empty where nothing was said."""
        return self.tracks.get(track, TrackLabel())

    def title(self, track: int) -> str:
        """The track as people read it, e.g. "4 red coat", or only its number."""
        return f"{track} {self.of_track(track).name}".rstrip()

    def with_track(self, track: int, label: TrackLabel) -> Labels:
        """These labels with another label for the track; an empty one is left out."""
        others = {known: old for known, old in self.tracks.items() if known != track}
        if not label.is_empty:
            others[track] = label
        return replace(self, tracks=dict(sorted(others.items())))

    def is_reviewed(self, track: int, frame: int) -> bool:
        """Whether a person has looked at the track, or at all tracks, in this frame."""
        return any(
            seen.track in (0, track) and seen.start <= frame < seen.end for seen in self.reviewed
        )

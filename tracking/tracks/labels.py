"""What people say about tracks and the picture: frozen values, changed by making new ones."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field, replace

from tracking.tracks.attribute_schema import Schema
from tracking.tracks.part_labels import PartLabels

VerdictKey = tuple[str, tuple[int, ...], int]
"""kind, tracks and frame of a review item."""
Point = tuple[float, float]

DECISIONS = ("right", "fixed", "dismissed")
"""What can be said of a review item: looked at and nothing wrong, put right, not worth a look."""


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


@dataclass(frozen=True, slots=True, order=True)
class Occluder:
    """Something in the picture people pass behind.

    Attributes:
        name: e.g. "pillar".
        polygon: corners u, v in pixels of the left image as recorded; at least three.
    """

    name: str
    polygon: tuple[Point, ...]


@dataclass(frozen=True, slots=True, order=True)
class CountingLine:
    """A line on the floor, or in the picture, over which passages are counted.

    Forward crosses from the left-hand side, looking from start to end, to the right-hand side:
    as seen from above on the floor, as it is seen on the screen in the picture.

    Attributes:
        name: e.g. "entrance"; unique among the lines.
        start, end: x, y in metres on the floor, or u, v in pixels of the left image as recorded.
        in_picture: the latter; people are counted where the foot of their box crosses.
    """

    name: str
    start: Point
    end: Point
    in_picture: bool = False


@dataclass(frozen=True, slots=True, order=True)
class Region:
    """A part of the floor, or of the picture, in which people are counted.

    Attributes:
        name: e.g. "waiting area"; unique among the regions.
        polygon: corners, at least three, whose edges do not cross: x, y in metres on the floor,
            or u, v in pixels of the left image as recorded.
        in_picture: the latter; people are counted where the foot of their box is inside.
    """

    name: str
    polygon: tuple[Point, ...]
    in_picture: bool = False


@dataclass(frozen=True, slots=True, order=True)
class ReviewedRange:
    """Frames a person has looked at and found right.

    It is about what bears the track's id in these frames, whoever that is by then: where rows
    change their identity inside it (swap, merge, reassign) it stays, as the person who does that
    looks there; rows that leave it for another id (split, too) are not reviewed under that one.

    Attributes:
        track: the track looked at; 0: all of them.
        start, end: half-open range of frames.
    """

    track: int
    start: int
    end: int


@dataclass(frozen=True, slots=True, order=True)
class Verdict:
    """What a person decided about one review item.

    Attributes:
        kind, tracks, frame: which review item it was; see `key`.
        decision: one of `DECISIONS`.
    """

    kind: str
    tracks: tuple[int, ...]
    frame: int
    decision: str

    @property
    def key(self) -> VerdictKey:
        """What tells one review item from another."""
        return self.kind, self.tracks, self.frame


@dataclass(frozen=True, slots=True)
class Labels:
    """Everything people said. A track without an entry has an empty label.

    Attributes:
        tracks: by track, ascending.
        occluders, lines, regions: sorted by name; reviewed: by track and frame.
        verdicts: by the review item's key.
        parts: rectangles of body parts, by frame, track and part.
        schema: which attributes people have, in the order in which they are shown.
    """

    tracks: Mapping[int, TrackLabel] = field(default_factory=dict)
    occluders: tuple[Occluder, ...] = ()
    reviewed: tuple[ReviewedRange, ...] = ()
    lines: tuple[CountingLine, ...] = ()
    regions: tuple[Region, ...] = ()
    verdicts: Mapping[VerdictKey, Verdict] = field(default_factory=dict)
    parts: PartLabels = field(default_factory=PartLabels)
    schema: Schema = ()

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

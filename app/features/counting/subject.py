"""What is counted: whose tracks, over which lines and in which regions, and in which way."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass

from app.core.document.track_sources import Load, Version
from app.core.i18n import tr
from tracking.counting import (
    CountingLine,
    Counts,
    CountSettings,
    FlowMap,
    Occupancy,
    Region,
    check_countable,
    count,
    flow_map,
)
from tracking.errors import CountingError
from tracking.progress import Progress
from tracking.tracks import Columns

Bounds = tuple[float, float, float, float]


@dataclass(frozen=True, slots=True)
class CountSubject:
    """What is asked for. Two that are equal are counted alike.

    Attributes:
        track_source: `SHOWN` or a run's number. version: tells these tracks from others.
        lines, regions: in the order of the labels. settings: see `CountSettings`.
        mapped: the flow map is asked for, too.
    """

    track_source: int
    version: Version
    lines: tuple[CountingLine, ...]
    regions: tuple[Region, ...]
    settings: CountSettings
    mapped: bool = False

    @property
    def is_empty(self) -> bool:
        """Whether nothing is to be worked out."""
        return not (self.lines or self.regions or self.mapped)


@dataclass(frozen=True, slots=True, eq=False)
class CountResult:
    """What came of a subject.

    Attributes:
        subject: it. counts: over those of its lines and in those of its regions that can be
            counted, in their order.
        flow: the flow map; None where it was not asked for.
        left_out: the lines and regions that cannot be counted, each with why.
    """

    subject: CountSubject
    counts: Counts
    flow: FlowMap | None = None
    left_out: tuple[tuple[Drawn, str], ...] = ()

    def place_of(self, line: CountingLine) -> int | None:
        """Which of the counted lines it is; None: it was not counted."""
        return next((n for n, one in enumerate(self.counts.lines) if one.line == line), None)

    def occupancy_of(self, region: Region) -> Occupancy | None:
        """What was counted in a region; None: nothing was."""
        return next((one for one in self.counts.regions if one.region == region), None)

    def why_not(self, is_line: bool, name: str) -> str:
        """Why the line or the region of this name is left out; "" where it is not."""
        sort = CountingLine if is_line else Region
        found = (why for one, why in self.left_out if isinstance(one, sort) and one.name == name)
        return next(found, "")


Drawn = CountingLine | Region


@dataclass(frozen=True, slots=True)
class Length:
    """How long people were tracked.

    Attributes:
        fps, frame_count: of the recording. frames: the half-open range that the tracks go over.
    """

    fps: float
    frame_count: int
    frames: tuple[int, int]


def count_subject(
    subject: CountSubject, load: Load, length: Length, bounds: Bounds, report: Progress
) -> CountResult:
    """Count what can be counted; a line of which nothing is known leaves the others alone.

    Args:
        bounds: left, bottom, right and top of the floor that is worth mapping, m.
        report: told how far it is; may raise CancelledError.

    Raises:
        CountingError: nothing can be counted so, e.g. in steps shorter than a frame.
    """
    columns, fps = load(), length.fps
    report(1, 3)
    left_out = tuple(_left_out(subject, columns))
    without = {one for one, _ in left_out}
    lines = [line for line in subject.lines if line not in without]
    regions = [region for region in subject.regions if region not in without]
    counts = count(columns, fps, length.frame_count, lines, regions, subject.settings)
    report(2, 3)
    flow = flow_map(columns, fps, length.frames, bounds=bounds) if subject.mapped else None
    return CountResult(subject, counts, flow, left_out)


def _left_out(subject: CountSubject, columns: Columns) -> Iterator[tuple[Drawn, str]]:
    """What lies where these tracks have no places, each with why."""
    for line in subject.lines:
        if why := _why_not(columns, lines=(line,)):
            yield line, why
    for region in subject.regions:
        if why := _why_not(columns, regions=(region,)):
            yield region, why


def _why_not(
    columns: Columns, lines: tuple[CountingLine, ...] = (), regions: tuple[Region, ...] = ()
) -> str:
    try:
        check_countable(columns, lines, regions)
    except CountingError as error:
        return tr(error.message)
    return ""

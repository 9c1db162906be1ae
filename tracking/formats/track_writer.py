"""Tracks on their way into a file of another tool, a piece at a time."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, field
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from tracking.errors import FormatError
from tracking.progress import Progress, no_progress
from tracking.tracks import Columns, ParticleColumn, Schema, TrackLabel, TrackTable

if TYPE_CHECKING:
    from tracking.geometry import View

LEAST_CONFIDENCE = np.float32(1e-6)
"""Of a row that counts though its tracker was not sure at all: a 0 would say that it does not."""

_TRUTH_FILES, _TRUTH_FOLDERS = ("gt.txt", "truth.txt"), ("gt", "label_02")
"""MOTChallenge's `gt/gt.txt`, KITTI's `label_02/0000.txt`, and `truth.txt` of recordings here."""

ROWS_AT_ONCE = 1 << 14
"""A piece stays in the processor's cache, and is long beside the work around it."""


@dataclass(frozen=True, slots=True, eq=False)
class Exported:
    """What is written: tracks, and what is known of their footage.

    Attributes:
        rows: `CORRECTED_COLUMNS` by frame then track, read by slices; they may stand elsewhere
            than in memory.
        table: the same tracks, for formats that are written track by track; None where `rows`
            stand nowhere else, and then it is made of them.
        frames: how many the footage has. fps: frames a second. size_px: width and height.
        name: of the recording.
        labels: of tracks; the attribute "class" is what kind of thing it is, a person without one.
        schema: which attributes people have.
        view: the left camera over its floor; None where it is not known.
        corrected: they are the corrected tracks, not those of a run as the tracker left them.
        ground_truth: they are written as ground truth; else where they are written decides.
        dont_cares: rows of confidence 0 do not count, as a ground truth that was imported says;
            else every row counts, however sure a tracker was of it.
    """

    rows: Mapping[str, ParticleColumn]
    table: TrackTable | None = None
    frames: int = 0
    fps: float | None = None
    size_px: tuple[int, int] | None = None
    name: str = ""
    labels: Mapping[int, TrackLabel] = field(default_factory=dict)
    schema: Schema = ()
    view: View | None = None
    corrected: bool = False
    ground_truth: bool = False
    dont_cares: bool = False

    @classmethod
    def of_table(cls, table: TrackTable, **known: Any) -> Exported:
        """The tracks of a table; known: any other attribute."""
        return cls(table.in_order(), table, **{"frames": table.frame_stop, **known})

    def __len__(self) -> int:
        """The number of rows."""
        return len(self.rows["frame"])

    def pieces(
        self, report: Progress = no_progress, rows_at_once: int = ROWS_AT_ONCE
    ) -> Iterator[dict[str, NDArray[Any]]]:
        """All rows by frame then track, so many at once; report may raise to cancel."""
        count = len(self)
        for start in range(0, count, rows_at_once):
            report(start, count)
            piece = slice(start, min(start + rows_at_once, count))
            yield {name: column[piece] for name, column in self.rows.items()}
        report(count, count)

    def frame_by_frame(
        self, report: Progress = no_progress
    ) -> Iterator[tuple[int, dict[str, NDArray[Any]]]]:
        """Each frame that has rows, with its rows by track."""
        rest: dict[str, NDArray[Any]] | None = None
        for piece in self.pieces(report):
            rows = piece if rest is None else _joined(rest, piece)
            *whole, rest = _cut(rows, np.flatnonzero(np.diff(rows["frame"])) + 1)
            yield from ((int(rows["frame"][0]), rows) for rows in whole)
        if rest is not None:
            yield int(rest["frame"][0]), rest

    def track_by_track(
        self, report: Progress = no_progress
    ) -> Iterator[tuple[int, dict[str, NDArray[Any]]]]:
        """Each track, ascending, with its rows by frame."""
        table = self.table
        if table is None:
            table = TrackTable({name: column[0 : len(self)] for name, column in self.rows.items()})
        done, count = 0, len(self)
        for track in table.track_ids:
            report(done, count)
            rows = table.of_track(track)
            yield track, rows
            done += len(rows["frame"])
        report(count, count)

    def tracks_with_boxes(
        self, path: Path, what: str, report: Progress = no_progress
    ) -> Iterator[tuple[int, dict[str, NDArray[Any]]]]:
        """Each track that has boxes, ascending, with its rows that have one, by frame.

        Raises FormatError, which names the path and `what` format it is, where nobody has any.
        """
        anybody = False
        for track, rows in self.track_by_track(report):
            boxed = np.isfinite(rows["left"])
            if boxed.any():
                anybody = True
                yield track, {name: column[boxed] for name, column in rows.items()}
        if not anybody:
            raise nobody_boxed(path, what)

    @property
    def track_ids(self) -> Sequence[int]:
        """The tracks there are, ascending."""
        if self.table is not None:
            return self.table.track_ids
        ids = np.asarray(self.rows["track"][0 : len(self)])
        return [int(track) for track in np.unique(ids)]

    @property
    def frame_stop(self) -> int:
        """How many frames there are in footage and tracks."""
        count = len(self)
        return max(self.frames, int(self.rows["frame"][count - 1 : count].max(initial=-1)) + 1)

    def label(self, track: int) -> TrackLabel:
        """The track's label; empty where nothing was said."""
        return self.labels.get(track, TrackLabel())

    def is_ground_truth(self, path: Path) -> bool:
        """Whether a file there is ground truth, as asked for or by where scorers look for it."""
        named = path.name in _TRUTH_FILES or path.absolute().parent.name in _TRUTH_FOLDERS
        return self.ground_truth or named

    def counted(self, rows: Columns) -> NDArray[np.bool_]:
        """(n,) which of some rows count in ground truth."""
        if not self.dont_cares:
            return np.ones(len(rows["frame"]), bool)
        return np.asarray(rows["confidence"] != 0)

    def confidence(self, rows: Columns) -> NDArray[np.float32]:
        """(n,) confidence of some rows; 0 only where a row does not count."""
        found = np.asarray(rows["confidence"], np.float32)
        return np.where(self.counted(rows) & (found == 0), LEAST_CONFIDENCE, found)


def nobody_boxed(path: Path, what: str) -> FormatError:
    """The error where a format of boxes is to hold tracks without any."""
    return FormatError(
        "{path}: nobody has a box, and {what} holds nothing else", path=path, what=what
    )


def _cut(rows: Columns, cuts: NDArray[np.int64]) -> list[dict[str, NDArray[Any]]]:
    """Rows parted at the given places."""
    parted = {name: np.split(column, cuts) for name, column in rows.items()}
    return [{name: parts[at] for name, parts in parted.items()} for at in range(len(cuts) + 1)]


def _joined(first: Columns, second: Columns) -> dict[str, NDArray[Any]]:
    """The rows of one piece behind those of the other."""
    return {name: np.concatenate([first[name], second[name]]) for name in first}

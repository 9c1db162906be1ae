"""What a tracker at work has found so far."""

from __future__ import annotations

from array import array
from collections.abc import Callable, Iterable, Sequence

import numpy as np
from numpy.typing import NDArray

from app.core.tracks.track_reader import Spans, TrackReader, WholeTracks, concatenate
from tracking.pipeline import KeptSteps
from tracking.trackers import StepResult
from tracking.tracks import PART_COLUMNS, TRACK_COLUMNS, Columns, empty


class LiveTracks:
    """Results of a tracker at work, as they come in order.

    Args:
        kept: where whoever runs the tracker keeps its steps before they are taken here; None:
            they are kept here.
    """

    def __init__(self, kept: KeptSteps | None = None) -> None:
        self._kept, self._keeps = kept or KeptSteps(), kept is None
        self._first = 0
        self._spans: dict[int, list[list[int]]] = {}
        self._made: dict[int, Spans] = {}  # of tracks that did not change since they were asked for
        self._people = array("H")
        # Of the track whose parts were asked for last: its id, until which frame, the rows.
        self._parts: tuple[int, int, Columns] = (0, 0, empty(PART_COLUMNS))

    def extend(self, results: Iterable[StepResult]) -> None:
        """Take further frames."""
        for step in results:
            if not self._people:
                self._first = step.frame
            if self._keeps:
                self._kept.add((step,))
            self._people.append(len(step.tracks["track"]))
            predicted = step.tracks["predicted"].tolist()
            for track, lost in zip(step.tracks["track"].tolist(), predicted, strict=True):
                self._lengthen(track, step.frame, int(lost))

    @property
    def frames(self) -> tuple[int, int]:
        """The frames tracked so far."""
        return self._first, self._first + len(self._people)

    @property
    def ids(self) -> Sequence[int]:
        """All tracks so far."""
        return sorted(self._spans)

    def of_frame(self, frame: int) -> Columns:
        """The frame's rows; none where it was not tracked yet."""
        return self._rows("tracks", frame, frame + 1)

    def recent(self, frame: int, back: int) -> Columns:
        """The rows of the frame's people, from `back` frames before it."""
        rows = self._rows("tracks", frame - back, frame + 1)
        mine = np.isin(rows["track"], self.of_frame(frame)["track"])
        return {name: column[mine] for name, column in rows.items()}

    def of_track(self, track: int) -> Columns:
        """The rows of a track."""
        spans = self._spans.get(track)
        if not spans:
            return empty(TRACK_COLUMNS)
        rows = self._rows("tracks", spans[0][0], spans[-1][1])
        mine = rows["track"] == track
        return {name: column[mine] for name, column in rows.items()}

    def detections(self, frame: int) -> Columns:
        """What was measured in the frame."""
        return self._rows("detections", frame, frame + 1)

    def particles(self, frame: int) -> Columns:
        """The frame's particles."""
        return self._rows("particles", frame, frame + 1)

    def parts(self, frame: int) -> Columns:
        """The frame's parts."""
        return self._rows("parts", frame, frame + 1)

    def part_particles(self, frame: int) -> Columns:
        """The particles of the frame's parts."""
        return self._rows("part_particles", frame, frame + 1)

    def tracklets(self, frame: int) -> Columns:
        """The frame's tracklets."""
        return self._rows("tracklets", frame, frame + 1)

    def network_boxes(self, frame: int) -> Columns:
        """What a network found in the frame."""
        return self._rows("network_boxes", frame, frame + 1)

    def signals(self, frame: int) -> Columns:
        """What was noticed of the frame's people."""
        return self._rows("signals", frame, frame + 1)

    def parts_of_track(self, track: int) -> Columns:
        """The parts of a track so far."""
        known, until, rows = self._parts
        stop = self.frames[1]
        if known != track:
            until, rows = self._first, empty(PART_COLUMNS)
        if until < stop:
            new = self._rows("parts", until, stop)
            mine = new["track"] == track
            rows = {name: np.concatenate((rows[name], new[name][mine])) for name in rows}
        self._parts = (track, stop, rows)
        return rows

    def spans(self, tracks: Iterable[int] | None = None) -> dict[int, Spans]:
        """The stretches so far."""
        for track, rows in self._spans.items():
            if track not in self._made:
                self._made[track] = np.array(rows, np.int64)
        asked = self._made if tracks is None else set(tracks) & self._made.keys()
        return {track: self._made[track] for track in asked}

    def keyframes(
        self,
        tracks: Iterable[int] | None = None,  # noqa: ARG002 - part of `TrackReader`
    ) -> dict[int, NDArray[np.int64]]:
        """None: a tracker is no person."""
        return {}

    def activity(self, frame_count: int) -> NDArray[np.uint16]:
        """People per frame so far."""
        people = np.zeros(frame_count, np.uint16)
        people[self._first : self._first + len(self._people)] = self._people
        return people

    def capture(self, names: Sequence[str]) -> Callable[[], Columns]:
        """Takes hold of all rows so far; they are read frame by frame."""
        parts = self._kept.parts("tracks", *self.frames)
        return lambda: concatenate(parts, names)

    def _rows(self, table: str, start: int, stop: int) -> Columns:
        """Of frames that were taken: more may be kept already."""
        first, until = self.frames
        start = min(max(start, first), until)
        return self._kept.rows(table, start, min(max(start, stop), until))

    def _lengthen(self, track: int, frame: int, predicted: int) -> None:
        spans = self._spans.setdefault(track, [])
        self._made.pop(track, None)
        if spans and spans[-1][1] == frame and spans[-1][2] == predicted:
            spans[-1][1] = frame + 1
        else:
            spans.append([frame, frame + 1, predicted])


class ContinuedTracks:
    """Corrected tracks up to a frame, and from it on what a tracker finds that goes on from them.

    The corrected tracks do not change while a tracker is at work: what they look like before the
    frame is made once, however often the tracker's part grows.
    """

    def __init__(self, before: WholeTracks, frame: int, live: LiveTracks) -> None:
        self._before, self._frame, self._live = before, frame, live
        early = {track: _until(spans, frame) for track, spans in before.spans().items()}
        self._early: dict[int, Spans] = {track: part for track, part in early.items() if len(part)}
        self._keyframes = {track: one[one < frame] for track, one in before.keyframes().items()}
        self._both: dict[int, tuple[Spans, Spans]] = {}  # the tracker's part, and both

    @property
    def frames(self) -> tuple[int, int]:
        """What was tracked before the frame, and since."""
        first, stop = self._live.frames
        return self._before.frames[0], max(self._frame, stop if stop > first else 0)

    @property
    def ids(self) -> Sequence[int]:
        """All tracks that are shown."""
        return sorted(self._early.keys() | set(self._live.ids))

    def of_frame(self, frame: int) -> Columns:
        """The frame's rows."""
        return self._part(frame).of_frame(frame)

    def recent(self, frame: int, back: int) -> Columns:
        """The rows of the frame's people, from `back` frames before it."""
        start = frame - back
        if frame < self._frame or start >= self._frame:
            return self._part(frame).recent(frame, back)
        here = self.of_frame(frame)["track"]
        early = self._before.recent(self._frame - 1, self._frame - 1 - start)
        rows = concatenate([early, self._live.recent(frame, frame - self._frame)])
        mine = np.isin(rows["track"], here)
        return {name: column[mine] for name, column in rows.items()}

    def of_track(self, track: int) -> Columns:
        """The rows of a track."""
        rows = self._before.of_track(track)
        early = rows["frame"] < self._frame
        return concatenate([{n: rows[n][early] for n in rows}, self._live.of_track(track)])

    def detections(self, frame: int) -> Columns:
        """What was measured in the frame."""
        return self._part(frame).detections(frame)

    def particles(self, frame: int) -> Columns:
        """The frame's particles."""
        return self._part(frame).particles(frame)

    def parts(self, frame: int) -> Columns:
        """The frame's parts."""
        return self._part(frame).parts(frame)

    def part_particles(self, frame: int) -> Columns:
        """The particles of the frame's parts."""
        return self._part(frame).part_particles(frame)

    def tracklets(self, frame: int) -> Columns:
        """The frame's tracklets."""
        return self._part(frame).tracklets(frame)

    def network_boxes(self, frame: int) -> Columns:
        """What a network found in the frame."""
        return self._part(frame).network_boxes(frame)

    def signals(self, frame: int) -> Columns:
        """What was noticed of the frame's people."""
        return self._part(frame).signals(frame)

    def parts_of_track(self, track: int) -> Columns:
        """The parts of a track."""
        rows = self._before.parts_of_track(track)
        early = rows["frame"] < self._frame
        late = self._live.parts_of_track(track)
        return {name: np.concatenate((rows[name][early], late[name])) for name in late}

    def spans(self, tracks: Iterable[int] | None = None) -> dict[int, Spans]:
        """The stretches of every track, or of some."""
        shown = {**self._early, **self._joined(self._live.spans())}
        if tracks is None:
            return shown
        return {track: shown[track] for track in set(tracks) & shown.keys()}

    def keyframes(self, tracks: Iterable[int] | None = None) -> dict[int, NDArray[np.int64]]:
        """The frames before the tracker's whose row a person made."""
        asked = self._keyframes if tracks is None else set(tracks) & self._keyframes.keys()
        return {track: self._keyframes[track] for track in asked if len(self._keyframes[track])}

    def activity(self, frame_count: int) -> NDArray[np.uint16]:
        """People per frame."""
        people = self._live.activity(frame_count)
        people[: self._frame] = self._before.activity(frame_count)[: self._frame]
        return people

    def capture(self, names: Sequence[str]) -> Callable[[], Columns]:
        """Takes hold of all rows of now; they are read from the frame's both sides."""
        early, late, frame = self._before.capture(names), self._live.capture(names), self._frame

        def read() -> Columns:
            before = early()
            kept = before["frame"] < frame
            return concatenate([{name: before[name][kept] for name in names}, late()], names)

        return read

    def _part(self, frame: int) -> TrackReader:
        return self._before if frame < self._frame else self._live

    def _joined(self, late: dict[int, Spans]) -> dict[int, Spans]:
        """The tracker's stretches behind the earlier ones; the same arrays while they are equal."""
        for track, spans in late.items():
            if track not in self._both or self._both[track][0] is not spans:
                early = self._early.get(track)
                whole = spans if early is None else np.concatenate((early, spans))
                self._both[track] = (spans, whole)
        return {track: self._both[track][1] for track in late}


def _until(spans: Spans, frame: int) -> Spans:
    """The stretches before a frame, the last one cut there."""
    early = spans[spans[:, 0] < frame].copy()
    early[:, 1] = np.minimum(early[:, 1], frame)
    return early

"""A tracker that only says who is who: everything else a tracker needs, for short trackers."""

from __future__ import annotations

from abc import ABC, abstractmethod
from collections.abc import Iterable
from dataclasses import dataclass, fields
from typing import Any, Generic, TypeVar

import numpy as np
from numpy.typing import NDArray

from tracking.people import Detections
from tracking.people.observation import Observation
from tracking.trackers.shared.protocol import ASSOCIATION_COLUMNS, StepResult
from tracking.trackers.shared.result_columns import detection_columns, track_columns
from tracking.trackers.shared.resumption import Resume
from tracking.trackers.shared.tracker_base import TrackerBase
from tracking.tracks.columns import (
    PARTICLE_COLUMNS,
    TRACKLET_COLUMNS,
    Columns,
    boxes_of,
    empty,
    places_of,
    typed,
)

SettingsT = TypeVar("SettingsT")
Floats = NDArray[np.float64]


@dataclass(frozen=True, slots=True, eq=False)
class Known:
    """People who are known from frames before, a row each.

    Attributes:
        track: (n,) their ids.
        box: (n, 4) left, top, width, height px when they were seen last.
        place: (n, 2) m on the floor then; NaN: not known.
        unseen_s: (n,) seconds since then; of who was seen in the last frame the time of a frame.
        path: (n, 3, 2) px, middles of their last three boxes, newest first; NaN: there was none.
    """

    track: NDArray[np.int32]
    box: Floats
    place: Floats
    unseen_s: Floats
    path: Floats

    def __len__(self) -> int:
        """The number of people."""
        return len(self.track)

    def rows(self, kept: NDArray[Any]) -> Known:
        """Some of the people."""
        return Known(*(getattr(self, one.name)[kept] for one in fields(self)))


class IdTracker(TrackerBase[SettingsT], ABC, Generic[SettingsT]):
    """Follows people by what a subclass says of each frame: which detection is whom.

    A setting `memory_s` is how long somebody is remembered who is not seen; without it a second.
    The result has a row for everybody who is seen, and tracklets of their last three places.
    """

    def __init__(self, settings: SettingsT) -> None:
        """Before the first frame."""
        super().__init__(settings)
        self._known = _nobody()

    @abstractmethod
    def associate(self, known: Known, people: Detections) -> NDArray[np.int32]:
        """Who is who in a frame.

        Args:
            known: people of frames before. people: who is seen now.

        Returns:
            (people,) the id of each, one of `known.track`; 0: somebody new.
        """

    def resume(self, resume: Resume, observations: Iterable[Observation]) -> None:
        """Go on with the people as corrected, where they stand in the last frame that shows them.

        Those are remembered who are seen in the frame before, or less than `memory_s` before it.
        """
        time_s = (resume.frame - 1) / resume.fps
        for observation in observations:
            time_s = observation.time_s
        self._clock.set(time_s)
        track, newest = np.unique(resume.rows["track"][::-1], return_index=True)
        last = len(resume.rows["track"]) - 1 - newest
        rows = {name: column[last] for name, column in resume.rows.items()}
        unseen_s = (resume.frame - 1 - rows["frame"]) / resume.fps
        box = boxes_of(rows)
        known = Known(track.astype(np.int32), box, places_of(rows), unseen_s, _begun(box))
        self._known = known.rows(unseen_s <= self._memory_s)
        self._ids.last = resume.highest_track

    def step(self, observation: Observation) -> StepResult:
        """Take one frame further."""
        people, known = observation.people, self._aged(observation.time_s)
        track = np.array(self.associate(known, people), np.int32)
        new = np.flatnonzero(track == 0)
        track[new] = self._ids.take(len(new))
        seen = Known(
            track,
            people.box,
            people.position[:, :2],
            np.zeros(len(track)),
            _paths(known, track, people.box),
        )
        self._known = _merged(seen, known)
        return _result(observation, seen)

    @property
    def _memory_s(self) -> float:
        return float(getattr(self._settings, "memory_s", 1.0))

    def _aged(self, time_s: float) -> Known:
        """Everybody who is still remembered, with the time that has passed."""
        known, passed_s = self._known, self._clock.elapsed_s(time_s)
        aged = Known(known.track, known.box, known.place, known.unseen_s + passed_s, known.path)
        return aged.rows((aged.unseen_s <= self._memory_s) | (known.unseen_s == 0))


def _nobody() -> Known:
    box = np.zeros((0, 4))
    return Known(np.zeros(0, np.int32), box, np.zeros((0, 2)), np.zeros(0), _begun(box))


def _middles(box: Floats) -> Floats:
    return box[:, :2] + box[:, 2:] / 2


def _begun(box: Floats) -> Floats:
    """(n, 3, 2) paths of people who stand at boxes and were never seen before."""
    path = np.full((len(box), 3, 2), np.nan)
    path[:, 0] = _middles(box)
    return path


def _paths(known: Known, track: NDArray[np.int32], box: Floats) -> Floats:
    """(n, 3, 2) the paths of tracks that are at these boxes now."""
    path, row_of = _begun(box), {one: row for row, one in enumerate(known.track.tolist())}
    for row, one in enumerate(track.tolist()):
        if one in row_of:
            path[row, 1:] = known.path[row_of[one], :2]
    return path


def _merged(seen: Known, known: Known) -> Known:
    """Who is seen, then who is remembered."""
    rest = known.rows(~np.isin(known.track, seen.track))
    pairs = ((getattr(seen, one.name), getattr(rest, one.name)) for one in fields(Known))
    return Known(*(np.concatenate(pair) for pair in pairs))


def _result(observation: Observation, seen: Known) -> StepResult:
    """The frame's rows, sorted by track."""
    order = np.argsort(seen.track)
    position = observation.people.position[order]
    seen = seen.rows(order)
    tracks = track_columns(
        observation.frame,
        seen.track,
        seen.box,
        seen.place,
        np.full((len(seen), 2), np.nan),
        confidence=1.0,
        visibility=1.0,
        predicted=False,
    )
    detections = detection_columns(observation.frame, seen.box, position, seen.track)
    none = empty(PARTICLE_COLUMNS), empty(ASSOCIATION_COLUMNS)
    return StepResult(observation.frame, tracks, detections, *none, tracklets=_tracklets(seen))


def _tracklets(seen: Known) -> Columns:
    """Where each person was in the last three frames."""
    names = ("u0", "v0", "u1", "v1", "u2", "v2")
    places = dict(zip(names, seen.path.reshape(len(seen), 6).T, strict=True))
    feet = {"track": seen.track, "foot_v": np.full(len(seen), np.nan)}
    return typed({**feet, **places}, TRACKLET_COLUMNS)

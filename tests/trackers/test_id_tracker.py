"""Trackers that only say who is who: what they are told of people once tracking goes on."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
import pytest
from numpy.typing import NDArray
from people_on_a_floor import FPS, Walker, observations, straight

from tracking.people import Detections
from tracking.trackers import IdTracker, Resume
from tracking.trackers.shared.id_tracker import Known
from tracking.tracks import CORRECTED_COLUMNS, TrackTable

CUT = 30


@dataclass(frozen=True)
class Settings:
    memory_s: float = 1.0


class Listening(IdTracker[Settings]):
    """Takes everybody for somebody new, and keeps what it was told."""

    told: Known

    def associate(self, known: Known, people: Detections) -> NDArray[np.int32]:
        self.told = known
        return np.zeros(len(people), np.int32)


def _table(last_frames: dict[int, int]) -> TrackTable:
    """People whose rows end at these frames and go on later on, as those of hidden people do."""
    there = [
        (frame, track)
        for frame in range(CUT + 20)
        for track, last in sorted(last_frames.items())
        if frame <= last or frame > CUT + 10
    ]
    rows = {name: np.zeros(len(there), kind) for name, kind in CORRECTED_COLUMNS.items()}
    rows["frame"][:], rows["track"][:] = np.array(there).T
    rows["left"][:] = rows["frame"]
    rows["width"][:], rows["height"][:] = 20.0, 60.0
    rows["visibility"][:] = 1.0
    return TrackTable(rows)


@pytest.mark.parametrize("memory_s", [0.5, 1.0])
def test_people_are_remembered_with_the_time_since_they_were_seen(memory_s: float) -> None:
    hidden = CUT - 1 - round(0.4 * FPS), CUT - 1 - round(0.8 * FPS)
    resume = Resume.of(_table({1: CUT - 1, 2: hidden[0], 3: hidden[1]}), CUT, FPS)
    frames = list(observations([Walker(straight((0, 4), (1, 0), CUT + 2), 3)]))
    tracker = Listening(Settings(memory_s))
    tracker.resume(resume, frames[CUT - 10 : CUT])
    tracker.step(frames[CUT])
    known = tracker.told
    expected = {1: 0.0, 2: 0.4, 3: 0.8} if memory_s == 1.0 else {1: 0.0, 2: 0.4}
    assert known.track.tolist() == list(expected)
    wanted_s = np.array(list(expected.values())) + 1 / FPS
    assert known.unseen_s == pytest.approx(wanted_s, abs=0.51 / FPS)
    assert known.box[:, 0].tolist() == [CUT - 1, *hidden][: len(expected)]

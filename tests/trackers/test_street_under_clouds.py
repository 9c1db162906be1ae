"""People in a street, small in the picture, while clouds drift and the light changes for good."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray
from street_under_clouds import FPS, SIZE, Street, street

from tracking.people import SingleCameraPerception
from tracking.trackers.three_part import ThreePartSettings
from tracking.trackers.three_part.people import Layout
from tracking.trackers.three_part.tracker import Camera, PartTracker
from tracking.tracks.boxes import overlaps
from tracking.tracks.columns import boxes_of

SECONDS, CHANGE_S, LIT_AGAIN_S = 13.0, 5.0, 9.0
SEEN = 0.5


@dataclass(frozen=True)
class Followed:
    """What a tracker made of the street.

    Attributes:
        second, found: (m,) of each person seen: when, and how far a box is theirs.
    """

    second: NDArray[np.float64]
    found: NDArray[np.float64]

    def share_found(self, start_s: float, stop_s: float) -> float:
        during = (self.second >= start_s) & (self.second < stop_s)
        return float((self.found[during] > 0.4).mean())


def follow(scene: Street) -> Followed:
    """The three-part tracker, without a floor, over the street."""
    perception = SingleCameraPerception(FPS)
    perception.learn(*scene.samples())
    camera = Camera(SIZE, FPS, None)
    tracker = PartTracker(camera, ThreePartSettings(max_particles=300), Layout(3, 1), 0)
    people: list[tuple[float, float]] = []
    for number in range(scene.frames):
        frame, truth = scene.read(number)
        tracks = tracker.step(perception.observe(frame)).tracks
        true = truth.box[truth.visibility >= SEEN]
        common = overlaps(boxes_of(tracks)[:, None], true[None])
        people += [(frame.time_s, float(own)) for own in common.max(axis=0, initial=0.0)]
    second, found = np.array(people).T
    return Followed(second, found)


def test_people_are_found_after_the_light_changed_for_good() -> None:
    followed = follow(street(SECONDS, CHANGE_S))
    before = followed.share_found(2.0, CHANGE_S)
    after = followed.share_found(LIT_AGAIN_S, SECONDS)
    assert after > 0.5
    assert after > 0.8 * before

"""What puts parts right can be left out piece by piece, down to the paper's comparison."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest
from people_of_three_blocks import (
    FPS,
    GREEN_BROWN,
    RED_BLUE,
    SIZE,
    Blocks,
    observations,
    part_box,
    seen_in,
    walking,
)

from tracking.failure import Judgement
from tracking.people import Observation
from tracking.trackers import StepResult
from tracking.trackers.three_part import ThreePartSettings
from tracking.trackers.three_part.claims import both_in_one, claims_of
from tracking.trackers.three_part.people import Layout
from tracking.trackers.three_part.settings import Aids
from tracking.trackers.three_part.tracker import Camera, PartTracker

APART = Layout(parts=3, together=1)
AIDS = ("fit_silhouettes", "pose_constraints", "reidentify")


class Alarms:
    """A detector that calls every part lost."""

    def judge(self, features: np.ndarray) -> Judgement:
        said = np.ones((len(features), 3), bool)
        return Judgement(said, np.where(said, 1.0, -1.0), said.any(axis=1))


def tracker(detector=None, **settings) -> PartTracker:
    chosen = ThreePartSettings(max_particles=400, **settings)
    return PartTracker(Camera(SIZE, FPS, None), chosen, APART, 0, detector)


def crossing() -> list[Observation]:
    first = Blocks(walking((40, 50), (3.0, 0.0)), RED_BLUE)
    second = Blocks(walking((220, 64), (-3.0, 0.0)), GREEN_BROWN)
    return list(observations([first, second], 60))


def places(results: list[StepResult]) -> np.ndarray:
    names = ("frame", "track", "cx", "cy", "width", "height")
    return np.concatenate([np.column_stack([r.parts[n] for n in names]) for r in results])


def test_without_adjustment_nothing_depends_on_the_detector():
    seen = crossing()
    runs = [
        [by.step(each) for each in seen]
        for by in (tracker(adjust=False), tracker(Alarms(), adjust=False))
    ]
    assert np.array_equal(places(runs[0]), places(runs[1]))
    assert runs[1][-1].parts["failed"].all()


@pytest.mark.parametrize("name", AIDS)
def test_without_adjustment_an_aid_of_ours_changes_nothing(name):
    seen = crossing()
    one, other = tracker(adjust=False), tracker(adjust=False, **{name: False})
    assert np.array_equal(
        places([one.step(each) for each in seen]), places([other.step(each) for each in seen])
    )


def test_the_paper_s_adjustment_is_what_is_left_without_ours():
    assert ThreePartSettings(**dict.fromkeys(AIDS, False)).aids == Aids(adjust=True)
    assert ThreePartSettings(adjust=False).aids == Aids()
    assert ThreePartSettings().aids == Aids(True, True, True, True)


def as_one(seen: Observation) -> Observation:
    """The frame with everybody seen as one person."""
    whole = (seen.people.regions > 0).astype(np.int32)
    return replace(seen, people=seen_in(whole))


def test_two_who_were_begun_as_one_are_followed_apart_once_they_are_seen_apart():
    behind = Blocks(walking((60, 20), (1.0, 0.0)), RED_BLUE)
    front = Blocks(walking((80, 46), (1.0, 0.0)), GREEN_BROWN)
    by = tracker()
    seen = [
        as_one(each) if frame < 20 else each
        for frame, each in enumerate(observations([behind, front], 26))
    ]
    results = [by.step(each) for each in seen]
    assert set(results[19].tracks["track"]) == {1}
    assert set(results[-1].tracks["track"]) == {1, 2}
    each_on = [parts_on(results[-1], person) for person in (behind, front)]
    assert sorted(each_on) == [[1, 1, 1], [2, 2, 2]]


def test_who_has_parts_in_two_people_was_both_in_one():
    people = [
        Blocks(walking((60, 20), (0.0, 0.0)), RED_BLUE),
        Blocks(walking((120, 60), (0.0, 0.0)), GREEN_BROWN),
    ]
    seen = next(observations(people, 1)).people
    whole, mixed = rectangles_on(people[0], people[0]), rectangles_on(people[0], people[1])
    new = np.array([1], np.intp)
    assert both_in_one(claims_of(mixed[None], seen), new).tolist() == [0]
    assert both_in_one(claims_of(whole[None], seen), new).tolist() == []
    assert claims_of(mixed[None], seen).is_taken.tolist() == [True, False]


def rectangles_on(above: Blocks, below: Blocks) -> np.ndarray:
    """(3, 4) head and torso on somebody, legs on somebody."""
    corners = np.stack([part_box(person, 0, k) for k, person in enumerate((above, above, below))])
    middle, size = (corners[:, :2] + corners[:, 2:]) / 2, corners[:, 2:] - corners[:, :2]
    return np.concatenate((middle, size / 2), axis=1)


def parts_on(result: StepResult, person: Blocks) -> list[int]:
    """The tracks whose parts' middles are in the same parts of the person."""
    parts, tracks = result.parts, []
    for part in range(3):
        left, top, right, bottom = part_box(person, result.frame, part)
        on = (parts["part"] == part) & (parts["cx"] > left) & (parts["cx"] < right)
        on &= (parts["cy"] > top) & (parts["cy"] < bottom)
        tracks += parts["track"][on].tolist()
    return tracks

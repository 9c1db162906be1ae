"""Trackers of body parts on people of three blocks."""

from __future__ import annotations

from collections.abc import Iterable
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
    walking,
)

from tracking.errors import SettingsError
from tracking.failure import Judgement
from tracking.trackers import Observation, StepResult, occluders_as_setting
from tracking.trackers.shared.occluders import occluders_from
from tracking.trackers.three_part import ThreePartSettings, WholeBodySettings
from tracking.trackers.three_part.claims import claims_of
from tracking.trackers.three_part.people import Layout
from tracking.trackers.three_part.tracker import Camera, PartTracker
from tracking.tracks import Occluder

APART, TOGETHER, WHOLE = Layout(3, 1), Layout(3, 3), Layout(1, 1)
both_layouts = pytest.mark.parametrize("layout", [APART, TOGETHER], ids=["apart", "together"])


class Says:
    """A detector that calls some parts lost in some frames, counted from its first judgement."""

    def __init__(self, failed: dict[int, tuple[bool, bool, bool]]) -> None:
        self.failed, self.count = failed, -1

    def judge(self, features: np.ndarray) -> Judgement:
        self.count += 1
        said = np.array([self.failed.get(self.count, (False,) * 3)] * len(features))
        return Judgement(said, np.where(said, 1.0, -1.0), said.sum(axis=1) > 1)


def tracker(
    layout: Layout = APART, seed: int = 0, adjust: bool = True, detector=None, **settings
) -> PartTracker:
    chosen: WholeBodySettings
    if layout is WHOLE:
        chosen = WholeBodySettings(**{"max_particles": 400, **settings})
    else:
        chosen = ThreePartSettings(**{"max_particles": 400, "adjust": adjust, **settings})
    camera = Camera(SIZE, FPS, None, occluders_from(chosen.occluders))
    return PartTracker(camera, chosen, layout, seed, detector)


def followed(by: PartTracker, seen: Iterable[Observation]) -> list[StepResult]:
    return [by.step(each) for each in seen]


def walker(**other) -> Blocks:
    return Blocks(**{"left_top": walking((40, 60), (2.0, 0.3)), "colours": RED_BLUE, **other})


def share_on_part(result: StepResult, person: Blocks, part: int, track: int) -> float:
    """The share of a part's rectangle that lies on the part."""
    rows = (result.parts["track"] == track) & (result.parts["part"] == part)
    x, y, width, height = (
        float(result.parts[name][rows][0]) for name in ("cx", "cy", "width", "height")
    )
    true = part_box(person, result.frame, part)
    across = min(x + width / 2, true[2]) - max(x - width / 2, true[0])
    down = min(y + height / 2, true[3]) - max(y - height / 2, true[1])
    return max(across, 0) * max(down, 0) / (width * height)


def ids(results: Iterable[StepResult]) -> set[int]:
    return {int(track) for result in results for track in result.tracks["track"]}


@both_layouts
def test_a_walker_is_followed_under_one_id_with_every_part_on_its_part(layout):
    person = walker()
    results = followed(tracker(layout), observations([person], 60))
    assert ids(results) == {1}
    for result in results[10:]:
        for part in range(3):
            assert share_on_part(result, person, part, 1) > 0.5


def test_somebody_new_is_waited_for_before_there_is_a_track():
    results = followed(tracker(confirm_s=0.3), observations([walker()], 12))
    first = next(result.frame for result in results if len(result.tracks["track"]))
    assert first == 6  # 0.3 s after the first frame, at 20 frames a second


def test_the_box_of_somebody_seen_whole_is_the_person_and_not_the_inner_rectangles():
    person = walker()
    last = followed(tracker(), observations([person], 40))[-1]
    left, top = person.left_top(39)
    box = [float(last.tracks[name][0]) for name in ("left", "top", "width", "height")]
    np.testing.assert_allclose(box, (left, top, 32, 100), atol=3.0)


@both_layouts
def test_two_who_cross_keep_their_ids_and_the_one_behind_is_marked_as_hidden(layout):
    near = Blocks(walking((30, 70), (3.0, 0.0)), RED_BLUE)
    far = Blocks(walking((250, 40), (-3.0, 0.0)), GREEN_BROWN)
    results = followed(tracker(layout), observations([near, far], 72))
    assert ids(results) == {1, 2}
    first, last = results[10], results[-1]
    for person in (near, far):
        track = max((1, 2), key=lambda t: share_on_part(first, person, 1, t))
        assert share_on_part(last, person, 1, track) > 0.5
        if person is far:
            hidden = [r.parts["occluded"][r.parts["track"] == track].any() for r in results[10:]]
            assert any(hidden)
            assert not hidden[0]
            assert not hidden[-1]


def test_colours_are_frozen_while_somebody_is_hidden():
    near = Blocks(walking((30, 70), (3.0, 0.0)), RED_BLUE)
    far = Blocks(walking((250, 40), (-3.0, 0.0)), GREEN_BROWN)
    by, before = tracker(), {}
    for seen in observations([near, far], 60):
        result = by.step(seen)
        people = by._people
        for row, track in enumerate(people.track):
            model = people.model[row].copy()
            hidden = people.occluded[row]
            if hidden.any() and track in before:
                np.testing.assert_array_equal(model[hidden], before[track][hidden])
            before[track] = model
        assert np.isnan(result.parts["entropy"][result.parts["occluded"]]).all()


def test_somebody_behind_a_drawn_pillar_is_followed_by_motion_and_kept():
    person = walker(left_top=walking((30, 60), (3.0, 0.0)))
    pillar = (150, 190)
    outline = ((150.0, 0.0), (190.0, 0.0), (190.0, 199.0), (150.0, 199.0))
    drawn = occluders_as_setting([Occluder("pillar", outline)])
    results = followed(tracker(occluders=drawn), observations([person], 80, pillar))
    assert ids(results) == {1}
    hidden = [result for result in results if result.parts["occluded"].any()]
    assert 5 < len(hidden) < 40
    assert not results[-1].parts["occluded"].any()
    assert all(share_on_part(results[-1], person, part, 1) > 0.5 for part in range(3))


def test_a_part_the_detector_calls_lost_is_put_back_on_its_part():
    person = walker()
    by = tracker(detector=Says({20: (True, False, False)}))
    for seen in observations([person], 40):
        if by._people.track.size and by._watch.detector.count == 19:
            state = by._people.state.copy()
            state[0, 0, :2] += (6.0, 4.0)
            by._people = by._people.replace(state=state)
        result = by.step(seen)
        if by._watch.detector.count == 20 and result.parts["failed"].any():
            assert result.parts["failed"].tolist() == [True, False, False]
            assert share_on_part(result, person, 0, 1) > 0.9
            return
    pytest.fail("the detector was never asked")


def test_without_adjustment_a_part_called_lost_is_marked_and_left():
    by = tracker(adjust=False, detector=Says({20: (True, True, False)}))
    marked = [r for r in followed(by, observations([walker()], 40)) if r.parts["failed"].any()]
    assert len(marked) == 1
    assert marked[0].parts["score"].tolist() == [1.0, 1.0, -1.0]


@pytest.mark.parametrize(("adjust", "told"), [(True, 1), (False, 0)])
def test_that_there_is_no_detector_is_told_where_one_is_wanted(adjust, told):
    by = tracker(adjust=adjust)
    followed(by, observations([walker()], 8))
    assert len(by.notes) == told
    assert all("no part-failure detector" in note for note in by.notes)


@both_layouts
def test_the_same_seed_gives_the_same_arrays(layout):
    one, two, other = (
        followed(tracker(layout, seed), observations([walker()], 20))[-1] for seed in (3, 3, 4)
    )
    for columns in ("tracks", "parts", "part_particles"):
        for name, column in getattr(one, columns).items():
            assert column.tobytes() == getattr(two, columns)[name].tobytes()
    assert one.part_particles["u"].tobytes() != other.part_particles["u"].tobytes()


def test_particles_stay_between_their_limits_and_some_of_them_are_kept():
    by = tracker(min_particles=50, max_particles=120, stored_particles=40)
    for result in followed(by, observations([walker()], 30))[10:]:
        assert result.parts["particles"].min() >= 50
        assert result.parts["particles"].max() <= 120
        assert np.bincount(result.part_particles["part"]).tolist() == [40, 40, 40]
        total = np.bincount(result.part_particles["part"], result.part_particles["weight"])
        np.testing.assert_allclose(total, 1.0, rtol=1e-4)


def test_particles_can_be_left_out():
    results = followed(tracker(stored_particles=0), observations([walker()], 12))
    assert len(results[-1].parts["track"]) == 3
    assert len(results[-1].part_particles["track"]) == 0


def test_a_person_followed_whole_has_a_box_and_no_parts():
    person = walker()
    last = followed(tracker(WHOLE), observations([person], 30))[-1]
    assert len(last.parts["track"]) == 0
    left, top = person.left_top(29)
    middle = last.tracks["left"][0] + last.tracks["width"][0] / 2
    assert abs(middle - left - 16) < 8
    assert top < last.tracks["top"][0] + last.tracks["height"][0] / 2 < top + 100


def test_who_leaves_the_picture_is_let_go():
    person = walker(left_top=walking((200, 60), (5.0, 0.0)))
    results = followed(tracker(), observations([person], 40))
    assert ids(results) == {1}
    assert len(results[-1].tracks["track"]) == 0


@pytest.mark.parametrize("text", ["pillar", "[[1, 2], [3, 4]]", "[[[0, 0], [1, 1]]]", "{}"])
def test_what_is_no_outline_is_refused(text):
    with pytest.raises(SettingsError, match="setting occluders: must be outlines"):
        occluders_from(text)


def test_no_fewest_particles_above_the_most() -> None:
    with pytest.raises(SettingsError, match="2000 is more than max_particles, 1000"):
        ThreePartSettings(min_particles=2000)
    assert WholeBodySettings(min_particles=1000).max_particles == 1000


def test_whose_regions_are_whose_is_worked_out_once_for_each_place_of_the_parts(monkeypatch):
    asked = []
    monkeypatch.setattr(
        "tracking.trackers.three_part.frame.claims_of",
        lambda *places: asked.append(0) or claims_of(*places),
    )
    by = tracker()
    looks = []
    for each in observations([walker()], 12):
        asked.clear()
        by.step(each)
        looks.append(len(asked))
    # As predicted, as weighed, and drawn to the silhouette.
    assert looks[-1] == 3


def test_the_stages_of_a_step_are_timed():
    by = tracker()
    by.step(next(observations([walker()], 1)))
    assert set(by.stage_s) == {"filters", "failures", "births", "boxes"}
    assert all(spent_s > 0 for spent_s in by.stage_s.values())


def test_a_camera_that_moved_is_told() -> None:
    by = tracker(adjust=False)
    for seen in observations([], 60):
        assert by.notes == ()
        pushed = (6, 10) if seen.frame > 20 else (0, 0)
        by.step(replace(seen, picture=np.roll(seen.picture, pushed, axis=(0, 1))))
    (line,) = by.notes
    assert line.startswith(
        "the camera moved between frames 19 and 39: three-part needs a fixed one"
    )

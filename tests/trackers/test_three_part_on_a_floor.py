"""Trackers of body parts where the floor is known, so that each region is one whole body."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from dataclasses import replace

import numpy as np
import pytest
from people_of_three_blocks import (
    FPS,
    GREEN_BROWN,
    HEIGHT,
    RED_BLUE,
    SIZE,
    WIDTH,
    Blocks,
    observations,
    part_box,
    walking,
)

from tracking.geometry import Camera as Lens
from tracking.geometry import Ground, View
from tracking.trackers import Observation, StepResult
from tracking.trackers.three_part import ThreePartSettings
from tracking.trackers.three_part.claims import associate_detections, claims_of
from tracking.trackers.three_part.people import Layout
from tracking.trackers.three_part.tracker import Camera, PartTracker
from tracking.tracks import HEAD

APART, TOGETHER = Layout(3, 1), Layout(3, 3)
both_layouts = pytest.mark.parametrize("layout", [APART, TOGETHER], ids=["apart", "together"])
SIDES = ("left", "top", "width", "height")


def tracker(layout: Layout = APART, **settings) -> PartTracker:
    matrix = np.array([[260.0, 0.0, 159.5], [0.0, 260.0, 99.5], [0.0, 0.0, 1.0]])
    view = View(Lens(matrix, np.zeros(5), *SIZE), Ground(2.4, 30.0))
    chosen = ThreePartSettings(max_particles=400, **settings)
    return PartTracker(Camera(SIZE, FPS, view), chosen, layout, 0)


def on_a_floor(people: Sequence[Blocks], frames: int) -> Iterator[Observation]:
    """The regions with boxes of whole bodies, as perception gives them over a known floor."""
    for seen in observations(people, frames):
        boxes = seen.people.box.copy()
        there = [one for one in people if one.left_top(seen.frame) is not None]
        whole = np.array([(*one.left_top(seen.frame), WIDTH, HEIGHT) for one in there])
        for row, box in enumerate(boxes):
            away = np.abs(whole[:, 0] - box[0]) + np.abs(whole[:, 1] - box[1])
            boxes[row] = whole[away.argmin()]
        yield replace(seen, people=replace(seen.people, box=boxes))


def followed(by: PartTracker, seen: Iterable[Observation]) -> list[StepResult]:
    return [by.step(each) for each in seen]


def ids(results: Iterable[StepResult]) -> set[int]:
    return {int(track) for result in results for track in result.tracks["track"]}


@both_layouts
def test_somebody_whose_head_is_above_the_picture_is_followed_all_the_same(layout: Layout) -> None:
    person = Blocks(walking((60, -20), (2.0, 0.0)), RED_BLUE)
    results = followed(tracker(layout), on_a_floor([person], 40))
    assert len(results[10].tracks["track"]) == 1
    last = results[-1]
    box = [float(last.tracks[name][0]) for name in SIDES]
    np.testing.assert_allclose(box, (*person.left_top(39), WIDTH, HEIGHT), atol=5.0)
    assert last.parts["occluded"].tolist() == [True, False, False]


def test_the_papers_own_rows_wait_until_everything_of_somebody_is_in_the_picture() -> None:
    person = Blocks(walking((60, -20), (2.0, 0.0)), RED_BLUE)
    assert not ids(followed(tracker(adjust=False), on_a_floor([person], 40)))


def test_without_parts_outside_of_the_picture_nobody_is_followed_until_they_are_in_it() -> None:
    person = Blocks(walking((60, -20), (2.0, 0.0)), RED_BLUE)
    assert not ids(followed(tracker(pose_constraints=False), on_a_floor([person], 40)))


@both_layouts
def test_a_head_that_comes_into_the_picture_is_followed_from_there_on(layout: Layout) -> None:
    person = Blocks(walking((60, -20), (1.0, 1.0)), RED_BLUE)
    results = followed(tracker(layout), on_a_floor([person], 70))
    assert ids(results) == {1}
    last = results[-1].parts
    row = int(np.flatnonzero(last["part"] == HEAD)[0])
    left, top, right, bottom = part_box(person, 69, HEAD)
    assert not last["occluded"][row]
    assert left < last["cx"][row] < right
    assert top < last["cy"][row] < bottom


def test_who_has_no_region_is_not_told_of_and_keeps_the_id_when_seen_again() -> None:
    def stands(frame: int) -> tuple[float, float] | None:
        return None if 20 <= frame < 36 else (100.0, 60.0)

    results = followed(tracker(), on_a_floor([Blocks(stands, RED_BLUE)], 50))
    assert ids(results[10:20]) == ids(results[40:]) == {1}
    assert not ids(results[26:36])


def test_of_two_in_one_place_each_has_the_region_of_their_own_colours() -> None:
    one, other = (
        Blocks(walking(start, (0.0, 0.0)), colours)
        for start, colours in (((100, 60), RED_BLUE), ((126, 60), GREEN_BROWN))
    )
    seen = next(on_a_floor([one, other], 1)).people
    seen = replace(seen, from_detector=np.ones(2, bool))
    between = np.array([(111.0, 60.0, 32.0, 100.0), (113.0, 60.0, 32.0, 100.0)])
    rectangles = np.tile((128.0, 100.0, 12.0, 20.0), (2, 3, 1))
    claims = claims_of(rectangles, seen)
    by_boxes = associate_detections(claims, between, seen)
    alike = np.array([[0.5, 0.9], [0.9, 0.5]])
    by_colours = associate_detections(claims, between, seen, alike)
    assert by_boxes.region.tolist() == [0, 1]
    assert by_colours.region.tolist() == [1, 0]
    assert by_colours.alone.all()

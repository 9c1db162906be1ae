"""People from one camera: drawn ones by behaviour, rendered ones against exact truth."""

from __future__ import annotations

import numpy as np
import pytest
from drawn_people import SIZE, floor, with_person, with_shadow
from numpy.typing import NDArray

from tracking.foreground import BackgroundModel
from tracking.geometry import Camera, Ground, View
from tracking.people import Observation, SingleCameraPerception
from tracking.people.ghosts import without_ghosts
from tracking.people.parts import part_regions, ycbcr
from tracking.recording.frame import StereoFrame
from tracking.synthesis import SCENES, Scene, SceneTruth

Picture = NDArray[np.uint8]
FPS = 5.0


def seen(*pictures: Picture, empty: Picture | None = None) -> Observation:
    """The last of the pictures as observed by perception that knows the empty floor."""
    perception = SingleCameraPerception(FPS)
    perception.learn([StereoFrame(0, 0.0, floor() if empty is None else empty, None)])
    for number, picture in enumerate(pictures):
        found = perception.observe(StereoFrame(number, number / FPS, picture, None))
    return found


def test_an_empty_floor_shows_nobody() -> None:
    found = seen(floor())
    assert len(found.people) == 0
    assert found.people.regions.shape == SIZE
    assert not found.people.regions.any()


def test_somebody_gets_a_box_and_the_picture_goes_along() -> None:
    picture = with_person(floor(), 100, 60, 120)
    found = seen(picture)
    assert np.allclose(found.people.box, [[84.5, 59.5, 30, 120]], atol=4)
    assert found.picture is picture
    assert np.isnan(found.people.position).all()


def test_a_shadow_on_the_floor_is_no_leg() -> None:
    shaded = with_shadow(floor(), 100, 178, 90)
    found = seen(with_person(shaded, 100, 60, 120))
    left, _, width, _ = found.people.box[0]
    assert left + width < 122
    assert not found.people.regions[:, 130:].any()


def test_specks_are_dropped() -> None:
    picture = with_person(floor(), 100, 60, 120)
    picture[20:26, 250:256] = 0
    assert len(seen(picture).people) == 1


def test_two_people_who_touch_are_two() -> None:
    picture = with_person(with_person(floor(), 100, 60, 120), 126, 66, 118)
    found = seen(picture)
    assert len(found.people) == 2
    middle = found.people.box[:, 0] + found.people.box[:, 2] / 2
    assert np.allclose(np.sort(middle), [100, 126], atol=8)


def test_somebody_who_crouches_stays_one_person() -> None:
    picture = floor()
    picture[120:180, 90:145] = (30, 30, 160)
    picture[108:122, 95:110] = (90, 120, 190)
    assert len(seen(picture).people) == 1


def test_somebody_who_stands_still_does_not_melt_into_the_background() -> None:
    standing = with_person(floor(), 100, 60, 120)
    found = seen(*[standing] * 150)
    assert len(found.people) == 1
    assert found.people.box[0, 3] > 110


def test_the_first_frame_finds_the_background_in_the_light_it_was_learnt_in() -> None:
    lit, frames = floor(), []
    for number in range(12):
        share = 1.0 if number < 8 else 0.75  # the camera's exposure changes late on
        picture = np.asarray(with_person(lit, 40 + 20 * number, 60, 120) * share, np.uint8)
        picture[:, :150] = picture[:, :150] * (1.0 if number < 10 else 0.8)  # and then a lamp
        frames.append(StereoFrame(number, float(number), picture, None))
    perception, alone = SingleCameraPerception(FPS), BackgroundModel(FPS)
    perception.learn(frames)
    alone.learn([frame.left for frame in frames], (), [frame.time_s for frame in frames])
    assert np.array_equal(perception._background.background, alone.background)
    found = perception.observe(frames[0])
    assert len(found.people) == 1
    same = alone.subtract(frames[0].left).mask
    assert np.array_equal(found.overlays.foreground > 0, same > 0)


@pytest.mark.parametrize("tilt_deg", [0.0, -4.0])
def test_what_is_seen_above_the_horizon_stands_on_no_floor(tilt_deg: float) -> None:
    camera = Camera(np.array([[300, 0, 160], [0, 300, 120], [0, 0, 1.0]]), np.zeros(5), 320, 240)
    perception = SingleCameraPerception(FPS, View(camera, Ground(1.5, tilt_deg)))
    perception.learn([StereoFrame(0, 0.0, floor(), None)])
    picture = floor()
    picture[20:70, 100:130] = (30, 30, 160)
    # Beside it something reaches lower, and still ends above the horizon (row 120 where level).
    picture[22:97, 126:132] = (120, 40, 30)
    found = perception.observe(StereoFrame(0, 0.0, picture, None)).people
    assert len(found) == 1
    assert np.isfinite(found.box).all()


def test_what_somebody_left_behind_in_the_background_is_nobody() -> None:
    assert len(seen(floor(), empty=with_person(floor(), 100, 60, 120)).people) == 0


def test_somebody_dull_before_strong_bars_is_no_ghost() -> None:
    bars = np.full((*SIZE, 3), 150, np.uint8)
    for row in range(4):
        bars[row::20] = 0
    dull, regions = bars.copy(), np.zeros(SIZE, np.uint8)
    dull[60:160, 100:130], regions[60:160, 100:130] = 120, 1
    assert without_ghosts(regions, dull, bars, floor_known=False).any()


@pytest.mark.parametrize(("top", "height", "people"), [(105, 75, 1), (66, 114, 2), (60, 70, 2)])
def test_without_metres_who_ends_as_low_as_somebody_must_be_about_as_tall(
    top: int, height: int, people: int
) -> None:
    beside = with_person(floor(), 124, top, height)
    assert len(seen(with_person(beside, 100, 60, 120)).people) == people


def test_a_stretched_out_arm_is_nobody_without_metres() -> None:
    picture = with_person(floor(), 100, 60, 120)
    picture[82:92, 110:150] = (30, 30, 160)
    picture[76:90, 144:156] = (90, 120, 190)
    assert len(seen(picture).people) == 1


def test_people_seen_from_above_are_not_doubled() -> None:
    scene = Scene(SCENES["plaza"], people=6, seed=7, cameras=1)
    frames = [scene.frame(number) for number in range(160, 480, 40)]
    perception = SingleCameraPerception(FPS, scene.rig.view)
    perception.learn([frame for frame, _ in frames])
    counted = [(len(perception.observe(frame).people), len(truth)) for frame, truth in frames]
    found, true = np.array(counted).T
    assert true.sum() > 12
    assert np.maximum(found - true, 0).sum() < 0.2 * true.sum()
    assert np.maximum(true - found, 0).sum() < 0.2 * true.sum()


def test_wide_pictures_give_boxes_and_regions_as_recorded() -> None:
    wide = (720, 1280)
    found = seen(with_person(floor(wide), 600, 200, 360), empty=floor(wide))
    assert np.allclose(found.people.box, [[556.5, 199.5, 87, 360]], atol=10)
    assert found.people.regions.shape == wide
    assert found.overlays.foreground.shape == wide


@pytest.fixture(scope="module")
def rendered() -> list[tuple[Observation, SceneTruth, NDArray[np.int32]]]:
    """Observations of a rendered walkway with what is true of them and who covers each pixel."""
    scene = Scene(SCENES["walkway"], seed=4104, cameras=1)
    numbers = range(40, scene.frames, 8)
    frames = [scene.frame(number) for number in numbers]
    perception = SingleCameraPerception(FPS, scene.rig.view)
    perception.learn([frame for frame, _ in frames])
    surfaces = [scene.surfaces(number).track for number in numbers]
    return [
        (perception.observe(frame), truth, track)
        for (frame, truth), track in zip(frames, surfaces, strict=True)
    ]


def matched(
    rendered: list[tuple[Observation, SceneTruth, NDArray[np.int32]]],
) -> list[tuple[Observation, int, SceneTruth, int]]:
    """(observation, its region or -1, truth, its row) of everybody seen whole and alone."""
    found = []
    for observation, truth, track in rendered:
        for row in np.flatnonzero(truth.visibility > 0.99):
            own = observation.people.regions[track == truth.track[row]]
            label = int(np.bincount(own).argmax()) if len(own) else 0
            found.append((observation, label - 1, truth, int(row)))
    return found


def test_rendered_people_are_found_where_they_stand(
    rendered: list[tuple[Observation, SceneTruth, NDArray[np.int32]]],
) -> None:
    people = matched(rendered)
    assert len(people) > 25
    known = [found for found in people if found[1] >= 0]
    assert len(known) >= 0.93 * len(people)
    apart = [o.people.position[k, :2] - t.position[row] for o, k, t, row in known]
    assert np.median(np.hypot(*np.array(apart).T)) < 0.15
    feet = [
        (o.people.box[k, [1, 3]].sum() - t.box[row, [1, 3]].sum()) / t.box[row, 3]
        for o, k, t, row in known
    ]
    # A shadow taken for legs would draw boxes down.
    assert np.mean(np.array(feet) < 0.05) > 0.93
    assert np.mean(np.abs(feet) < 0.1) > 0.93


def test_rectangles_lie_on_the_rendered_peoples_parts(
    rendered: list[tuple[Observation, SceneTruth, NDArray[np.int32]]],
) -> None:
    on = []
    for observation, k, truth, row in matched(rendered):
        if k < 0:
            continue
        assert observation.picture is not None
        people, picture = observation.people, ycbcr(observation.picture)
        parts = part_regions(people.regions, k + 1, picture, people.box[k])
        on.append(_inside(parts.rectangles, truth.part_box[row]))
    assert (np.mean(on, axis=0) > 0.88).all()


def _inside(rectangles: NDArray[np.float64], boxes: NDArray[np.float64]) -> NDArray[np.bool_]:
    """(3,) whether more than half of each rectangle lies in its part's true box."""
    low = np.maximum(rectangles[:, :2] - rectangles[:, 2:] / 2, boxes[:, :2])
    high = np.minimum(rectangles[:, :2] + rectangles[:, 2:] / 2, boxes[:, :2] + boxes[:, 2:])
    shared = np.maximum(high - low, 0).prod(axis=1)
    return np.asarray(shared > 0.5 * rectangles[:, 2:].prod(axis=1), np.bool_)

"""People who crouch and bend, and scenes for body parts."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from tracking.errors import SettingsError
from tracking.recording import open_recording
from tracking.synthesis import SCENES, Scene, render_recording
from tracking.synthesis.crowd import PlannedWalk
from tracking.synthesis.postures import stoops_of

FPS = 20.0
SMALL = (180, 120)
WHOLE_M = 0.02


def _walk(stands: tuple[int, int], frames: int = 160) -> PlannedWalk:
    """Straight ahead at 1.2 m/s, but for the frames in which the person stands."""
    moves = np.full(frames, 1.2 / FPS)
    moves[stands[0] : stands[1]] = 0.0
    position = np.column_stack((np.cumsum(moves), np.zeros(frames)))
    return PlannedWalk(0, position, np.zeros(frames))


@pytest.fixture(scope="module")
def crouching() -> Scene:
    return Scene(SCENES["crouching"], seed=4102, cameras=1, size=SMALL)


@settings(deadline=None)
@given(st.integers(0, 10_000), st.integers(10, 60), st.integers(40, 90))
def test_who_walks_stays_upright_and_who_stands_goes_down_and_up_again(
    seed: int, start: int, length: int
) -> None:
    stoops = stoops_of(_walk((start, start + length)), FPS, 1.0, np.random.default_rng(seed))
    down = np.maximum(stoops.crouch, stoops.bend)
    walks = np.ones(160, bool)
    walks[start : start + length] = False
    assert (down[walks] == 0).all()
    assert 0.8 <= down.max() <= 1.0
    assert np.abs(np.diff(down)).max() < 0.15
    assert np.minimum(stoops.crouch, stoops.bend).max() == 0


def test_nobody_stoops_in_a_stop_too_short_or_where_the_scene_has_none() -> None:
    rng = np.random.default_rng(1)
    assert not stoops_of(_walk((20, 40)), FPS, 1.0, rng).crouch.any()
    long = stoops_of(_walk((20, 90)), FPS, 0.0, rng)
    assert not long.crouch.any()
    assert not long.bend.any()


def _deepest(scene: Scene, kind: str) -> tuple[int, int]:
    """Person and frame in which somebody is farthest down."""
    best = (0.0, 0, 0)
    for person, (way, stoops) in enumerate(zip(scene.cast.walks, scene.cast.stoops, strict=True)):
        if way is None or stoops is None:
            continue
        depth = getattr(stoops, kind)
        row = int(depth.argmax())
        best = max(best, (float(depth[row]), person, way.first_frame + row))
    assert best[0] > 0.7
    return best[1], best[2]


def _height_px(scene: Scene, person: int, frame: int) -> float:
    _, truth = scene.frame(frame)
    return float(truth.box[truth.track == person + 1, 3][0])


@pytest.mark.parametrize(("kind", "share"), [("crouch", 0.75), ("bend", 0.80)])
def test_who_is_down_is_lower_and_keeps_head_torso_and_legs_in_that_order(
    crouching: Scene, kind: str, share: float
) -> None:
    person, frame = _deepest(crouching, kind)
    way = crouching.cast.walks[person]
    stoops = crouching.cast.stoops[person]
    assert way is not None
    assert stoops is not None
    row = frame - way.first_frame
    upright = np.flatnonzero(np.maximum(stoops.crouch, stoops.bend) == 0)
    before = way.first_frame + int(upright[upright < row].max())
    lowered = _height_px(crouching, person, frame) / _height_px(crouching, person, before)
    assert lowered < share
    _, truth = crouching.frame(frame)
    parts = truth.part_box[truth.track == person + 1][0]
    bottoms = parts[:, 1] + parts[:, 3]
    assert bottoms[0] < bottoms[2]
    assert bottoms[1] < bottoms[2]


def test_feet_stay_on_the_floor_while_somebody_is_down(crouching: Scene) -> None:
    for kind in ("crouch", "bend"):
        person, frame = _deepest(crouching, kind)
        people = np.array([person])
        world, _ = crouching.cast.surfaces(people, crouching.cast.posture(people, frame))
        assert abs(world[0, :, 2].min()) < WHOLE_M


def test_tops_and_trousers_differ_on_the_walkway() -> None:
    scene = Scene(SCENES["walkway"], people=8, seed=3, seconds=1.0, size=SMALL, cameras=1)
    texels = np.split(np.sqrt(scene.cast.textures / 0.9), 8)
    for atlas in (rows[: 320 * 256].reshape(320, 256, 3) for rows in texels):
        chest, shin = atlas[30:70, :].mean(axis=(0, 1)), atlas[190:215, 5:85].mean(axis=(0, 1))
        assert np.linalg.norm(chest - shin) > 0.12


def test_a_recording_of_one_camera_shows_the_left_one_of_two(tmp_path: Path) -> None:
    one = render_recording(tmp_path / "one", "walkway", 4.0, 2, 5, size=SMALL, cameras=1)
    two = render_recording(tmp_path / "two", "walkway", 4.0, 2, 5, size=SMALL)
    assert not (one / "right.mp4").exists()
    for name in ("left.mp4", "truth.txt", "truth_parts.csv"):
        assert (one / name).read_bytes() == (two / name).read_bytes()
    with open_recording(one) as recording:
        assert not recording.is_stereo
        assert recording.view is not None


def test_scenes_for_body_parts_are_as_large_as_the_paper_s_pictures(tmp_path: Path) -> None:
    scene = Scene(SCENES["walkway"], people=0, seed=1, seconds=0.1, cameras=1)
    assert scene.rig.size == (720, 480)
    with pytest.raises(SettingsError, match="cameras is 3"):
        render_recording(tmp_path / "out", "walkway", 1.0, 1, 1, cameras=3)

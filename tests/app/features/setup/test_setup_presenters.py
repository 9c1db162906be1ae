"""What the set-up's steps know, without a window."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

from app.features.setup import (
    calibration_presenter,
    cameras_presenter,
    drawn_labels,
    floor_presenter,
    presenter,
    region_presenter,
    trial,
)
from app.features.setup.drafts import Drafts
from app.features.setup.drawn_labels import with_labels
from app.features.setup.presenter import SetupHistory, mark_of
from app.features.setup.scene import (
    BoardForm,
    CameraImages,
    Checked,
    Mark,
    SetupScene,
    SetupState,
    Step,
)
from app.shell import setup_controller
from tracking.calibration.floor import FloorPoint
from tracking.errors import CalibrationError, EditError
from tracking.geometry import Ground, StereoCalibration, View, read_calibration, write_calibration
from tracking.progress import no_progress
from tracking.recording.region_of_interest import RegionOfInterest
from tracking.setup import SetupPlan, plan_of
from tracking.tracks import CountingLine, Labels, Occluder

SIZE = (320, 240)


@pytest.fixture
def state() -> SetupState:
    return SetupState(SetupPlan(Path("a.mp4"), Path("b.mp4"), lag=2, ground=Ground(2.0, 30.0)))


@pytest.fixture
def calibration(tiny_recording: Path) -> StereoCalibration:
    return read_calibration([tiny_recording / "calibration.yaml"])


def _scene(state: SetupState, calibration: StereoCalibration | None) -> SetupScene:
    image = np.zeros((SIZE[1], SIZE[0], 3), np.uint8)
    checked = Checked(state.plan, calibration=calibration)
    return SetupScene(state, checked, CameraImages(image, image, 0, 9))


def test_changes_are_undone_and_redone_and_a_new_one_ends_what_was_undone(
    state: SetupState,
) -> None:
    history = SetupHistory(state)
    history.change(cameras_presenter.with_lag(state, 3))
    history.change(cameras_presenter.with_lag(history.state, 4))
    assert not history.change(history.state)
    history.undo()
    assert history.state.plan is not None
    assert history.state.plan.lag == 3
    history.redo()
    assert history.state.plan is not None
    assert history.state.plan.lag == 4
    history.undo()
    history.change(cameras_presenter.with_lag(history.state, 5))
    assert not history.may_redo


def test_exchanged_cameras_have_the_contrary_lag_and_no_floor(state: SetupState) -> None:
    plan = cameras_presenter.exchanged(state).plan
    assert plan is not None
    assert (plan.left, plan.right, plan.lag, plan.ground) == (
        Path("b.mp4"),
        Path("a.mp4"),
        -2,
        None,
    )


def test_what_was_found_and_what_was_set_is_told(state: SetupState) -> None:
    found = replace(state, found_lag=2)
    assert cameras_presenter.lag_told(found).startswith("Found")
    told = cameras_presenter.lag_told(cameras_presenter.with_lag(found, 0))
    assert told == "Set; 2 frames were found."


def test_one_picture_of_a_series_stands_for_the_series(tmp_path: Path) -> None:
    for name in ("left01.png", "left02.png", "right01.png"):
        (tmp_path / name).touch()
    left = calibration_presenter.source_of_board(tmp_path / "left02.png")
    assert left == str(tmp_path / "left*.png")
    assert calibration_presenter.other_source(left) == str(tmp_path / "right*.png")


@pytest.mark.parametrize(
    ("form", "words"),
    [
        (BoardForm(), "choose the pictures"),
        (BoardForm("l*.png", "r*.png"), "a square is not entered"),
        (BoardForm("l*.png", "r*.png", columns=2, square_mm=25.0), "2 x 6"),
    ],
)
def test_a_board_that_cannot_be_is_told_in_words(form: BoardForm, words: str) -> None:
    with pytest.raises(CalibrationError, match=words):
        calibration_presenter.board_request(form, stereo=True)


def test_a_calibration_of_another_size_is_scaled_and_one_of_another_shape_refused(
    tiny_recording: Path, calibration: StereoCalibration, tmp_path: Path
) -> None:
    plan = plan_of(tiny_recording)
    larger, other = tmp_path / "larger.yaml", tmp_path / "other.yaml"
    write_calibration(larger, calibration.scaled_to((640, 480)))
    left = replace(calibration.left, width=400)
    write_calibration(other, replace(calibration, left=left, right=left))
    checked = trial.check(replace(plan, calibration=(larger,)))
    assert checked.problem == ""
    assert any("scaled to" in line for line in checked.read)
    refused = trial.check(replace(plan, calibration=(other,)))
    assert refused.step is Step.CALIBRATION
    assert "another shape" in refused.problem


def test_a_problem_is_told_at_the_step_it_is_of(tiny_recording: Path) -> None:
    plan = plan_of(tiny_recording)
    assert trial.check(plan).problem == ""
    gone = trial.check(replace(plan, calibration=(tiny_recording / "gone.yaml",)))
    assert (gone.step, bool(gone.problem)) == (Step.CALIBRATION, True)
    outside = RegionOfInterest(look=(((900.0, 900.0), (950.0, 900.0), (950.0, 950.0)),))
    beyond = trial.check(replace(plan, region=outside))
    assert beyond.step is Step.REGION
    scene = SetupScene(SetupState(replace(plan, region=outside)), beyond)
    assert mark_of(Step.REGION, scene)[0] is Mark.WARNING
    assert mark_of(Step.FLOOR, scene)[0] is Mark.DONE
    assert not presenter.may_write(scene)


def test_grid_and_figure_stand_where_the_floor_is(
    state: SetupState, calibration: StereoCalibration
) -> None:
    scene = _scene(state, calibration)
    picture = floor_presenter.floor_picture(scene, (160.0, 200.0))
    assert picture.figure is not None
    left, top, width, height = picture.figure
    assert top + height == pytest.approx(200.0, abs=12.0)
    assert left < 160.0 < left + width
    assert picture.horizon is not None
    assert len(picture.grid) > 20
    bare = floor_presenter.floor_picture(_scene(state, None), (160.0, 200.0))
    assert (bare.figure, bare.grid) == (None, ())


def test_clicked_points_with_places_and_with_distances_give_the_floor(
    state: SetupState, calibration: StereoCalibration
) -> None:
    view = View(calibration.left, Ground(2.0, 30.0))
    places = np.array([(-1.0, 3.0), (1.0, 3.0), (1.2, 5.0), (-0.9, 5.5)])
    pixels = view.pixel_from_world(np.column_stack((places, np.zeros(4))))
    points = tuple(
        FloorPoint(*pixel, *place)
        for pixel, place in zip(pixels.tolist(), places.tolist(), strict=True)
    )
    state = replace(state, floor_method="points", points=points)
    found = floor_presenter.estimated(_scene(state, calibration))
    assert found.ground.height_m == pytest.approx(2.0, abs=0.01)
    pairs = floor_presenter.pairs_of_points(state)
    known = {
        (one, other): float(np.linalg.norm(places[one] - places[other])) for one, other in pairs
    }
    state = floor_presenter.with_distances(replace(state, floor_method="distances"), known)
    found = floor_presenter.estimated(_scene(state, calibration))
    assert found.ground.tilt_deg == pytest.approx(30.0, abs=0.5)
    fewer = floor_presenter.without_point(state, 1)
    assert {pair[:2] for pair in fewer.distances} == {(0, 1), (0, 2), (1, 2)}


def test_outlines_are_added_changed_and_taken_away(state: SetupState) -> None:
    square = ((0.0, 0.0), (10.0, 0.0), (10.0, 10.0), (0.0, 10.0))
    state = region_presenter.with_outline(state, "mask", square)
    state = region_presenter.with_outline(state, "look", square[:3])
    assert region_presenter.with_outline(state, "look", square[:2]) == state
    assert [one.kind for one in region_presenter.outlines_of(state)] == ["look", "mask"]
    row, corner = region_presenter.corner_of_handle(state, 4)
    assert (row, corner) == (1, 1)
    moved = region_presenter.with_corner(state, row, corner, 20.0, 3.0)
    assert moved.plan is not None
    assert moved.plan.region.mask[0][1] == (20.0, 3.0)
    assert region_presenter.outline_at(moved, 12.0, 3.0) == 1
    fewer = region_presenter.without_corner(moved, 1, 0)
    assert fewer.plan is not None
    assert len(fewer.plan.region.mask[0]) == 3
    assert region_presenter.without_corner(fewer, 1, 0).plan.region.mask == ()  # type: ignore[union-attr]


def test_what_was_entered_is_read_back_and_a_damaged_draft_begins_anew(
    state: SetupState, tmp_path: Path
) -> None:
    drafts = Drafts(tmp_path / "drafts")
    assert state.plan is not None
    mask = (((1.0, 2.0), (3.0, 4.0), (5.0, 1.0)),)
    full = replace(
        state,
        plan=replace(state.plan, region=RegionOfInterest(mask=mask), calibration=(Path("c.yaml"),)),
        by_hand=frozenset({"lag"}),
        left_out=frozenset({"03"}),
        board=BoardForm("l*.png", "r*.png", square_mm=24.5),
        points=(FloorPoint(1.0, 2.0, 3.0, 4.0),),
        distances=((0, 1, 2.5),),
        floor_method="points",
        pose_file=Path("pose.json"),
        occluders=(Occluder("pillar", mask[0]),),
        lines=(CountingLine("door", (1.0, 2.0), (3.0, 4.0), in_picture=True),),
    )
    drafts.save(full)
    assert drafts.find(state.plan) == full
    (file,) = (tmp_path / "drafts").glob("*.json")
    for text in ("{", "[]", '{"format": 2}', file.read_text().replace('"chessboard"', '"x"')):
        file.write_text(text)
        assert drafts.find(state.plan) is None
    drafts.forget(state.plan)
    assert list((tmp_path / "drafts").iterdir()) == []


def test_two_videos_of_different_scenes_are_told(tiny_recording: Path, tmp_path: Path) -> None:
    import cv2

    folder = tmp_path / "noise"
    folder.mkdir()
    random = np.random.default_rng(1)
    for number in range(4):
        cv2.imwrite(
            str(folder / f"{number}.png"),
            cv2.resize(random.integers(0, 255, (20, 30, 3), np.uint8), SIZE),
        )
    left = next(tiny_recording.glob("left*"))
    state = cameras_presenter.look(SetupPlan(left, folder), no_progress)
    assert any("do not show the same place" in doubt for doubt in state.doubts)
    assert mark_of(Step.CAMERAS, SetupScene(state))[0] is Mark.WARNING


def test_lines_and_occluders_are_drawn_named_and_cut_to_what_they_need(state: SetupState) -> None:
    square = ((0.0, 0.0), (10.0, 0.0), (10.0, 10.0), (0.0, 10.0))
    for _ in range(2):
        state = region_presenter.with_outline(state, "occluder", square)
        state = region_presenter.with_outline(state, "line", square[:2])
    assert [one.name for one in state.occluders] == ["occluder 1", "occluder 2"]
    state = region_presenter.without_outline(state, 0)
    state = region_presenter.with_outline(state, "occluder", square)
    assert {one.name for one in state.occluders} == {"occluder 1", "occluder 2"}
    assert region_presenter.titles_of(state)[2:] == [
        "Counting line: line 1",
        "Counting line: line 2",
    ]
    assert region_presenter.kept_told(state).endswith("2 occluders, 2 counting lines.")
    moved = region_presenter.with_corner(state, 3, 1, 20.0, 3.0)
    assert moved.lines[1].end == (20.0, 3.0)
    assert region_presenter.without_corner(moved, 3, 1).lines == state.lines[:1]


def test_two_ends_at_one_place_are_no_line(state: SetupState) -> None:
    one = (5.0, 5.0)
    assert region_presenter.with_outline(state, "line", (one, one)) == state
    drawn = region_presenter.with_outline(state, "line", (one, (9.0, 5.0)))
    assert region_presenter.with_corner(drawn, 0, 1, *one) == drawn


def test_what_can_be_no_label_is_refused_before_anything_is_written(
    state: SetupState, tmp_path: Path
) -> None:
    drawn = region_presenter.with_outline(state, "line", ((5.0, 5.0), (9.0, 5.0)))
    drawn_labels.check_drawn(drawn)
    assert drawn.plan is not None
    twice = replace(drawn, lines=drawn.lines * 2)
    with pytest.raises(EditError):
        setup_controller._written(replace(drawn.plan, at=tmp_path), twice, False)
    assert list(tmp_path.iterdir()) == []


@pytest.mark.parametrize("typed", ["left**.png", "left[.png", "left" + "n" * 300, "left\0"])
def test_no_source_that_is_typed_is_a_bug(typed: str, tmp_path: Path) -> None:
    assert calibration_presenter.other_source(str(tmp_path / typed)) == ""


def test_a_region_that_leaves_nothing_is_told_before_the_trial_says_so(state: SetupState) -> None:
    image = np.zeros((24, 32, 3), np.uint8)
    whole = ((-1.0, -1.0), (33.0, -1.0), (33.0, 25.0), (-1.0, 25.0))
    state = region_presenter.with_outline(state, "mask", whole)
    scene = SetupScene(state, images=CameraImages(image, None, 0, 9))
    assert "leaves nothing of the picture" in region_presenter.region_told(scene)


def test_lines_on_the_floor_are_seen_in_the_picture_and_go_back_to_it(
    state: SetupState, calibration: StereoCalibration
) -> None:
    view = View(calibration.left, Ground(2.4, 30.0))
    line = CountingLine("door", (-1.0, 4.0), (1.0, 4.5))
    behind = CountingLine("behind", (0.0, -9.0), (1.0, -9.0))
    seen = with_labels(state, Labels(lines=(behind, line)), view)
    assert [one.name for one in seen.lines] == ["door"]
    assert seen.lines[0].in_picture
    back = drawn_labels._on_floor(seen.lines[0], view)
    assert np.allclose((back.start, back.end), (line.start, line.end), atol=0.02)
    sky = CountingLine("sky", (10.0, -4000.0), (20.0, -4000.0), in_picture=True)
    assert drawn_labels._on_floor(sky, view) == sky


def test_what_is_no_calibration_beside_the_files_is_told_and_left_out(tmp_path: Path) -> None:
    (tmp_path / "calib.txt").write_text("Notes of the calibration: board 9x6, Tuesday\n")
    state = cameras_presenter.state_of_plan(SetupPlan(tmp_path / "a.mp4"))
    assert state.plan is not None
    assert state.plan.calibration == ()
    (told,) = state.found
    assert told.startswith("Not used, as it is no calibration: ")
    assert "calib.txt: M1 is missing" in told


def test_in_place_of_the_picture_stands_what_is_done() -> None:
    def said(scene: SetupScene) -> str:
        return cameras_presenter.cameras_picture(scene).said

    plan = SetupPlan(Path("a.mp4"))
    assert said(SetupScene()).startswith("Drop one or two videos")
    assert said(SetupScene(doing="Looking at the cameras")) == "Looking at the cameras"
    assert said(SetupScene(SetupState(plan))) == "Reading the images"
    refused = SetupScene(SetupState(plan), Checked(plan, problem="no such file"))
    assert said(refused) == "There is no image of these cameras."

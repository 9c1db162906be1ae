import numpy as np
import pytest

from app.core.document.document import Document
from app.core.scenes import Side
from app.core.tracks.frame_state import Kinds, PictureOverlay, ViewOptions
from app.features.pictures.anaglyph import anaglyph_image
from app.features.pictures.overlays import FOREGROUND, SHADOW, OverlayPainter, paint_overlays
from app.features.pictures.presenter import PicturePresenter
from tracking.errors import CalibrationError
from tracking.geometry import Rectification
from tracking.people import Overlays
from tracking.recording import open_recording
from tracking.session import Session

CROWDED = 60


@pytest.fixture
def document(tiny_recording, tiny_session):
    with open_recording(tiny_recording) as recording:
        document = Document(recording, Session.open(tiny_session))
        yield document
        document.session.close()


@pytest.fixture
def turned(document, monkeypatch):
    """The same rig with its left camera turned a little: the pair must be rectified."""
    calibration = document.recording.calibration
    cos, sin = np.cos(0.03), np.sin(0.03)
    tilt = np.array([[1.0, 0.0, 0.0], [0.0, cos, -sin], [0.0, sin, cos]])
    skewed = type(calibration)(
        calibration.left, calibration.right, tilt @ calibration.rotation, calibration.translation
    )
    rectification = Rectification(skewed, document.recording.ground)
    assert not rectification.identity
    monkeypatch.setattr(document.recording, "rectification", rectification)
    return document.recording


def test_foreground_and_shadow_have_their_colours_and_the_rest_is_left_clear():
    foreground = np.array([[0, 127, 255]], np.uint8)
    painted = paint_overlays(Overlays(foreground, None), Kinds(foreground=True), (0.0, 1.0))
    assert painted[0, 0, 3] == 0
    assert tuple(painted[0, 1, :3]) == SHADOW
    assert tuple(painted[0, 2, :3]) == FOREGROUND
    assert 0 < painted[0, 1, 3] < 255


def test_near_is_brighter_than_far_and_an_unknown_distance_is_clear():
    disparity = np.array([[5.0, 20.0, np.nan]], np.float32)
    overlays = Overlays(np.full((1, 3), 255, np.uint8), disparity)
    painted = paint_overlays(overlays, Kinds(disparity=True), (5.0, 20.0)).astype(int)
    assert painted[0, 1, :3].sum() > painted[0, 0, :3].sum() + 100
    assert painted[0, :, 3].tolist()[2] == 0


def test_people_are_found_in_the_overlay_of_any_frame_in_any_order(document):
    painter = OverlayPainter(document.recording, document.session.runs[0])
    kinds = Kinds(foreground=True, disparity=True)
    for frame in (CROWDED, 2, CROWDED):
        painted = painter.paint(document.recording.read(frame), kinds)
        assert painted.shape == (240, 320, 4)
        rows = document.tracks.of_frame(frame)
        for left, top, width, height in zip(
            *(rows[name] for name in ("left", "top", "width", "height")), strict=True
        ):
            inside = painted[
                max(0, int(top)) : int(top + height), max(0, int(left)) : int(left + width), 3
            ]
            assert (inside > 0).mean() > 0.2


def test_the_legend_says_what_is_shown_nearest_first(document):
    painter = OverlayPainter(document.recording)
    assert [entry.text for entry in painter.legend(Kinds(foreground=True))] == [
        "foreground",
        "shadow",
    ]
    metres = [float(e.text.split()[0]) for e in painter.legend(Kinds(disparity=True))]
    assert metres == sorted(metres)
    assert metres[0] > 1


def test_an_overlay_of_rectified_pixels_stands_over_the_recorded_ones(turned):
    painter = OverlayPainter(turned)
    width, height = turned.size
    marked = np.zeros((height, width, 4), np.uint8)
    marked[100:104, 150:154] = 255
    recorded = painter._as_recorded(marked)
    place = turned.rectification.recorded_from_rectified(np.array([[151.5, 101.5]]))[0]
    rows, columns = np.nonzero(recorded[..., 3])
    assert (columns.mean(), rows.mean()) == pytest.approx(place, abs=1.0)
    assert abs(place[1] - 101.5) > 3


def test_one_camera_has_no_overlays(tiny_recording):
    with (
        open_recording(tiny_recording / "left.mp4") as recording,
        pytest.raises(CalibrationError, match="two calibrated cameras"),
    ):
        OverlayPainter(recording)


def test_what_is_laid_over_stays_the_same_array_and_particles_are_drawn_on_a_copy(document):
    image = np.zeros((240, 320, 4), np.uint8)
    frame, state = document.recording.read(CROWDED), document.frame_state(CROWDED)
    pictures = PicturePresenter(document.recording)
    plain = pictures.scene(Side.LEFT, frame, state, ViewOptions(), PictureOverlay(image))
    assert plain.overlay is image
    dotted = pictures.scene(
        Side.LEFT, frame, state, ViewOptions(particles=True), PictureOverlay(image)
    )
    assert dotted.overlay.any()
    assert not image.any()


def test_an_anaglyph_has_the_left_camera_in_red_and_the_right_camera_in_green_and_blue():
    left, right = np.full((2, 2, 3), 200, np.uint8), np.full((2, 2, 3), 50, np.uint8)
    assert anaglyph_image(left, right)[0, 0].tolist() == [50, 50, 200]


@pytest.mark.parametrize("shift", [3, -3, 0, 40])
def test_the_right_camera_is_moved_and_what_one_camera_alone_has_is_black(shift):
    left, right = np.full((2, 9, 3), 200, np.uint8), np.zeros((2, 9, 3), np.uint8)
    right[:, 4] = 90
    both = anaglyph_image(left, right, shift)
    if abs(shift) < 9:
        assert both[0, 4 + shift].tolist() == [90, 90, 200]
    assert (both == 0).all(axis=2).sum() == 2 * min(abs(shift), 9)


def test_the_floor_in_the_middle_lies_in_the_plane_of_an_anaglyph(document):
    scene = PicturePresenter(document.recording).anaglyph(
        document.recording.read(0), document.frame_state(0), ViewOptions(trails=False)
    )
    assert scene.side is Side.BOTH
    red, green = (scene.image[110:130, 120:200, channel].astype(float) for channel in (2, 1))
    apart = [np.abs(red[:, 8:-8] - np.roll(green, s, 1)[:, 8:-8]).mean() for s in range(-6, 7)]
    assert abs(int(np.argmin(apart)) - 6) <= 1


def test_people_move_along_with_the_rectified_picture_of_an_anaglyph(turned, tiny_session):
    document = Document(turned, Session.open(tiny_session))
    frame, state = turned.read(CROWDED), document.frame_state(CROWDED)
    recorded = (
        PicturePresenter(document.recording).scene(Side.LEFT, frame, state, ViewOptions()).people
    )
    moved = PicturePresenter(document.recording).anaglyph(frame, state, ViewOptions()).people
    for before, after in zip(recorded, moved, strict=True):
        middle = np.array(
            [[b + s / 2 for b, s in zip(before.box[:2], before.box[2:], strict=True)]]
        )
        place = turned.rectification.rectified_from_recorded(middle)[0]
        assert after.box[0] + after.box[2] / 2 == pytest.approx(place[0], abs=2)
        assert after.box[1] + after.box[3] / 2 == pytest.approx(place[1], abs=2)
    document.session.close()

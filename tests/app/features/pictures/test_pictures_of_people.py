from dataclasses import replace
from types import SimpleNamespace

import numpy as np
import pytest
import two_people

from app.core.document.document import Document
from app.core.document.edit_history import track_card
from app.core.editing import edits
from app.core.projection.extent import MARGIN_M
from app.core.scenes import Side
from app.core.tracks.frame_state import FrameState, PictureOverlay, ViewOptions
from app.core.tracks.particle_weights import relative_weights
from app.core.tracks.session_tracks import SessionTracks
from app.features.pictures.overhead_presenter import OverheadPresenter
from app.features.pictures.presenter import PicturePresenter
from tracking.recording import open_recording
from tracking.session import Session
from tracking.tracks import Source, TrackLabel, TrackTable

CROWDED = 60


@pytest.fixture
def document(tiny_recording, tiny_session):
    with open_recording(tiny_recording) as recording:
        document = Document(recording, Session.open(tiny_session))
        yield document
        document.session.close()


def _scene(document, side=Side.LEFT, view_options=ViewOptions(), pictures=None):  # noqa: B008 - frozen
    pictures = pictures or PicturePresenter(document.recording)
    frame = document.recording.read(CROWDED)
    return pictures.scene(side, frame, document.frame_state(CROWDED), view_options)


def test_everybody_of_the_frame_is_marked_in_their_colour_and_the_selected_one_last(document):
    ids = document.tracks.of_frame(CROWDED)["track"].tolist()
    document.correcting.pick(ids[0])
    people = _scene(document).people
    assert sorted(mark.track for mark in people) == ids
    assert people[-1].track == ids[0]
    assert people[-1].selected
    assert len({mark.colour for mark in people}) == len(people)


def test_the_right_camera_has_the_same_people_shifted_by_their_disparity(document):
    left = {mark.track: mark for mark in _scene(document).people}
    right = {mark.track: mark for mark in _scene(document, Side.RIGHT).people}
    assert left.keys() == right.keys()
    rectification = document.recording.rectification
    for row in range(len(document.tracks.of_frame(CROWDED)["track"])):
        rows = document.tracks.of_frame(CROWDED)
        track = int(rows["track"][row])
        middle = np.array([[rows["x"][row], rows["y"][row], 0.85]])
        shift = left[track].box[0] - right[track].box[0]
        assert shift == pytest.approx(rectification.disparity_from_world(middle)[0], abs=0.5)
        assert left[track].box[1:] == pytest.approx(right[track].box[1:], abs=0.5)


def test_a_previewed_swap_is_seen_in_both_cameras_and_from_above(document):
    first, second = document.tracks.of_frame(CROWDED)["track"].tolist()[:2]
    document.correcting.pick(first)
    document.correcting.begin(edits.SWAP, CROWDED)
    document.correcting.pick(second)
    left, right = (_scene(document, side).preview for side in (Side.LEFT, Side.RIGHT))
    assert len(left) == len(right) == len(document.frame_state(CROWDED).preview) == 4
    for one, other in zip(left, right, strict=True):
        assert (one.colour, one.after) == (other.colour, other.after)
        assert (other.points[:, 0] < one.points[:, 0]).all()  # nearer things lie further left


def test_trails_end_where_the_people_stand(document):
    for mark in _scene(document).people:
        left, top, width, height = mark.box
        foot = mark.trail[-1]
        assert left - width < foot[0] < left + 2 * width
        assert top + height / 2 < foot[1] < top + 1.5 * height


def test_without_trails_none_are_made(document):
    people = _scene(document, view_options=ViewOptions(trails=False)).people
    assert all(len(mark.trail) == 0 for mark in people)


def test_particles_are_laid_over_the_picture_near_their_people(document):
    scene = _scene(document, view_options=ViewOptions(particles=True))
    assert scene.overlay.shape == (*scene.image.shape[:2], 4)
    assert scene.overlay[..., 3].any()
    assert _scene(document).overlay is None


def test_the_floor_grid_is_made_once_and_lies_in_view(document):
    pictures = PicturePresenter(document.recording)
    first = _scene(document, view_options=ViewOptions(grid=True), pictures=pictures).grid
    assert len(first) > 20
    assert _scene(document, view_options=ViewOptions(grid=True), pictures=pictures).grid is first
    assert len(_scene(document).grid) == 0


def test_a_frame_that_is_being_read_is_said(document):
    scene = PicturePresenter(document.recording).scene(
        Side.LEFT, None, document.frame_state(0), ViewOptions()
    )
    assert scene.image is None
    assert scene.message == "Reading..."


def test_the_floor_shows_people_particles_and_what_was_measured(document):
    scene = OverheadPresenter(document.recording).scene(document.frame_state(CROWDED))
    ids = document.tracks.of_frame(CROWDED)["track"].tolist()
    assert sorted(person.track for person in scene.people) == ids
    assert len(scene.particles) == len(scene.particle_colours) == len(scene.particle_weights)
    assert len(scene.measured) >= 1
    left, bottom, right, top = scene.bounds
    assert (scene.field_of_view >= (left, bottom)).all()
    assert (scene.field_of_view <= (right, top)).all()


def test_weights_are_relative_to_the_heaviest_particle_of_each_person():
    particles = two_people.run().particles.of_frame(50)
    weights = relative_weights(particles).reshape(2, two_people.PARTICLES)
    assert weights.max(axis=1).tolist() == [1.0, 1.0]
    assert weights[0, 1] == pytest.approx(0.75)
    assert len(relative_weights(two_people.run().particles.of_frame(999))) == 0


def test_people_without_metres_are_left_out_of_the_floor_but_not_of_the_picture(document):
    rows = dict(two_people.columns())
    rows["x"] = np.where(rows["track"] == 7, np.nan, rows["x"])
    state = FrameState(50, SessionTracks(TrackTable(rows), None))
    assert [
        person.track for person in OverheadPresenter(document.recording).scene(state).people
    ] == [4]
    frame = document.recording.read(50)
    marks = (
        PicturePresenter(document.recording).scene(Side.LEFT, frame, state, ViewOptions()).people
    )
    assert [mark.track for mark in marks] == [4, 7]


def test_frames_filled_by_interpolation_or_said_to_be_hidden_are_not_counted_as_seen(document):
    track = document.tracks.ids[0]
    rows = {name: column.copy() for name, column in document.tracks.of_track(track).items()}
    rows["predicted"][:] = False
    rows["visibility"][:] = 1.0
    rows["visibility"][0] = 0.0
    rows["source"][1:4] = Source.INTERPOLATED
    card = track_card(SessionTracks(TrackTable(rows), None), track, TrackLabel(), (1, 2, 3))
    assert (card.frames_occluded, card.frames_interpolated) == (1, 3)
    assert card.frames_seen == len(rows["frame"]) - 4


def test_the_card_tells_of_the_selected_track(document):
    assert document.card() is None
    track = document.tracks.ids[0]
    document.correcting.pick(track)
    card = document.card()
    rows = document.tracks.of_track(track)
    assert card.track == track
    assert card.frames_seen + card.frames_predicted == len(rows["frame"])
    assert (card.first_frame, card.last_frame) == (rows["frame"][0], rows["frame"][-1])


def test_metres_of_a_rough_calibration_are_marked_as_rough(document, monkeypatch):
    state = document.frame_state(CROWDED)
    assert not OverheadPresenter(document.recording).scene(state).rough
    rough = replace(document.recording.calibration, rough=True)
    monkeypatch.setattr(document.recording, "calibration", rough)
    assert OverheadPresenter(document.recording).scene(state).rough


def test_the_floor_worth_showing_holds_the_camera_also_where_it_sees_none_near_it():
    seen = np.array([(-2.0, 3.0), (2.0, 3.0), (6.0, 12.0), (-6.0, 12.0)])
    ground = SimpleNamespace(height_m=2.4, tilt_deg=10.0)
    view = SimpleNamespace(ground=ground, field_of_view=lambda _: seen)
    presenter = OverheadPresenter(SimpleNamespace(fps=20.0, view=view, calibration=None))
    left, bottom, right, top = presenter.bounds
    assert (left, right) == (-6 - MARGIN_M, 6 + MARGIN_M)
    assert (bottom, top) == (-MARGIN_M, 12 + MARGIN_M)


def test_what_is_outside_of_the_region_of_interest_is_dimmed(document, monkeypatch):
    assert _scene(document).overlay is None
    looked_at = np.zeros(document.recording.size[::-1], np.uint8)
    looked_at[:, 40:] = 255
    monkeypatch.setattr(document.recording, "looked_at", looked_at)
    pictures = PicturePresenter(document.recording)
    overlay = _scene(document, pictures=pictures).overlay
    assert overlay[10, 10].tolist() == [0, 0, 0, 110]
    assert not overlay[10, 50].any()
    assert _scene(document, pictures=pictures).overlay is overlay  # it is not painted anew
    assert _scene(document, Side.RIGHT, pictures=pictures).overlay is None
    assert (
        _scene(document, view_options=ViewOptions(region=False), pictures=pictures).overlay is None
    )
    laid = np.zeros((*looked_at.shape, 4), np.uint8)
    laid[10, 10] = (255, 0, 0, 200)
    below = pictures.scene(
        Side.LEFT,
        document.recording.read(CROWDED),
        document.frame_state(CROWDED),
        ViewOptions(),
        PictureOverlay(laid),
    ).overlay
    assert below[10, 10].tolist() == [255, 0, 0, 200]
    assert below[11, 11].tolist() == [0, 0, 0, 110]
    assert not below[10, 50].any()

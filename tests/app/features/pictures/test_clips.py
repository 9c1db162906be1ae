"""Clips of a recording: which pictures they have, what is on them, and that they come whole."""

from __future__ import annotations

import threading
from collections.abc import Iterator
from dataclasses import replace

import av
import numpy as np
import pytest
from PySide6.QtGui import QFont

from app.core.colours.track_colours import TrackColours
from app.core.error_messages import explain
from app.core.look.theme import load_theme
from app.core.tracks.frame_state import FrameState, ViewOptions
from app.core.tracks.session_tracks import SessionTracks
from app.features.pictures.clip import ClipChoice, ClipKind, ClipSource
from app.features.pictures.clip_crop import follow
from app.features.pictures.clip_file import write_clip
from app.features.pictures.clip_painter import ClipPainter
from tracking.errors import CancelledError, EditError, OutputError
from tracking.recording import open_recording
from tracking.tracks import TrackTable

CHOICE = ClipChoice(ClipKind.MP4, 32, 48, 240, 8.0)


@pytest.fixture
def source(qapp, tiny_recording, tiny_run):
    tracks = SessionTracks(TrackTable(tiny_run.tracks), tiny_run)
    with open_recording(tiny_recording) as recording:
        yield ClipSource(
            recording,
            0,
            tracks,
            FrameState(0, tracks, {}, run=tiny_run, colours=TrackColours()),
            ViewOptions(),
            (-5.0, 0.0, 5.0, 10.0),
            (),
            (),
            load_theme("dark"),
            QFont(),
        )


def nothing(done, total):
    """Nobody asks how far it is."""


def pictures_of(path):
    with av.open(str(path)) as container:
        stream = container.streams.video[0]
        return [frame.to_ndarray(format="bgr24") for frame in container.decode(stream)]


def test_a_clip_shows_each_frame_once_at_the_recordings_own_rate():
    assert list(CHOICE.repeats(8.0)) == [(frame, 1) for frame in range(32, 48)]


def test_a_slow_clip_repeats_frames_and_a_fast_one_passes_over_some():
    slow = replace(CHOICE, speed=0.5)
    assert list(slow.repeats(8.0)) == [(frame, 2) for frame in range(32, 48)]
    fast = replace(CHOICE, speed=4.0)
    assert list(fast.repeats(8.0)) == [(frame, 1) for frame in range(32, 48, 4)]


def test_pictures_at_another_rate_still_take_the_time_that_passed():
    other = replace(CHOICE, fps=30.0)
    assert sum(times for _, times in other.repeats(8.0)) == other.picture_count(8.0) == 60


@pytest.mark.parametrize("kind", list(ClipKind))
def test_it_is_written_whole_and_can_be_played(source, tmp_path, kind):
    path, told = tmp_path / f"clip{kind.value}", []
    choice = replace(CHOICE, kind=kind, height_px=160)
    count = write_clip(source, choice, path, lambda done, total: told.append((done, total)))
    pictures = pictures_of(path)
    assert len(pictures) == count == 16
    assert pictures[0].shape[:2] == (160, 214)
    assert told[-1] == (16, 16)
    assert [one.name for one in tmp_path.iterdir()] == [path.name]


def test_people_are_drawn_in_their_colour_and_left_out_where_they_are_not_wanted(source):
    with_people, without = (
        ClipPainter(source, replace(CHOICE, people=people, trails=False))
        for people in (True, False)
    )
    frame = source.recording.read(40)
    drawn, plain = with_people.paint(frame), without.paint(frame)
    track = source.tracks.of_frame(40)["track"].tolist()[0]
    wanted = np.array(source.state.colours.of(track)[::-1])

    def inked(picture):
        return int((np.abs(picture.astype(int) - wanted).max(axis=2) < 12).sum())

    assert inked(drawn) > inked(plain) + 20
    assert np.abs(plain.astype(int) - frame.left).mean() < 3.0


def test_people_that_are_not_wanted_are_not_on_the_floor_either(source):
    choice = replace(CHOICE, floor=True, legends=False, stamp=False, trails=False)
    frame = source.recording.read(40)
    drawn, plain = (
        ClipPainter(source, replace(choice, people=people)).paint(frame)[:, 320:]
        for people in (True, False)
    )
    track = source.tracks.of_frame(40)["track"].tolist()[0]
    wanted = np.array(source.state.colours.of(track)[::-1])
    near = [(np.abs(one.astype(int) - wanted).max(axis=2) < 12).any() for one in (drawn, plain)]
    assert near == [True, False]


def test_both_cameras_and_the_floor_stand_side_by_side(source):
    narrow = ClipPainter(source, CHOICE)
    wide = ClipPainter(source, replace(CHOICE, right=True, floor=True))
    assert narrow.size == (320, 240)
    assert wide.size[0] == 2 * 320 + 240
    picture = wide.paint(source.recording.read(40))
    right = source.recording.read(40).right
    plain = ClipPainter(source, replace(CHOICE, right=True, people=False, trails=False))
    shown = plain.paint(source.recording.read(40))[:, 320:]
    assert np.abs(shown.astype(int) - right).mean() < 3.0
    assert picture[:, 640:].std() > 1.0


def test_a_followed_person_stays_in_the_middle_of_their_part_of_the_picture(source):
    ids, counts = np.unique(source.tracks.of_frame(40)["track"], return_counts=True)
    track = int(ids[counts.argmax()])
    rows = source.tracks.of_track(track)
    parts = follow(rows, (32, 48), source.recording.size, source.recording.fps)
    assert parts is not None
    assert len({tuple(part) for part in parts[:, 2:].tolist()}) == 1
    assert (parts[:, :2] >= 0).all()
    assert (parts[:, :2] + parts[:, 2:] <= (320 + 1e-6, 240 + 1e-6)).all()
    for row in range(len(rows["frame"])):
        frame = int(rows["frame"][row])
        if 32 <= frame < 48:
            left, _, width, _ = parts[frame - 32]
            middle = rows["left"][row] + rows["width"][row] / 2
            assert left <= middle <= left + width
    painter = ClipPainter(source, replace(CHOICE, follow=track))
    assert painter.size[0] < 320
    assert painter.paint(source.recording.read(40)).shape[0] == 240


def test_nobody_is_followed_who_is_not_there(source):
    with pytest.raises(EditError, match="not in these frames"):
        ClipPainter(source, replace(CHOICE, follow=9999))


def test_a_clip_that_is_cancelled_leaves_nothing(source, tmp_path):
    def stop(done, total):
        if done == 3:
            raise CancelledError("stopped by the user")

    with pytest.raises(CancelledError):
        write_clip(source, replace(CHOICE, kind=ClipKind.GIF), tmp_path / "clip.gif", stop)
    with pytest.raises(CancelledError):
        write_clip(source, CHOICE, tmp_path / "clip.mp4", stop)
    assert list(tmp_path.iterdir()) == []


@pytest.fixture
def small_disk() -> Iterator[None]:
    """Files are refused what goes beyond a few bytes."""
    resource = pytest.importorskip("resource")
    before = resource.getrlimit(resource.RLIMIT_FSIZE)
    resource.setrlimit(resource.RLIMIT_FSIZE, (256, before[1]))
    yield
    resource.setrlimit(resource.RLIMIT_FSIZE, before)


@pytest.mark.usefixtures("small_disk")
@pytest.mark.parametrize("kind", list(ClipKind))
def test_a_disk_that_is_full_is_told_of_the_file_that_was_asked_for(source, tmp_path, kind):
    path = tmp_path / f"clip{kind.value}"
    with pytest.raises(OutputError) as caught:
        write_clip(source, replace(CHOICE, kind=kind), path, nothing)
    assert explain(caught.value) == f"cannot write {path}: File too large; choose another place"
    assert list(tmp_path.iterdir()) == []


def test_a_clip_goes_only_where_a_file_can_be(source, tmp_path):
    with pytest.raises(OutputError):
        write_clip(source, CHOICE, tmp_path / "missing" / "clip.mp4", nothing)


def test_it_is_painted_off_the_gui_thread(source, tmp_path):
    ended = []
    path = tmp_path / "clip.mp4"
    choice = replace(CHOICE, right=True, floor=True, stamp=True)
    thread = threading.Thread(
        target=lambda: ended.append(write_clip(source, choice, path, nothing))
    )
    thread.start()
    thread.join()
    assert ended == [16]
    assert len(pictures_of(path)) == 16


@pytest.fixture
def noted(monkeypatch):
    """All words that plates and legends of a clip were given."""
    from app.features.pictures import captions, clip_painter, floor_legend

    words = []

    def note(place, name, at, read=lambda given: [given]):
        draw = getattr(place, name)

        def heard(*args):
            words.extend(read(args[at]))
            return draw(*args)

        monkeypatch.setattr(place, name, heard)

    note(captions, "draw_note", 2)
    note(captions, "draw_legend", 1, lambda entries: [one.text for one in entries])
    note(clip_painter, "draw_note", 2)
    note(floor_legend, "_draw_plate", 2, lambda lines: [text for _, text in lines])
    return words


ALL = ViewOptions(foreground=True)


@pytest.mark.parametrize("kind", list(ClipKind))
def test_legends_names_of_cameras_and_time_stand_on_it(source, noted, kind):
    choice = replace(CHOICE, kind=kind, right=True, floor=True, height_px=480)
    ClipPainter(replace(source, view_options=ALL), choice).paint(source.recording.read(40))
    assert {"foreground", "shadow", "Left camera", "Right camera"} <= set(noted)
    assert "where the tracker has a person" in noted
    assert "frame 40, 00:05.00" in noted


@pytest.mark.parametrize("kind", list(ClipKind))
def test_legend_and_time_are_on_every_picture_of_the_file(source, tmp_path, kind):
    shown = replace(source, view_options=ALL)
    choice = replace(CHOICE, kind=kind, people=False, trails=False)
    told, plain = (tmp_path / f"{name}{kind.value}" for name in ("told", "plain"))
    write_clip(shown, choice, told, nothing)
    write_clip(shown, replace(choice, legends=False, stamp=False), plain, nothing)
    for with_words, without in zip(pictures_of(told), pictures_of(plain), strict=True):
        differs = np.abs(with_words.astype(int) - without).max(axis=2) > 60
        assert differs[:24, :160].sum() > 100  # frame number and time
        assert differs[24:].sum() > 100  # the legend
        assert differs.mean() < 0.25


def test_a_clip_of_one_camera_does_not_name_it(source, noted):
    ClipPainter(replace(source, view_options=ALL), CHOICE).paint(source.recording.read(40))
    assert "foreground" in noted
    assert "Left camera" not in noted


def test_no_words_stand_on_it_where_they_are_not_wanted(source, noted):
    choice = replace(CHOICE, right=True, floor=True, legends=False, stamp=False)
    ClipPainter(replace(source, view_options=ALL), choice).paint(source.recording.read(40))
    assert set(noted) <= {""}


def test_what_features_draw_over_the_floor_stands_on_it(source):
    from app.core.scenes.labels import FloorLabels, Outline

    gate = Outline("gate", np.array([[0.0, 2.0], [0.0, 8.0]]), False, (255, 120, 0))
    plain = replace(CHOICE, floor=True, legends=False)
    marked = replace(
        source, floor_markers=(lambda marks, _: replace(marks, labels=FloorLabels((gate,))),)
    )
    frame = source.recording.read(40)
    before, with_gate = (ClipPainter(one, plain).paint(frame) for one in (source, marked))
    differs = (before != with_gate).any(axis=2)
    assert differs[:, 320:].any()
    assert not differs[:, :320].any()
    without = ClipPainter(marked, replace(plain, marks=False)).paint(frame)
    assert np.array_equal(without[:, 320:], before[:, 320:])

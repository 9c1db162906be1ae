"""A session finds its recording again, and opens nothing it was not told to."""

from __future__ import annotations

from pathlib import Path

import pytest
from made_up_sessions import fingerprints_of, make_recording, make_run, make_session

from tracking.session import KnownRecordings, RecordingMissing, Session
from tracking.session import reference as references
from tracking.session.reference import refer_to, stays_inside


@pytest.fixture(autouse=True)
def look(monkeypatch: pytest.MonkeyPatch) -> None:
    """Fingerprints of the made-up recordings, which have no pictures."""
    monkeypatch.setattr(references, "fingerprints_at", fingerprints_of)


def opened(path: Path) -> Session:
    session = Session.open(path)
    session.close()
    return session


@pytest.fixture
def path(tmp_path: Path) -> Path:
    """A closed session beside its recording."""
    session = make_session(tmp_path / "work")
    session.close()
    return tmp_path / "work" / "s.h5"


def test_the_reference_says_what_the_recording_is(path: Path) -> None:
    recording = opened(path).recording
    assert recording.name == "Lobby, camera 3"
    assert (recording.fps, recording.frame_count, recording.size) == (20.0, 40, (640, 480))
    assert recording.is_stereo
    assert recording.calibration == "M1: ä\n"
    assert recording.path == "recording"
    assert recording.sources == fingerprints_of(path.parent / "recording")


def test_a_recording_beside_the_session_is_found(path: Path) -> None:
    assert opened(path).locate_recording() == path.parent / "recording"


def test_session_and_recording_move_together(path: Path, tmp_path: Path) -> None:
    path.parent.rename(tmp_path / "moved")
    found = opened(tmp_path / "moved" / "s.h5").locate_recording()
    assert found == tmp_path / "moved" / "recording"


def test_a_recording_in_a_folder_above_is_found_by_name(path: Path, tmp_path: Path) -> None:
    (path.parent / "recording").rename(tmp_path / "recording")
    assert opened(path).locate_recording() == tmp_path / "recording"


def test_a_recording_that_is_gone_is_said_and_the_tracks_are_there(path: Path) -> None:
    (path.parent / "recording").rename(path.parent / "elsewhere")
    session = opened(path)
    assert len(session.tracks) > 0
    with pytest.raises(RecordingMissing, match=r"was at recording.*--recording PATH"):
        session.locate_recording()


def test_a_recording_is_found_where_the_user_says(path: Path) -> None:
    moved = path.parent / "archive" / "2024"
    moved.parent.mkdir()
    (path.parent / "recording").rename(moved)
    assert opened(path).locate_recording([moved]) == moved


def test_a_recording_is_found_in_a_folder_the_user_names(path: Path) -> None:
    archive = path.parent / "archive"
    archive.mkdir()
    (path.parent / "recording").rename(archive / "recording")
    assert opened(path).locate_recording([archive]) == archive / "recording"


def test_another_recording_under_the_name_is_not_taken(path: Path) -> None:
    (path.parent / "recording" / "left.mp4").write_bytes(b"other pictures")
    with pytest.raises(RecordingMissing, match="is another one"):
        opened(path).locate_recording()


def test_a_place_outside_is_opened_only_when_allowed(tmp_path: Path) -> None:
    recording = make_recording(tmp_path / "data" / "deep" / "footage")
    (tmp_path / "out").mkdir()
    path = tmp_path / "out" / "s.h5"
    Session.create(recording, [make_run()], path).close()
    session = opened(path)
    assert session.recording.path == "../data/deep/footage"
    with pytest.raises(RecordingMissing, match="not opened unasked"):
        session.locate_recording()
    assert session.locate_recording(allow_outside=True) == recording.path


def test_a_place_outside_that_this_user_knows_is_opened(tmp_path: Path) -> None:
    recording = make_recording(tmp_path / "data" / "deep" / "footage")
    known = KnownRecordings(tmp_path / "own")
    (tmp_path / "out").mkdir()
    path = tmp_path / "out" / "s.h5"
    made = Session.create(recording, [make_run()], path)
    assert made.locate_recording(known=known) == recording.path
    made.close()
    assert opened(path).locate_recording(known=known) == recording.path


def test_a_new_place_is_in_the_file_after_the_next_save(path: Path) -> None:
    (path.parent / "recording").rename(path.parent / "renamed")
    session = Session.open(path)
    session.locate_recording([path.parent / "renamed"])
    session.save()
    session.close()
    assert opened(path).recording.path == "renamed"


@pytest.mark.parametrize(
    ("written", "inside"),
    [
        ("recording", True),
        ("a/b/left.mp4", True),
        ("a..b", True),
        ("..", False),
        ("a/../../b", False),
        ("..\\b", False),
        ("/etc/passwd", False),
        ("\\\\server\\share", False),
        ("//server/share", False),
        ("C:\\data", False),
        ("C:data", False),
        ("~/data", False),
    ],
)
def test_paths_that_leave_the_folder_are_told_on_every_system(written: str, inside: bool) -> None:
    assert stays_inside(written) == inside


@pytest.mark.parametrize("text", ["", "[]", "{", '{"x": 5}', "[" * 100_000])
def test_a_damaged_list_of_known_recordings_is_as_good_as_none(tmp_path: Path, text: str) -> None:
    recording = make_recording(tmp_path / "footage")
    reference = refer_to(recording, tmp_path)
    (tmp_path / "recordings.json").write_text(text)
    known = KnownRecordings(tmp_path)
    assert known.find(reference) is None
    known.remember(reference, recording.path)
    assert known.find(reference) == recording.path


def test_a_list_that_cannot_be_written_bothers_nobody(tmp_path: Path) -> None:
    recording = make_recording(tmp_path / "footage")
    (tmp_path / "file").write_text("no folder")
    KnownRecordings(tmp_path / "file").remember(refer_to(recording, tmp_path), recording.path)

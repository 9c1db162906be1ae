"""A session finds its recording again, whole, and opens nothing it was not told to."""

from __future__ import annotations

import shutil
from dataclasses import replace
from pathlib import Path

import pytest
from small_footage import (
    GROUND,
    is_whole,
    reopened,
    session_on,
    write_footage,
    write_pictures,
    write_rig,
)

from tracking.geometry import Ground
from tracking.recording import OpenOptions, open_recording, read_manifest, write_manifest
from tracking.session import KnownRecordings, RecordingMissing, Session
from tracking.session.reference import refer_to, stays_inside


@pytest.fixture
def path(tmp_path: Path) -> Path:
    """A closed session beside its recording."""
    recording = write_footage(tmp_path / "work" / "recording")
    return session_on(tmp_path / "work" / "s.h5", recording)


def place_of(session: Session, *search: Path, **how: bool) -> Path:
    """Where the recording is found."""
    with session.open_recording(search, **how) as recording:
        return recording.path


def bare(left: Path, right: Path, calibration: Path) -> OpenOptions:
    """All options that a recording without recording.toml needs."""
    return OpenOptions(left, right, (calibration,), GROUND.height_m, GROUND.tilt_deg, fps=10)


# A recording with its own recording.toml


def test_the_reference_says_what_the_recording_is(path: Path) -> None:
    reference = reopened(path).recording
    with open_recording(path.parent / "recording") as recording:
        assert reference == refer_to(recording, path.parent)
    assert (reference.name, reference.path, reference.own_manifest) == ("Hall", "recording", True)
    assert (reference.fps, reference.frame_count, reference.size) == (10.0, 3, (32, 24))
    assert reference.is_stereo


def test_a_recording_beside_the_session_is_found_whole(path: Path) -> None:
    session = reopened(path)
    assert place_of(session) == path.parent / "recording"
    assert is_whole(session.open_recording())
    assert session.notes == ()


def test_session_and_recording_move_together(path: Path, tmp_path: Path) -> None:
    path.parent.rename(tmp_path / "moved")
    found = place_of(reopened(tmp_path / "moved" / "s.h5"))
    assert found == tmp_path / "moved" / "recording"


def test_a_recording_in_a_folder_above_is_found_by_name(path: Path, tmp_path: Path) -> None:
    (path.parent / "recording").rename(tmp_path / "recording")
    assert place_of(reopened(path)) == tmp_path / "recording"


def test_where_a_moved_recording_was_found_is_told_once(path: Path, tmp_path: Path) -> None:
    (path.parent / "recording").rename(tmp_path / "recording")
    session = reopened(path)
    place_of(session)
    place_of(session)
    assert [note for note in session.notes if "has moved; it was found at" in note] == [
        f'recording "{session.recording.name}" has moved; it was found at {tmp_path / "recording"}'
    ]
    session.close()


def test_a_place_the_user_names_is_not_told_again(path: Path) -> None:
    moved = (path.parent / "recording").rename(path.parent / "archive")
    session = reopened(path)
    place_of(session, moved)
    assert session.notes == ()
    session.close()


def test_a_session_copied_with_its_recording_opens_the_copy_beside_it(
    path: Path, tmp_path: Path
) -> None:
    known = KnownRecordings(tmp_path / "own")
    reopened(path).open_recording(known=known).close()  # where this user had it last
    shutil.copytree(path.parent, tmp_path / "copy")
    with reopened(tmp_path / "copy" / "s.h5").open_recording(known=known) as recording:
        assert recording.path == tmp_path / "copy" / "recording"


def test_a_session_copied_alone_opens_the_recording_where_this_user_had_it(
    path: Path, tmp_path: Path
) -> None:
    known = KnownRecordings(tmp_path / "own")
    reopened(path).open_recording(known=known).close()
    (tmp_path / "copy").mkdir()
    copy = Path(shutil.copy(path, tmp_path / "copy" / "s.h5"))
    with reopened(copy).open_recording(known=known) as recording:
        assert recording.path == path.parent / "recording"


def test_a_recording_that_is_gone_is_said(path: Path) -> None:
    (path.parent / "recording").rename(path.parent / "elsewhere")
    with pytest.raises(RecordingMissing, match=r"was at recording.*is gone.*--recording PATH"):
        reopened(path).open_recording()


def test_a_recording_is_found_where_the_user_says(path: Path) -> None:
    moved = path.parent / "archive" / "2024"
    moved.parent.mkdir()
    (path.parent / "recording").rename(moved)
    assert place_of(reopened(path), moved) == moved
    assert place_of(reopened(path), moved / "recording.toml") == moved


def test_a_recording_is_found_in_a_folder_the_user_names(path: Path) -> None:
    archive = path.parent / "archive"
    archive.mkdir()
    (path.parent / "recording").rename(archive / "recording")
    assert place_of(reopened(path), archive) == archive / "recording"


def test_another_recording_under_the_name_is_not_taken(path: Path) -> None:
    write_pictures(path.parent / "recording" / "left", 7)
    with pytest.raises(RecordingMissing, match="is another one"):
        reopened(path).open_recording()


def test_why_the_right_recording_cannot_be_opened_is_said(path: Path) -> None:
    (path.parent / "recording" / "rig.yaml").unlink()
    with pytest.raises(RecordingMissing, match=r"rig\.yaml"):
        reopened(path).open_recording()


def test_a_new_place_is_in_the_file_after_the_next_save(path: Path) -> None:
    (path.parent / "recording").rename(path.parent / "renamed")
    session = Session.open(path)
    session.open_recording([path.parent / "renamed"]).close()
    session.save()
    session.close()
    assert reopened(path).recording.path == "renamed"


def test_a_recording_toml_that_changed_counts_and_the_session_says_so(path: Path) -> None:
    folder = path.parent / "recording"
    write_manifest(folder, replace(read_manifest(folder), ground=Ground(2.4, 35.0)))
    session = Session.open(path)
    with session.open_recording() as recording:
        assert recording.ground == Ground(2.4, 35.0)
    session.open_recording().close()
    assert len(session.notes) == 1
    assert "recording.toml has changed since the tracks were made (ground)" in session.notes[0]
    session.save()
    session.close()
    assert "tilt = 30.0" in reopened(path).recording.manifest


def test_a_calibration_that_changed_counts_and_the_session_says_so(path: Path) -> None:
    with (path.parent / "recording" / "rig.yaml").open("a") as file:
        file.write("# measured again\n")
    session = reopened(path)
    session.open_recording().close()
    assert ["calibration has changed" in note for note in session.notes] == [True]


def test_another_wording_of_recording_toml_is_no_change(path: Path) -> None:
    with (path.parent / "recording" / "recording.toml").open("a") as file:
        file.write("# by the stairs\n")
    session = reopened(path)
    session.open_recording().close()
    assert session.notes == ()


@pytest.mark.parametrize("damage", ["gone", "spoiled"])
def test_without_its_recording_toml_a_recording_opens_as_the_session_keeps_it(
    path: Path, damage: str
) -> None:
    manifest = path.parent / "recording" / "recording.toml"
    manifest.unlink()
    if damage == "spoiled":
        manifest.write_text("left =")
    session = reopened(path)
    assert is_whole(session.open_recording())
    assert len(session.notes) == (damage == "spoiled")


def test_what_the_user_said_of_a_recording_counts_before_its_recording_toml(
    tmp_path: Path,
) -> None:
    recording = write_footage(tmp_path / "recording")
    path = session_on(tmp_path / "s.h5", recording, OpenOptions(tilt_deg=35.0))
    with reopened(path).open_recording() as found:
        assert found.ground == Ground(2.4, 35.0)
        assert found.rectification is not None


# Recordings without one


def test_bare_cameras_with_options_open_whole(tmp_path: Path) -> None:
    left, right = write_pictures(tmp_path / "a" / "l", 1), write_pictures(tmp_path / "b" / "r", 2)
    options = bare(left, right, write_rig(tmp_path / "rigs" / "rig.yaml"))
    path = session_on(tmp_path / "s.h5", left, options)
    session = reopened(path)
    assert is_whole(session.open_recording())
    assert session.recording.path == "."
    assert not session.recording.own_manifest
    tmp_path.rename(tmp_path.with_name("moved"))
    assert is_whole(reopened(tmp_path.with_name("moved") / "s.h5").open_recording())
    tmp_path.with_name("moved").rename(tmp_path)


def test_a_calibration_from_elsewhere_belongs_to_the_recording(tmp_path: Path) -> None:
    folder = write_footage(tmp_path / "footage")
    (folder / "recording.toml").unlink()
    (folder / "rig.yaml").rename(tmp_path / "rig.yaml")
    options = OpenOptions(
        calibration=(tmp_path / "rig.yaml",), height_m=2.4, tilt_deg=30.0, fps=10.0
    )
    path = session_on(tmp_path / "s.h5", folder, options)
    assert is_whole(reopened(path).open_recording())


def test_one_image_folder_opens_with_its_truth(tmp_path: Path) -> None:
    pictures = write_pictures(tmp_path / "walk", 1)
    (pictures / "truth.txt").touch()
    path = session_on(tmp_path / "s.h5", pictures, OpenOptions(fps=10.0))
    with reopened(path).open_recording() as found:
        assert (found.path, found.fps) == (pictures, 10)
        assert found.truth_path == pictures / "truth.txt"


def test_pictures_with_both_cameras_open_as_they_were_laid_out(tmp_path: Path) -> None:
    pictures = write_pictures(tmp_path / "both", 1)
    options = OpenOptions(fps=10.0, layout="side-by-side", first="right")
    path = session_on(tmp_path / "s.h5", pictures, options)
    with open_recording(pictures, options) as first, reopened(path).open_recording() as found:
        assert found.is_stereo
        assert (found.read(1).left == first.read(1).left).all()


def test_pictures_that_were_renamed_are_found_where_the_user_says(tmp_path: Path) -> None:
    pictures = write_pictures(tmp_path / "work" / "walk", 1)
    path = session_on(tmp_path / "work" / "s.h5", pictures, OpenOptions(fps=10.0))
    moved = pictures.rename(tmp_path / "stroll")
    known = KnownRecordings(tmp_path / "own")
    session = Session.open(path)
    session.open_recording([moved], known).close()
    with reopened(path).open_recording(known=known) as found:
        assert found.path == moved
    session.save()
    session.close()
    with reopened(path).open_recording(known=known) as found:
        assert found.path == moved


def test_pictures_in_a_folder_above_the_session_are_found(tmp_path: Path) -> None:
    pictures = write_pictures(tmp_path / "walk", 1)
    path = session_on(tmp_path / "out" / "s.h5", pictures, OpenOptions(fps=10.0))
    assert place_of(reopened(path)) == pictures


def test_bare_cameras_that_were_given_a_recording_toml_are_found_where_the_user_says(
    tmp_path: Path,
) -> None:
    left, right = write_pictures(tmp_path / "a" / "l", 1), write_pictures(tmp_path / "b" / "r", 2)
    path = session_on(tmp_path / "s.h5", left, OpenOptions(left, right, fps=10.0))
    tidy = write_footage(tmp_path / "tidy")
    for old in (left, right):
        old.rename(old.with_name("old"))
    with pytest.raises(RecordingMissing):
        reopened(path).open_recording()
    assert is_whole(reopened(path).open_recording([tidy]))


# What is not opened


def test_a_place_outside_is_opened_only_when_allowed(tmp_path: Path) -> None:
    recording = write_footage(tmp_path / "data" / "deep" / "footage")
    session = reopened(session_on(tmp_path / "out" / "s.h5", recording))
    assert session.recording.path == "../data/deep/footage"
    with pytest.raises(RecordingMissing, match="only where you name it"):
        session.open_recording()
    assert place_of(session, allow_outside=True) == recording


def test_a_place_outside_that_this_user_knows_is_opened(tmp_path: Path) -> None:
    recording = write_footage(tmp_path / "data" / "deep" / "footage")
    known = KnownRecordings(tmp_path / "own")
    path = session_on(tmp_path / "out" / "s.h5", recording)
    reopened(path).open_recording(known=known, allow_outside=True).close()
    with reopened(path).open_recording(known=known) as found:
        assert found.path == recording


@pytest.mark.parametrize("own", [True, False])
def test_a_manifest_that_leads_outside_needs_leave_where_this_user_never_had_it(
    tmp_path: Path, own: bool
) -> None:
    pictures = write_pictures(tmp_path / "elsewhere", 1)
    folder = tmp_path / "work" / "recording"
    folder.mkdir(parents=True)
    (folder / "recording.toml").write_text('fps = 10\n[left]\nsource = "../../elsewhere"\n')
    path = session_on(tmp_path / "work" / "s.h5", folder, OpenOptions(allow_outside=True))
    if not own:
        (folder / "recording.toml").unlink()
    with pytest.raises(RecordingMissing, match="outside the folder"):
        reopened(path).open_recording()
    known = KnownRecordings(tmp_path / "own")
    reopened(path).open_recording(known=known, allow_outside=True).close()
    with reopened(path).open_recording(known=known) as found:
        assert [source.resolve() for source in found.sources] == [pictures]


def test_pictures_below_a_folder_above_the_session_are_not_the_files_to_choose(
    tmp_path: Path,
) -> None:
    pictures = write_pictures(tmp_path / "private" / "album", 1)
    write_pictures(tmp_path / "right", 2)
    options = OpenOptions(pictures, tmp_path / "right", fps=10.0)
    path = session_on(tmp_path / "downloads" / "s.h5", pictures, options)
    with pytest.raises(RecordingMissing, match="only where you name it"):
        reopened(path).open_recording()


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


# What this user knows


@pytest.mark.parametrize("text", ["", "[]", "{", '{"x": 5}', "[" * 100_000])
def test_a_damaged_list_of_known_recordings_is_as_good_as_none(
    path: Path, tmp_path: Path, text: str
) -> None:
    reference = reopened(path).recording
    (tmp_path / "recordings.json").write_text(text)
    known = KnownRecordings(tmp_path)
    assert known.find(reference) is None
    known.remember(reference, tmp_path / "footage")
    assert known.find(reference) == tmp_path / "footage"


def test_a_list_that_cannot_be_written_bothers_nobody(path: Path, tmp_path: Path) -> None:
    (tmp_path / "file").write_text("no folder")
    known, reference = KnownRecordings(tmp_path / "file"), reopened(path).recording
    known.remember(reference, tmp_path)
    assert known.find(reference) is None
    assert (tmp_path / "file").read_text() == "no folder"

"""What stands beside a session is not trusted: links, pipes and others' files harm nothing."""

from __future__ import annotations

import errno
import os
import shutil
import stat
import sys
import tempfile
from collections.abc import Callable
from pathlib import Path

import pytest
from made_up_sessions import edit, make_session

from app.cli.restore import run_restore
from app.core.document.document_loader import copy_newest_backup
from tracking.errors import OutputError, SessionError, TrackwrightError, UnsafeFileError
from tracking.session import Session, find_backups, list_backups, replace_damaged
from tracking.session.session_writer import companions

pytestmark = pytest.mark.skipif(sys.platform == "win32", reason="links and pipes of POSIX")
only_root = pytest.mark.skipif(
    sys.platform != "win32" and os.geteuid() != 0, reason="only root can become somebody else"
)
NOBODY = 65534


@pytest.fixture
def path(tmp_path: Path) -> Path:
    """A session that is closed, without anything beside it."""
    session = make_session(tmp_path)
    session.close()
    assert session.path is not None
    return session.path


@pytest.fixture
def saved_thrice(tmp_path: Path) -> Path:
    """A session that is closed, with two backups."""
    session = make_session(tmp_path)
    for _ in range(2):
        edit(session)
        session.save()
    session.close()
    assert session.path is not None
    return session.path


@pytest.fixture
def elsewhere(tmp_path: Path) -> Path:
    """A folder with files that are nobody's business."""
    folder = tmp_path / "elsewhere"
    folder.mkdir()
    (folder / "saving-mine.h5").write_bytes(b"precious")
    (folder / "file").write_bytes(b"precious")
    return folder


def states(folder: Path) -> dict[str, bytes]:
    return {file.name: file.read_bytes() for file in folder.iterdir()}


def as_link(place: Path, elsewhere: Path) -> None:
    place.symlink_to(elsewhere / "file")


def as_dangling_link(place: Path, elsewhere: Path) -> None:
    place.symlink_to(elsewhere / "made")


def as_second_name(place: Path, elsewhere: Path) -> None:
    place.hardlink_to(elsewhere / "file")


def as_pipe(place: Path, _: Path) -> None:
    os.mkfifo(place)


def as_endless_device(place: Path, _: Path) -> None:
    place.symlink_to("/dev/zero")


def as_folder(place: Path, _: Path) -> None:
    place.mkdir()


Trap = Callable[[Path, Path], None]
TRAPS = [as_link, as_dangling_link, as_second_name, as_pipe, as_endless_device, as_folder]


@pytest.mark.parametrize("trap", [*TRAPS[:-1], None])
def test_a_session_beside_a_trap_in_place_of_its_folder_opens_for_reading_and_says_so(
    path: Path, elsewhere: Path, trap: Trap | None
) -> None:
    if trap is None:
        companions(path).symlink_to(elsewhere)
    else:
        trap(companions(path), elsewhere)
    before = states(elsewhere)
    session = Session.open(path)
    assert session.read_only
    assert f"{companions(path)} is " in session.notes[0]
    with pytest.raises(SessionError, match="open for reading only"):
        session.save()
    session.close()
    Session.look_into(path).close()
    assert states(elsewhere) == before


@pytest.mark.parametrize("trap", TRAPS)
def test_nothing_is_written_through_a_lock_that_is_no_file_of_ours(
    path: Path, elsewhere: Path, trap: Trap
) -> None:
    companions(path).mkdir()
    trap(companions(path) / "lock", elsewhere)
    before = states(elsewhere)
    session = Session.open(path)
    assert session.read_only
    assert str(companions(path) / "lock") in session.notes[0]
    session.close()
    another = make_session(path.parent / "another")
    with pytest.raises(UnsafeFileError, match="lock "):
        another.save(path)
    another.close()
    assert states(elsewhere) == before


@pytest.mark.parametrize("trap", TRAPS)
def test_what_looks_like_a_save_cut_short_leads_nowhere(
    path: Path, elsewhere: Path, trap: Trap
) -> None:
    companions(path).mkdir()
    trap(companions(path) / "saving-1.h5", elsewhere)
    before = states(elsewhere)
    session = Session.open(path)
    assert not session.read_only
    edit(session)
    session.save()
    session.close()
    assert states(elsewhere) == before


@pytest.mark.parametrize("trap", TRAPS)
def test_a_trap_among_the_backups_is_listed_with_its_problem_and_never_restored(
    saved_thrice: Path, elsewhere: Path, trap: Trap
) -> None:
    newest = find_backups(saved_thrice)[0]
    newest.unlink()
    trap(newest, elsewhere)
    present, before = saved_thrice.read_bytes(), states(elsewhere)
    listed = list_backups(saved_thrice)
    assert [bool(kept.problem) for kept in listed] == [True, False]
    assert str(newest) in listed[0].problem
    # A second name is read, as of any file of the user's: this one is no session.
    refused = SessionError if trap is as_second_name else UnsafeFileError
    with pytest.raises(refused):
        run_restore(saved_thrice, 1, only_list=False, as_json=True)
    if trap is not as_second_name:
        with pytest.raises(UnsafeFileError):
            copy_newest_backup(saved_thrice)
    assert saved_thrice.read_bytes() == present
    run_restore(saved_thrice, 2, only_list=False, as_json=True)
    assert states(elsewhere) == before


@pytest.mark.parametrize("trap", TRAPS)
def test_a_save_keeps_the_present_file_whatever_stands_among_the_backups(
    path: Path, elsewhere: Path, trap: Trap
) -> None:
    companions(path).mkdir()
    trap(companions(path) / "s.1.h5", elsewhere)
    saved, before = path.read_bytes(), states(elsewhere)
    session = Session.open(path)
    edit(session)
    session.save()
    session.close()
    assert (companions(path) / "s.1.h5").read_bytes() == saved
    assert states(elsewhere) == before


def test_a_link_to_the_session_is_no_backup_of_it(path: Path) -> None:
    companions(path).mkdir()
    (companions(path) / "s.1.h5").symlink_to(path)
    saved = path.read_bytes()
    session = Session.open(path)
    edit(session)
    session.save()
    session.close()
    assert (companions(path) / "s.1.h5").read_bytes() == saved
    assert not (companions(path) / "s.1.h5").is_symlink()


def test_backups_in_a_folder_that_is_a_link_are_not_restored(saved_thrice: Path) -> None:
    away = saved_thrice.parent / "away"
    companions(saved_thrice).rename(away)
    companions(saved_thrice).symlink_to(away)
    before = states(away)
    for restore in (
        lambda: list_backups(saved_thrice),
        lambda: run_restore(saved_thrice, 1, only_list=False, as_json=True),
        lambda: replace_damaged(saved_thrice, 1),
    ):
        with pytest.raises(UnsafeFileError, match="is a link, which is not followed"):
            restore()
    assert find_backups(saved_thrice) == ()
    assert states(away) == before


@pytest.mark.parametrize("has_second_names", [True, False])
def test_a_damaged_session_is_kept_under_a_name_that_nothing_has(
    saved_thrice: Path,
    elsewhere: Path,
    has_second_names: bool,
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    saved_thrice.write_bytes(damaged := b"\x89HDF\r\n\x1a\nno more")
    folder = companions(saved_thrice)
    as_dangling_link(folder / "damaged-1.h5", elsewhere)
    (folder / "damaged-2.h5").write_bytes(b"kept before")
    if not has_second_names:
        monkeypatch.setattr(os, "link", refused)
    session, kept = replace_damaged(saved_thrice, 1)
    session.close()
    assert kept == folder / "damaged-3.h5"
    assert kept.read_bytes() == damaged
    assert not (elsewhere / "made").exists()
    assert (folder / "damaged-2.h5").read_bytes() == b"kept before"


def test_a_damaged_session_that_cannot_be_replaced_is_left_as_it_was(
    saved_thrice: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    saved_thrice.write_bytes(b"\x89HDF\r\n\x1a\nno more")
    before = states(companions(saved_thrice)) | {"": saved_thrice.read_bytes()}

    def full(*_: object, **__: object) -> None:
        raise OSError(errno.ENOSPC, "No space left on device")

    monkeypatch.setattr(shutil, "copyfileobj", full)
    with pytest.raises(OutputError, match="no space is left on the disk"):
        replace_damaged(saved_thrice, 1)
    assert states(companions(saved_thrice)) | {"": saved_thrice.read_bytes()} == before


def refused(*_: object, **__: object) -> None:
    raise PermissionError(1, "Operation not permitted")


def test_on_a_disk_without_second_names_backups_are_copied_past_links(
    path: Path, elsewhere: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    companions(path).mkdir()
    as_link(companions(path) / "s.1.tmp", elsewhere)
    saved, before = path.read_bytes(), states(elsewhere)
    monkeypatch.setattr(os, "link", refused)
    session = Session.open(path)
    edit(session)
    session.save()
    session.close()
    assert find_backups(path)[0].read_bytes() == saved
    assert states(elsewhere) == before


def test_a_journal_is_kept_aside_under_a_name_that_nothing_has(path: Path) -> None:
    folder = companions(path)
    folder.mkdir()
    (folder / "kept-aside-2.sqlite").write_bytes(b"kept before")
    (folder / "journal.sqlite").write_bytes(b"no journal at all" * 400)
    Session.open(path).close()
    assert (folder / "kept-aside-2.sqlite").read_bytes() == b"kept before"
    assert (folder / "kept-aside-1.sqlite").read_bytes() == b"no journal at all" * 400


@pytest.mark.parametrize("mode", [0o600, 0o640, 0o664])
def test_what_stands_beside_a_session_is_the_user_s_alone(path: Path, mode: int) -> None:
    path.chmod(mode)
    companions(path).mkdir()
    companions(path).chmod(0o755)  # as older versions made it
    session = Session.open(path)
    edit(session)
    session.save()
    edit(session)
    folder = companions(path)
    assert stat.S_IMODE(folder.stat().st_mode) == 0o700
    modes = {file.name: stat.S_IMODE(file.stat().st_mode) for file in folder.iterdir()}
    assert {"lock", "journal.sqlite", "s.1.h5"} <= modes.keys()
    assert not {name for name, found in modes.items() if found & ~mode}
    session.close()


def test_a_new_session_may_be_read_by_whom_the_umask_lets(tmp_path: Path) -> None:
    before = os.umask(0o027)
    try:
        session = make_session(tmp_path)
        session.close()
    finally:
        os.umask(before)
    assert session.path is not None
    assert stat.S_IMODE(session.path.stat().st_mode) == 0o640


@only_root
def test_a_session_of_another_user_opens_for_reading_and_says_whose_it_is() -> None:
    with tempfile.TemporaryDirectory() as place:
        session = make_session(Path(place))
        edit(session)
        session.save()
        edit(session)  # waits in the journal, where nobody else may look
        session.close()
        path = session.path
        assert path is not None
        for folder in (Path(place), Path(place) / "recording"):
            folder.chmod(0o755)
        path.chmod(0o644)
        os.seteuid(NOBODY)
        try:
            told_to_another_user(path)
        finally:
            os.seteuid(0)
        Session.open(path).close()


def told_to_another_user(path: Path) -> None:
    other = Session.open(path)
    assert other.read_only
    assert "belongs to the user root, not to you" in other.notes[0]
    assert "not shown here" in other.notes[1]
    other.close()
    Session.look_into(path).close()
    with pytest.raises(UnsafeFileError, match="belongs to the user root"):
        list_backups(path)
    with pytest.raises(SessionError, match="belongs to the user root"):
        run_restore(path, 1, only_list=False, as_json=False)


@only_root
def test_root_edits_the_session_of_another_user_as_programs_in_containers_do(
    saved_thrice: Path,
) -> None:
    beside = companions(saved_thrice)
    for place in (saved_thrice.parent, saved_thrice, beside, *beside.iterdir()):
        os.chown(place, NOBODY, -1)
    session = Session.open(saved_thrice)
    assert not session.read_only
    edit(session)
    session.save()
    assert not any(kept.problem for kept in session.list_backups())
    session.close()


@pytest.mark.parametrize("trap", [as_pipe, as_folder, as_dangling_link])
def test_no_session_is_saved_in_place_of_what_is_no_file(
    tmp_path: Path, elsewhere: Path, trap: Trap
) -> None:
    if trap is as_dangling_link:  # the file a link leads to is the session, once it is there
        (tmp_path / "s.h5").symlink_to(elsewhere / "made")
        make_session(tmp_path).close()
        assert (tmp_path / "s.h5").is_symlink()
        return
    trap(tmp_path / "s.h5", elsewhere)
    kind = stat.S_IFMT((tmp_path / "s.h5").lstat().st_mode)
    with pytest.raises(OutputError, match=r"s\.h5: it is a (pipe|folder)"):
        make_session(tmp_path)
    assert stat.S_IFMT((tmp_path / "s.h5").lstat().st_mode) == kind


def test_a_pipe_in_place_of_the_session_is_told_at_once(tmp_path: Path) -> None:
    os.mkfifo(tmp_path / "s.h5")
    with pytest.raises(TrackwrightError):
        Session.open(tmp_path / "s.h5")


def test_files_that_belong_together_still_move_together(saved_thrice: Path) -> None:
    other = saved_thrice.parent / "other"
    other.mkdir()
    shutil.copy(saved_thrice, other)
    shutil.copytree(companions(saved_thrice), other / companions(saved_thrice).name)
    moved = Session.open(other / saved_thrice.name)
    assert not moved.read_only
    assert not any(kept.problem for kept in moved.list_backups())
    moved.close()

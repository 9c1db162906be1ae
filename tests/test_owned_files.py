"""Files beside a session are opened only where they are real files of the user's own."""

from __future__ import annotations

import os
import socket
import stat
import sys
from collections.abc import Callable, Iterator
from pathlib import Path

import pytest

from tracking.errors import SessionError, UnsafeFileError
from tracking.owned_files import (
    check_file,
    check_folder,
    make_folder,
    open_file,
    permissions_of,
    read_file,
)

pytestmark = pytest.mark.skipif(sys.platform == "win32", reason="links and pipes of POSIX")
only_root = pytest.mark.skipif(os.geteuid() != 0, reason="only root gives files to other users")
ANOTHER_USER = 54321


@pytest.fixture
def victim(tmp_path: Path) -> Path:
    file = tmp_path / "victim"
    file.write_bytes(b"precious")
    return file


def as_link(place: Path, victim: Path) -> None:
    place.symlink_to(victim)


def as_dangling_link(place: Path, victim: Path) -> None:
    place.symlink_to(victim.with_name("made-by-a-link"))


def as_second_name(place: Path, victim: Path) -> None:
    place.hardlink_to(victim)


def as_pipe(place: Path, _: Path) -> None:
    os.mkfifo(place)


def as_folder(place: Path, _: Path) -> None:
    place.mkdir()


def as_link_to_device(place: Path, _: Path) -> None:
    place.symlink_to("/dev/zero")


def as_socket(place: Path, _: Path) -> None:
    os.chdir(place.parent)  # the address of a socket is short
    with socket.socket(socket.AF_UNIX) as made:
        made.bind(place.name)


TRAPS = [
    as_link,
    as_dangling_link,
    as_second_name,
    as_pipe,
    as_folder,
    as_link_to_device,
    as_socket,
]


@pytest.fixture(autouse=True)
def same_folder() -> Iterator[None]:
    before = Path.cwd()
    yield
    os.chdir(before)


@pytest.mark.parametrize("flags", [os.O_RDONLY, os.O_RDWR, os.O_RDWR | os.O_CREAT])
@pytest.mark.parametrize("trap", TRAPS)
def test_only_regular_files_under_one_name_are_opened(
    trap: Callable[[Path, Path], None], flags: int, tmp_path: Path, victim: Path
) -> None:
    place = tmp_path / "lock"
    trap(place, victim)
    with pytest.raises(UnsafeFileError, match="lock ") as refused:
        open_file(place, flags)
    assert isinstance(refused.value, SessionError)
    assert "\n" not in str(refused.value)
    assert victim.read_bytes() == b"precious"
    assert not victim.with_name("made-by-a-link").exists()
    with pytest.raises(UnsafeFileError):
        check_file(place)


def test_a_link_that_comes_after_the_check_is_not_followed(
    tmp_path: Path, victim: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    place = tmp_path / "lock"
    opened = os.open

    def swapped(path: Path, flags: int, mode: int = 0o777) -> int:
        place.symlink_to(victim)
        return opened(path, flags, mode)

    monkeypatch.setattr(os, "open", swapped)
    with pytest.raises(OSError, match=r"symbolic links|lock"):
        open_file(place, os.O_RDWR | os.O_CREAT)


def test_a_file_is_made_with_the_permissions_that_are_named(tmp_path: Path) -> None:
    before = os.umask(0o077)
    try:
        os.close(open_file(tmp_path / "made", os.O_RDWR | os.O_CREAT, 0o640))
    finally:
        os.umask(before)
    assert stat.S_IMODE((tmp_path / "made").stat().st_mode) == 0o640


def test_a_file_is_opened_again_as_it_was_left(tmp_path: Path) -> None:
    (tmp_path / "kept").write_bytes(b"said")
    (tmp_path / "kept").chmod(0o604)
    handle = open_file(tmp_path / "kept", os.O_RDWR | os.O_CREAT, 0o600)
    assert os.read(handle, 9) == b"said"
    os.close(handle)
    assert stat.S_IMODE((tmp_path / "kept").stat().st_mode) == 0o604


def test_a_file_that_is_too_large_is_refused_before_it_is_read(tmp_path: Path) -> None:
    with (tmp_path / "large").open("wb") as file:
        file.truncate(1 << 40)  # a hole: no disk is filled
    with pytest.raises(UnsafeFileError, match="1099511627776 bytes; at most 1000 are read"):
        read_file(tmp_path / "large", 1000)
    (tmp_path / "right").write_bytes(b"x" * 1000)
    assert read_file(tmp_path / "right", 1000) == b"x" * 1000


def test_a_file_that_is_not_there_is_no_trap(tmp_path: Path) -> None:
    assert check_file(tmp_path / "nothing") is None
    with pytest.raises(FileNotFoundError):
        read_file(tmp_path / "nothing", 10)


@only_root
def test_a_file_of_another_user_is_refused(tmp_path: Path, victim: Path) -> None:
    os.chown(victim, ANOTHER_USER, -1)
    with pytest.raises(UnsafeFileError, match="belongs to the user with the number 54321"):
        open_file(victim)


@only_root
def test_root_works_in_the_folder_of_another_user_with_what_is_that_users(tmp_path: Path) -> None:
    home = tmp_path / "home"
    home.mkdir()
    make_folder(home / "beside")
    (home / "beside" / "lock").touch()
    for place in (home, home / "beside", home / "beside" / "lock"):
        os.chown(place, ANOTHER_USER, -1)
    check_folder(home / "beside")
    os.close(open_file(home / "beside" / "lock", os.O_RDWR))
    os.chown(home / "beside" / "lock", ANOTHER_USER + 1, -1)
    with pytest.raises(UnsafeFileError, match="54322"):
        open_file(home / "beside" / "lock", os.O_RDWR)


def test_where_a_disk_shows_all_files_as_one_person_s_they_are_the_user_s(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    make_folder(tmp_path / "own")
    (tmp_path / "own" / "lock").touch()
    monkeypatch.setattr(os, "geteuid", lambda: ANOTHER_USER)  # whose files get our number here
    check_folder(tmp_path / "own")
    handle = open_file(tmp_path / "own" / "lock", os.O_RDWR)
    assert os.fstat(handle).st_uid != ANOTHER_USER
    os.close(handle)


def test_a_folder_is_made_for_the_user_alone(tmp_path: Path) -> None:
    before = os.umask(0)
    try:
        make_folder(tmp_path / "own")
    finally:
        os.umask(before)
    assert stat.S_IMODE((tmp_path / "own").stat().st_mode) == 0o700


def test_a_folder_that_others_may_enter_is_closed_to_them(tmp_path: Path) -> None:
    (tmp_path / "own").mkdir()
    (tmp_path / "own").chmod(0o775)
    make_folder(tmp_path / "own")
    assert stat.S_IMODE((tmp_path / "own").stat().st_mode) == 0o700


@pytest.mark.parametrize("trap", [trap for trap in TRAPS if trap is not as_folder])
def test_a_folder_that_is_a_link_or_a_file_is_refused(
    trap: Callable[[Path, Path], None], tmp_path: Path, victim: Path
) -> None:
    trap(tmp_path / "own", victim)
    with pytest.raises(UnsafeFileError, match="own is "):
        make_folder(tmp_path / "own")


def test_a_link_to_a_folder_is_refused_and_that_folder_is_left_as_it_is(tmp_path: Path) -> None:
    (tmp_path / "elsewhere").mkdir(0o755)
    (tmp_path / "elsewhere").chmod(0o755)
    (tmp_path / "own").symlink_to(tmp_path / "elsewhere")
    with pytest.raises(UnsafeFileError, match="own is a link, which is not followed; remove it"):
        make_folder(tmp_path / "own")
    assert stat.S_IMODE((tmp_path / "elsewhere").stat().st_mode) == 0o755


@only_root
def test_a_folder_of_another_user_is_refused(tmp_path: Path) -> None:
    (tmp_path / "own").mkdir()
    os.chown(tmp_path / "own", ANOTHER_USER, -1)
    with pytest.raises(UnsafeFileError, match=r"belongs to .* not to you; save the session under"):
        check_folder(tmp_path / "own")


def test_what_stands_beside_a_file_gets_its_permissions(tmp_path: Path, victim: Path) -> None:
    victim.chmod(0o640)
    assert permissions_of(victim) == 0o640
    victim.chmod(0o444)
    assert permissions_of(victim) == 0o644
    assert permissions_of(tmp_path / "nothing") == 0o600


def test_a_file_that_is_only_read_may_have_further_names(tmp_path: Path, victim: Path) -> None:
    place = tmp_path / "second"
    place.hardlink_to(victim)
    assert check_file(place, is_written=False) is not None
    with pytest.raises(UnsafeFileError, match="2 names"):
        check_file(place)
    link = tmp_path / "link"
    link.symlink_to(victim)
    with pytest.raises(UnsafeFileError, match="is a link"):
        check_file(link, is_written=False)


def test_a_folder_that_another_program_takes_away_at_that_moment_is_made(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    place, mkdir = tmp_path / "folder", Path.mkdir
    there = [True, True]

    def mkdir_of_what_goes(folder: Path, *options: int) -> None:
        if there:  # it was there, and is gone before anybody looks
            there.pop()
            raise FileExistsError(17, "File exists", str(folder))
        mkdir(folder, *options)

    monkeypatch.setattr(Path, "mkdir", mkdir_of_what_goes)
    make_folder(place)
    check_folder(place)
    assert there == []
    assert place.is_dir()

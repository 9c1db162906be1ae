"""Sessions the user's own program saved are known by their seal."""

from __future__ import annotations

import os
import shutil
import stat
from pathlib import Path

import h5py
import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from made_up_sessions import edit, make_session

from tracking.editing import plan_rename
from tracking.errors import SessionError
from tracking.session import Session, layout, seal, session_reader
from tracking.session.inspection import inspect


@pytest.fixture(scope="module")
def saved(tmp_path_factory: pytest.TempPathFactory) -> Path:
    session = make_session(tmp_path_factory.mktemp("sealed"))
    session.close()
    return session.path


@pytest.fixture
def copy(saved: Path, tmp_path: Path) -> Path:
    return Path(shutil.copy(saved, tmp_path / "copy.h5"))


def pieces_of(path: Path) -> list[tuple[int, int]]:
    """Where the packed pieces of the columns lie."""
    found = []

    def note(_: str, node: object) -> None:
        if isinstance(node, h5py.Dataset) and node.chunks:
            for at in range(node.id.get_num_chunks()):
                piece = node.id.get_chunk_info(at)
                found.append((piece.byte_offset, piece.byte_offset + piece.size))

    with h5py.File(path) as file:
        file.visititems(note)
    return sorted(found)


def test_a_saved_session_bears_a_seal_that_holds_wherever_it_is_moved(copy):
    assert seal.holds(copy)


def test_a_sealed_session_passes_the_inspection_it_is_spared(copy):
    assert inspect(copy) == session_reader.VERSION


@settings(max_examples=60, deadline=None)
@given(st.data())
def test_a_seal_does_not_hold_where_any_byte_beside_the_pieces_is_another(saved, data):
    content = bytearray(saved.read_bytes())
    stretches = list(seal.beside(pieces_of(saved), len(content)))
    start, stop = data.draw(st.sampled_from(stretches))
    at = data.draw(st.integers(start, stop - 1))
    content[at] ^= data.draw(st.integers(1, 255))
    other = saved.with_name("other.h5")
    other.write_bytes(content)
    assert not seal.holds(other)


@pytest.mark.parametrize("kept", [0, 7, 100, -1, -80, -500])
def test_a_file_cut_short_bears_no_seal(copy, kept):
    size = copy.stat().st_size
    os.truncate(copy, kept if kept >= 0 else size + kept)
    assert not seal.holds(copy)


def test_a_session_that_another_program_wrote_into_is_looked_over_again(copy, monkeypatch):
    with h5py.File(copy, "a") as file:
        file["elsewhere"] = h5py.ExternalLink("/etc/passwd", "x")
    monkeypatch.setattr(session_reader, "is_sealed", seal.holds)
    with pytest.raises(SessionError, match="link to somewhere else"):
        Session.open(copy)


def test_a_sealed_session_opens_without_another_program(copy, monkeypatch):
    monkeypatch.setattr(session_reader, "is_sealed", seal.holds)
    monkeypatch.setattr(session_reader, "inspect_files", lambda _: pytest.fail("asked"))
    session = Session.open(copy)
    assert len(session.tracks)
    session.close()


def test_another_users_seal_counts_for_nothing(copy, tmp_path, monkeypatch):
    monkeypatch.setattr(seal, "user_data_path", lambda *_, **__: tmp_path / "other")
    assert not seal.holds(copy)
    seal.seal(0, [], [])  # makes that user's key
    assert not seal.holds(copy)


@pytest.mark.skipif(os.name == "nt", reason="rights of files are another matter there")
def test_a_key_that_others_may_read_is_none(copy, tmp_path, monkeypatch):
    monkeypatch.setattr(seal, "user_data_path", lambda *_, **__: tmp_path / "shared")
    assert seal.seal(0, [], [])
    (tmp_path / "shared" / "seal.key").chmod(0o644)
    session = make_session(tmp_path / "folder")
    session.close()
    assert not seal.holds(session.path)
    assert not seal.is_changed(session.path)


@pytest.mark.skipif(os.name == "nt", reason="owners of files are another matter there")
def test_a_key_of_another_user_is_none(copy, tmp_path, monkeypatch):
    assert seal.holds(copy)
    monkeypatch.setattr(os, "geteuid", lambda: os.getuid() + 1)
    assert not seal.holds(copy)


@pytest.mark.parametrize("left", [b"", b"short", bytes(32), b"x" * 33, None])
def test_what_a_power_cut_left_of_a_key_is_no_key_and_a_new_one_is_made(
    left, tmp_path, monkeypatch
):
    monkeypatch.setattr(seal, "user_data_path", lambda *_, **__: tmp_path)
    file = tmp_path / "seal.key"
    os.mkfifo(file) if left is None else file.write_bytes(left)
    if left is not None:
        file.chmod(0o600)
    session = make_session(tmp_path / "folder")
    session.close()
    assert seal.holds(session.path)
    assert len(file.read_bytes()) == seal.KEY_BYTES
    assert any(file.read_bytes())
    assert sorted(tmp_path.glob("*.tmp")) == []


def test_nobody_makes_seals_with_a_key_of_zeros(tmp_path, monkeypatch):
    monkeypatch.setattr(seal, "user_data_path", lambda *_, **__: tmp_path)
    (tmp_path / "seal.key").write_bytes(bytes(32))
    (tmp_path / "seal.key").chmod(0o600)
    monkeypatch.setattr(seal, "_is_key", lambda key: len(key) == seal.KEY_BYTES)
    forged = tmp_path / "forged.h5"
    forged.write_bytes(seal.seal(0, [], []))
    assert seal.holds(forged)
    monkeypatch.undo()
    monkeypatch.setattr(seal, "user_data_path", lambda *_, **__: tmp_path)
    assert not seal.holds(forged)


@pytest.mark.skipif(os.name == "nt", reason="no folder is synced there")
def test_a_key_is_on_the_disk_for_good_before_it_is_used(tmp_path, monkeypatch):
    monkeypatch.setattr(seal, "user_data_path", lambda *_, **__: tmp_path)
    synced, sync = [], os.fsync

    def noted(handle):
        synced.append((stat.S_ISDIR(os.fstat(handle).st_mode), (tmp_path / "seal.key").exists()))
        sync(handle)

    monkeypatch.setattr(os, "fsync", noted)
    assert seal.seal(0, [], [])
    assert synced == [(False, False), (True, True)]


def test_where_no_key_can_be_kept_sessions_are_saved_without_a_seal(tmp_path, monkeypatch):
    (tmp_path / "file").write_text("")
    monkeypatch.setattr(seal, "user_data_path", lambda *_, **__: tmp_path / "file")
    session = make_session(tmp_path)
    session.close()
    assert not seal.holds(session.path)
    assert inspect(session.path) == session_reader.VERSION


def test_a_seal_by_other_rules_counts_for_nothing(copy, monkeypatch):
    monkeypatch.setattr(seal, "_rules", lambda: b"older")
    assert not seal.holds(copy)


@pytest.mark.parametrize("name", ["TABLES", "RUN_TABLES"])
def test_a_seal_made_for_other_columns_counts_for_nothing(copy, name, monkeypatch):
    tables = getattr(layout, name)
    columns = {**tables["tracks"].columns, "further": np.dtype(np.int32)}
    other = {**tables, "tracks": layout.Table(columns)}
    monkeypatch.setattr(layout, name, other)
    monkeypatch.setattr(seal, "_rules", seal._rules.__wrapped__)
    assert not seal.holds(copy)


def flipped(path: Path, word: bytes) -> Path:
    """The file with one bit of a word in it flipped."""
    data = bytearray(path.read_bytes())
    data[data.rindex(word) + 1] ^= 1
    path.write_bytes(data)
    return path


@pytest.mark.parametrize("key", ["own", "another", "none"])
@pytest.mark.parametrize("word", [b"Swap 1 and 2", b"red coat", b"Lobby, camera", b"stretches"])
def test_a_flipped_bit_in_plain_text_is_told(word, key, tmp_path, monkeypatch):
    monkeypatch.setattr(session_reader, "is_sealed", seal.holds)
    if key == "none":
        monkeypatch.setattr(seal, "_key", lambda **_: None)
    session = make_session(tmp_path)
    edit(session)
    session.apply(plan_rename(session.tracks, session.labels, 1, "red coat"))
    path = session.save()
    session.close()
    if key == "another":
        monkeypatch.setattr(seal, "user_data_path", lambda *_, **__: tmp_path / "other")
    for opening in (Session.open, Session.look_into):
        whole = opening(path)
        assert whole.notes == ()
        whole.close()
    flipped(path, word)
    for opening in (Session.open, Session.look_into):
        damaged = opening(path)
        assert ["checksum does not hold" in note for note in damaged.notes] == [True]
        damaged.close()


def test_a_damaged_session_that_is_saved_again_is_whole_and_was_found_damaged(copy, monkeypatch):
    damaged = Session.open(flipped(copy, b"Lobby, camera"))
    damaged.save()
    damaged.close()
    again = Session.open(copy)
    assert ["was found damaged" in note for note in again.notes] == [True]
    again.close()


def test_a_session_that_another_program_wrote_into_is_told_to_lack_its_checksum(copy):
    with h5py.File(copy, "a") as file:
        file.attrs["remark"] = "mine"
    session = Session.open(copy)
    assert ["another program wrote into it" in note for note in session.notes] == [True]
    session.close()


def test_a_session_whose_end_was_overwritten_is_told_to_lack_its_checksum(copy):
    whole = copy.read_bytes()
    copy.write_bytes(whole[:-100] + bytes(range(100)))
    session = Session.open(copy)
    assert ["damaged at its end" in note for note in session.notes] == [True]
    session.close()


def test_a_session_of_an_older_format_needs_no_checksum(copy):
    with h5py.File(copy, "a") as file:
        file.attrs["format_version"] = "1.4"
    session = Session.open(copy)
    assert session.notes == ()
    session.close()


@pytest.mark.parametrize("table", [[(8, 4)], [(0, 1 << 62)], [(0, 8), (0, 8)] * 1000])
def test_a_seal_of_stretches_that_can_be_none_takes_no_time(copy, table):
    whole = copy.read_bytes()
    stretches = b"".join(edge.to_bytes(8, "little") for pair in table for edge in pair)
    count = len(table).to_bytes(8, "little")
    copy.write_bytes(whole + stretches + bytes(64) + count + b"twseal01")
    assert not seal.is_changed(copy)


def test_a_file_of_more_than_any_structure_is_not_read_for_its_checksum(copy):
    with copy.open("r+b") as file:
        file.truncate(1 << 40)  # without a byte on the disk
        file.seek(0, os.SEEK_END)
        file.write(bytes(64 + 8) + b"twseal01")
    assert not seal.is_changed(copy)

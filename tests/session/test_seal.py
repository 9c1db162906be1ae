"""Sessions the user's own program saved are known by their seal."""

from __future__ import annotations

import os
import shutil
from pathlib import Path

import h5py
import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from made_up_sessions import make_session

from tracking.errors import SessionError
from tracking.session import Session, layout, reading, seal
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
    assert inspect(copy) == reading.VERSION


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
    monkeypatch.setattr(reading, "is_sealed", seal.holds)
    with pytest.raises(SessionError, match="link to somewhere else"):
        Session.open(copy)


def test_a_sealed_session_opens_without_another_program(copy, monkeypatch):
    monkeypatch.setattr(reading, "is_sealed", seal.holds)
    monkeypatch.setattr(reading, "verdicts_on", lambda _: pytest.fail("asked"))
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
    assert seal.seal(0, [], []) == b""


def test_where_no_key_can_be_kept_sessions_are_saved_without_a_seal(tmp_path, monkeypatch):
    (tmp_path / "file").write_text("")
    monkeypatch.setattr(seal, "user_data_path", lambda *_, **__: tmp_path / "file")
    session = make_session(tmp_path)
    session.close()
    assert not seal.holds(session.path)
    assert inspect(session.path) == reading.VERSION


def test_a_seal_by_other_rules_counts_for_nothing(copy, monkeypatch):
    monkeypatch.setattr(seal, "_rules", lambda: b"older")
    assert not seal.holds(copy)


@pytest.mark.parametrize("name", ["TABLES", "RUN_TABLES"])
def test_a_seal_made_for_other_columns_counts_for_nothing(copy, name, monkeypatch):
    tables = getattr(layout, name)
    other = {**tables, "tracks": {**tables["tracks"], "further": np.dtype(np.int32)}}
    monkeypatch.setattr(layout, name, other)
    monkeypatch.setattr(seal, "_rules", seal._rules.__wrapped__)
    assert not seal.holds(copy)

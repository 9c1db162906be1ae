"""That a session was found damaged stays known after it is saved, until somebody accepts it."""

from __future__ import annotations

import json
from contextlib import closing
from pathlib import Path

import h5py
import pytest
from made_up_sessions import crashed, edit, state_of

from tracking.editing import plan_rename, plan_swap
from tracking.errors import OutputError
from tracking.session import Session, describe, find_backups, replace_damaged, session_writer
from tracking.session.session_writer import companions


def flip(file: Path, text: bytes = b"red coat") -> None:
    """One flipped bit in a text of a session file."""
    data = bytearray(file.read_bytes())
    data[data.rindex(text)] ^= 1
    file.write_bytes(data)


@pytest.fixture
def sound(session: Session) -> Path:
    """A session in which a track has a name, with a backup."""
    session.apply(plan_rename(session.tracks, session.labels, 1, "red coat"))
    session.save()
    session.close()
    assert session.path is not None
    return session.path


@pytest.fixture
def damaged(sound: Path) -> Path:
    """The same with a flipped bit in that name."""
    flip(sound)
    return sound


def saved(path: Path, times: int = 1) -> Path:
    for _ in range(times):
        with closing(Session.open(path)) as session:
            edit(session)
            session.save()
    return path


def told(path: Path) -> tuple[str, ...]:
    """What every reading of the session says of damage: all of them the same."""
    with closing(Session.open(path)) as session, closing(Session.look_into(path)) as looked:
        assert session.damage == looked.damage == tuple(describe(path)["damage"])
        assert set(session.damage) <= set(session.notes)
        return session.damage


def test_a_save_of_a_damaged_session_does_not_wipe_the_sign(damaged: Path) -> None:
    (note,) = told(saved(damaged))
    assert f"{damaged} was found damaged on 20" in note
    assert "its checksum did not hold" in note
    assert "\n" not in note
    assert told(saved(damaged, times=7)) == (note,)


def test_the_original_stays_as_it_was_found_however_often_it_is_saved(damaged: Path) -> None:
    original = damaged.read_bytes()
    (note,) = told(saved(damaged, times=7))
    kept = companions(damaged) / "damaged-1.h5"
    assert kept.name in note
    assert kept.read_bytes() == original
    assert len(list(companions(damaged).glob("damaged-*"))) == 1
    with pytest.raises(AssertionError):  # five backups alone would have dropped it
        assert original in [file.read_bytes() for file in find_backups(damaged)]


def test_on_a_disk_without_second_names_the_original_is_copied(
    damaged: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    def refuse(*_: object) -> None:
        raise OSError(1, "Operation not permitted")

    monkeypatch.setattr(session_writer.os, "link", refuse)
    original = damaged.read_bytes()
    saved(damaged)
    assert (companions(damaged) / "damaged-1.h5").read_bytes() == original


def test_where_the_original_cannot_be_kept_nothing_is_saved_over_it(
    damaged: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    def refuse(*_: object) -> None:
        raise OSError(28, "No space left on device")

    original = damaged.read_bytes()
    with closing(Session.open(damaged)) as session:
        edit(session)
        with monkeypatch.context() as full:
            full.setattr(session_writer.os, "link", refuse)
            full.setattr(session_writer, "copy_file", refuse)
            with pytest.raises(OutputError, match="cannot be kept"):
                session.save()
        assert damaged.read_bytes() == original
        session.save()
    assert len(told(damaged)) == 1


def test_a_save_under_another_name_takes_the_finding_along_and_leaves_the_original(
    damaged: Path, tmp_path: Path
) -> None:
    original = damaged.read_bytes()
    with closing(Session.open(damaged)) as session:
        other = session.save(tmp_path / "other.h5")
        edit(session)
        session.save()
    (note,) = told(other)
    assert f"{other} was found damaged" in note
    assert damaged.read_bytes() == original
    assert not list(companions(other).glob("damaged-*"))


def test_who_accepts_the_damage_is_told_no_more_and_the_fact_stays(damaged: Path) -> None:
    saved(damaged)
    with closing(Session.open(damaged)) as session:
        assert session.accept_damage() == 1
        assert session.accept_damage() == 0
        assert session.dirty
        session.save()
    assert told(saved(damaged)) == ()
    with h5py.File(damaged) as file:
        (finding,) = json.loads(file.attrs["damage"])
    assert finding["accepted"] > finding["found"]
    assert finding["kept"] == "damaged-1.h5"


def test_a_restored_backup_is_sound_again(damaged: Path) -> None:
    saved(damaged)
    with closing(Session.open(damaged)) as session, closing(session.restore(2)) as restored:
        assert restored.damage == ()
    assert told(saved(damaged)) == ()


def test_a_restored_backup_that_is_damaged_stays_known_to_be(sound: Path) -> None:
    with closing(Session.open(sound)) as session:
        session.apply(plan_swap(session.tracks, 1, 2, 10))
        session.save()
    backup = find_backups(sound)[0]
    flip(backup)
    found = backup.read_bytes()
    with closing(Session.open(sound)) as session:
        session.restore(1).close()
    (note,) = told(saved(sound, times=7))
    assert "damaged-1.h5" in note
    assert (companions(sound) / "damaged-1.h5").read_bytes() == found


def test_a_damaged_backup_in_the_place_of_a_session_that_cannot_be_read_is_told(
    sound: Path,
) -> None:
    saved(sound)
    flip(find_backups(sound)[0])
    sound.write_bytes(b"nothing")
    session, _ = replace_damaged(sound, 1)
    session.close()
    assert len(told(saved(sound))) == 1


def test_edits_that_a_journal_lost_stay_known_after_a_save(
    session: Session, tmp_path: Path
) -> None:
    for frame in range(10, 13):
        session.apply(plan_swap(session.tracks, 1, 2, frame))
    path = crashed(session, tmp_path / "after")
    log = companions(path) / "journal.sqlite-wal"
    log.write_bytes(log.read_bytes()[: 32 + 24])
    with closing(Session.open(path)) as opened:
        (first,) = opened.damage
        edit(opened)
        opened.save()
    (note,) = told(path)
    assert "0 of 3 steps are left" in first
    assert "0 of 3 steps are left" in note
    assert "kept aside as kept-aside-1.sqlite" in note  # the session travels: no folders in it


def test_a_record_of_damage_that_is_damaged_itself_is_told_and_keeps_nobody_out(
    damaged: Path,
) -> None:
    saved(damaged)
    for said in ("no JSON", "[1]", '{"found": 1}', '[{"found": "x"}]', "[" * 10_000):
        with h5py.File(damaged, "a") as file:
            file.attrs["damage"] = said
        notes = told(damaged)
        assert [note for note in notes if "found before cannot be read" in note]


def test_what_a_record_says_is_one_short_line(damaged: Path) -> None:
    saved(damaged)
    said = {"found": "2026-01-02T03:04:05", "what": "a\x1b\nb" * 100, "kept": "", "accepted": ""}
    with h5py.File(damaged, "a") as file:
        file.attrs["damage"] = json.dumps([said] * 50)
    notes = told(damaged)
    assert len(notes) == 20 + 1  # and that its checksum is gone
    assert all(note.isprintable() and len(note) < 1000 for note in notes)


def test_a_sound_session_says_nothing_of_damage(sound: Path) -> None:
    before = state_of(Session.look_into(sound))
    assert told(sound) == ()
    with closing(Session.open(sound)) as session:
        assert session.accept_damage() == 0
        assert not session.dirty
    with h5py.File(sound) as file:
        assert "damage" not in file.attrs
    assert state_of(Session.look_into(sound)) == before

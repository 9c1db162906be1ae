"""What is told of a session counts the edits that only its journal holds."""

from __future__ import annotations

import errno
from pathlib import Path

import pytest

from tracking.editing import plan_delete, plan_swap
from tracking.errors import OutputError, SessionError
from tracking.session import Session, describe, pending_edits
from tracking.session.pending_edits import edits_wait
from tracking.session.session_writer import companions


def edit(session: Session, *, swaps: int = 1) -> None:
    for frame in range(10, 10 + swaps):
        session.apply(plan_swap(session.tracks, 1, 2, frame))


def test_edits_that_wait_in_the_journal_count_in_what_is_told(session: Session) -> None:
    edit(session)
    path = session.save()
    edit(session, swaps=3)
    session.undo()
    session.apply(plan_delete(session.tracks, 2))
    told = describe(path)
    assert (told["edits"], told["undone_edits"], told["edits_waiting_in_journal"]) == (4, 1, 5)
    assert (told["tracks"], told["rows"]) == (len(session.tracks.track_ids), len(session.tracks))
    session.close()
    assert describe(path) == told
    kept = {file.name for file in companions(path).iterdir()}
    describe(path)
    assert {file.name for file in companions(path).iterdir()} == kept


def test_a_damaged_journal_counts_for_nothing_in_what_is_told(session: Session) -> None:
    path = session.save()
    session.close()
    companions(path).mkdir(exist_ok=True)
    (companions(path) / "journal.sqlite").write_bytes(b"no journal at all" * 400)
    told = describe(path)
    assert (told["edits"], told["edits_waiting_in_journal"]) == (0, 0)


def test_a_session_that_is_looked_into_has_the_waiting_edits_and_stays_free(
    session: Session,
) -> None:
    path = session.save()
    edit(session, swaps=3)
    kept = {file.name for file in companions(path).iterdir()}
    looked = Session.look_into(path)
    assert len(looked.history) == len(session.history) == 3
    assert looked.read_only
    with pytest.raises(SessionError, match="reading only"):
        edit(looked)
    assert {file.name for file in companions(path).iterdir()} == kept
    edit(session)
    session.close()
    other = Session.open(path)
    assert not other.read_only
    looked.close()
    edit(other)
    other.close()


def test_looking_into_a_session_changes_nothing_beside_it(
    session: Session,
) -> None:
    path = session.save()
    session.close()
    kept = sorted(companions(path).iterdir())
    Session.look_into(path).close()
    assert sorted(companions(path).iterdir()) == kept


def test_edits_that_cannot_be_copied_anywhere_wait_all_the_same(
    session: Session, monkeypatch: pytest.MonkeyPatch
) -> None:
    def nowhere(*_: object) -> None:
        raise FileNotFoundError(errno.ENOENT, "No usable temporary directory found")

    path = session.save()
    edit(session)
    monkeypatch.setattr("tracking.session.pending_edits.tempfile.TemporaryDirectory", nowhere)
    assert edits_wait(path)
    with pytest.raises(OutputError, match=r"cannot be read .No usable temporary directory"):
        describe(path)


def test_a_journal_that_goes_while_it_is_read_is_no_failing_disk(
    session: Session, monkeypatch: pytest.MonkeyPatch
) -> None:
    path = session.save()
    edit(session)
    copied = pending_edits.files_to_copy

    def saved_meanwhile(main: Path) -> list[str]:
        monkeypatch.setattr(pending_edits, "files_to_copy", copied)
        session.save()
        raise FileNotFoundError(errno.ENOENT, "it was there a moment ago")

    monkeypatch.setattr(pending_edits, "files_to_copy", saved_meanwhile)
    assert len(Session.look_into(path).history) == 1

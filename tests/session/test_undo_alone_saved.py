"""An old edit undone alone is kept as any other edit is."""

from __future__ import annotations

import shutil
import time
from pathlib import Path

import pytest
from made_up_sessions import make_session, state_of

from tracking.editing import plan_label_part, plan_rename, plan_swap
from tracking.errors import EditError
from tracking.session import Session
from tracking.session.session_writer import companions
from tracking.tracks import PartLabel


@pytest.fixture
def edited(session: Session) -> Session:
    session.apply(plan_swap(session.tracks, 1, 2, 10))
    session.apply(plan_rename(session.tracks, session.labels, 3, "red coat"))
    session.save()
    return session


def crashed(session: Session, folder: Path) -> Session:
    """What a crash at this moment leaves on the disk, opened."""
    assert session.path is not None
    folder.mkdir()
    shutil.copy(session.path, folder)
    shutil.copytree(companions(session.path), folder / companions(session.path).name)
    return Session.open(folder / session.path.name)


def test_it_survives_a_crash(edited: Session, tmp_path: Path) -> None:
    entry = edited.undo_alone(1)
    assert (entry.kind, entry.undoes, entry.author) == ("undo", 1, "ada")
    again = crashed(edited, tmp_path / "after")
    assert state_of(again) == state_of(edited)
    assert again.history.taken_back_by(1) == 3
    assert again.history.why_not_alone(1) == "edit 1 is undone already, by edit 3"
    again.close()


def test_it_is_undone_and_redone_after_reopening(edited: Session) -> None:
    before = state_of(edited)[:2]
    edited.undo_alone(1)
    after = state_of(edited)[:2]
    path = edited.save()
    edited.close()
    again = Session.open(path)
    again.undo()
    assert state_of(again)[:2] == before
    assert again.history.taken_back_by(1) == 0
    again.redo()
    assert state_of(again)[:2] == after
    assert again.history.taken_back_by(1) == 3
    again.close()


def test_what_stands_on_it_is_known_after_reopening(edited: Session) -> None:
    edited.apply(plan_swap(edited.tracks, 2, 4, 20))
    path = edited.save()
    edited.close()
    again = Session.open(path)
    with pytest.raises(
        EditError, match=r'"Swap 2 and 4 from frame 20 on" \(edit 3\) was made on top'
    ):
        again.undo_alone(1)
    again.undo_alone(3)
    again.undo_alone(1)
    again.close()


def test_part_labels_go_along_with_a_swap_and_back(session: Session) -> None:
    for track, width in ((1, 10.0), (2, 20.0)):
        label = PartLabel(15, track, 0, (0.0, 0.0, width, 5.0))
        session.apply(plan_label_part(session.labels, label))
    labels = session.labels
    session.apply(plan_swap(session.tracks, 1, 2, 10))
    assert [label.box[2] for label in session.labels.parts.of_frame(15)] == [20.0, 10.0]
    session.apply(plan_swap(session.tracks, 1, 2, 16))
    assert [label.box[2] for label in session.labels.parts.of_frame(15)] == [20.0, 10.0]
    session.undo()
    session.undo()
    assert session.labels == labels


def test_among_a_hundred_thousand_part_labels_one_more_costs_what_the_first_did(
    tmp_path: Path,
) -> None:
    session = make_session(tmp_path)
    many = [
        PartLabel(frame, track, part, (1.0, 2.0, 3.0, 4.0))
        for frame in range(2_100)
        for track in range(1, 17)
        for part in range(3)
    ]
    took = [label_some(session, number) for number in range(20)]
    session.apply(plan_label_part(session.labels, many))
    took_later = [label_some(session, 100 + number) for number in range(20)]
    assert len(session.labels.parts) > 100_000
    assert min(took_later) < 3 * min(took) + 0.002
    session.close()


def label_some(session: Session, number: int) -> float:
    """Seconds of processor time that one label takes, journal and all."""
    label = PartLabel(5_000 + number, 1, 0, (1.0, 2.0, 3.0, 4.0), None)
    started = time.thread_time()  # not the clock: others use the machine, too
    session.apply(plan_label_part(session.labels, label))
    return time.thread_time() - started

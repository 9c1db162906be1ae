"""Sessions that somebody corrects, or has open, while their recordings are tracked: they stay."""

from __future__ import annotations

import shutil
from collections.abc import Callable
from contextlib import ExitStack, closing
from dataclasses import replace
from pathlib import Path

import pytest

from tests.batch.batches import QUICK, Counting, batch, do_here, ledger_of, leftovers
from tests.batch.walks import make_walk
from tracking.batch import Cause, Outcome, State
from tracking.batch.outcome import failure
from tracking.batch.task import Finished, Task, Workplace
from tracking.editing import plan_delete
from tracking.session import Session
from tracking.translation import msg

OTHER = replace(QUICK, seed=7)


@pytest.fixture
def walk(tmp_path: Path) -> Path:
    """A recording with a finished batch of it in `out` beside it."""
    walk = make_walk(tmp_path / "walk")
    assert batch(tmp_path / "out", [walk])["walk"].is_done
    return walk


def correct_and_save(path: Path, _: ExitStack) -> None:
    with closing(Session.open(path)) as session:
        _delete(session)
        session.save()


def correct_and_leave_in_the_journal(path: Path, _: ExitStack) -> None:
    with closing(Session.open(path)) as session:
        _delete(session)


def keep_open(path: Path, open_until_later: ExitStack) -> None:
    open_until_later.enter_context(closing(Session.open(path)))


def _delete(session: Session) -> None:
    session.apply(plan_delete(session.tracks, session.tracks.track_ids[0], 3, 5))


def after(change: Callable[[Path, ExitStack], None], stack: ExitStack) -> Callable[[Task], Outcome]:
    """A worker's work, and then somebody does something to the session that is there."""

    def do(task: Task) -> Outcome:
        outcome = do_here(task)
        change(task.session, stack)
        return outcome

    return do


CHANGES = [correct_and_save, correct_and_leave_in_the_journal, keep_open]


@pytest.mark.parametrize("change", CHANGES)
def test_a_session_that_is_changed_while_it_is_tracked_stays(walk: Path, change) -> None:
    out = walk.parent / "out"
    before = (out / "walk.h5").read_bytes()
    with ExitStack() as stack:
        outcome = batch(out, [walk], OTHER, after(change, stack))["walk"]
        assert (outcome.state, outcome.cause) == (State.SKIPPED, Cause.PROTECTED)
        assert "walk.h5" in outcome.why
        if change is not correct_and_save:
            assert (out / "walk.h5").read_bytes() == before
    with closing(Session.look_into(out / "walk.h5")) as session:
        assert len(session.history) == (change is not keep_open)
    assert [name for name in leftovers(out) if name.startswith(".batch")] == []
    outcome = batch(out, [walk], OTHER)["walk"]
    assert outcome.is_done == (change is keep_open)


def test_a_session_that_appears_while_its_recording_is_tracked_stays(tmp_path: Path) -> None:
    walk = make_walk(tmp_path / "walk")

    def appear(path: Path, _: ExitStack) -> None:
        path.write_bytes(b"somebody's")

    outcome = batch(tmp_path / "out", [walk], do=after(appear, ExitStack()))["walk"]
    assert outcome.cause is Cause.PROTECTED
    assert (tmp_path / "out" / "walk.h5").read_bytes() == b"somebody's"


def test_a_session_that_is_open_is_not_tracked(walk: Path) -> None:
    with ExitStack() as stack:
        keep_open(walk.parent / "out" / "walk.h5", stack)
        outcome = batch(walk.parent / "out", [walk], OTHER)["walk"]
    assert outcome.cause is Cause.PROTECTED
    assert not outcome.tracked
    assert "is open" in outcome.why


def test_force_replaces_what_was_corrected_meanwhile(walk: Path) -> None:
    order = replace(OTHER, force=True)
    do = after(correct_and_save, ExitStack())
    assert batch(walk.parent / "out", [walk], order, do)["walk"].is_done


def test_a_correction_while_scores_are_made_is_seen_by_the_next_run(walk: Path) -> None:
    out = walk.parent / "out"
    (walk / "notes.txt").write_text("of no account")
    do = after(correct_and_save, ExitStack())
    assert not batch(out, [walk], do=do)["walk"].corrected
    assert batch(out, [walk])["walk"].corrected


def test_what_is_skipped_stays_skipped(walk: Path) -> None:
    correct_and_save(walk.parent / "out" / "walk.h5", ExitStack())
    shutil.copy(walk / "left" / "0000.png", walk / "left" / "0005.png")
    for _ in range(3):
        outcome = batch(walk.parent / "out", [walk])["walk"]
        assert outcome.state is State.SKIPPED


@pytest.mark.parametrize("is_corrected", [False, True])
def test_a_failure_takes_nothing_from_what_is_known(walk: Path, is_corrected: bool) -> None:
    out = walk.parent / "out"
    if is_corrected:
        correct_and_save(out / "walk.h5", ExitStack())
        assert batch(out, [walk])["walk"].corrected
    (walk / "notes.txt").write_text("of no account")
    bad = Counting(lambda _: failure(Cause.WORKER, msg("it died")))
    outcome = batch(out, [walk], do=bad)["walk"]
    assert (outcome.state, outcome.cause) == (State.FAILED, Cause.WORKER)
    again = Counting()
    outcome = batch(out, [walk], do=again)["walk"]
    assert outcome.is_done
    assert outcome.corrected == is_corrected
    assert (again.names, again.tracked) == (["walk"], [])


def test_a_failure_that_nobody_saw_takes_nothing_either(walk: Path) -> None:
    out = walk.parent / "out"
    row = ledger_of(out)[0]["walk"]
    place = Workplace(out, "00ff")
    place.folder.mkdir()
    unseen = Finished("walk", walk, row.asked, failure(Cause.INPUT, msg("it was away")))
    place.outcome.write_bytes(unseen.as_bytes())
    again = Counting()
    assert batch(out, [walk], do=again)["walk"].is_done
    assert again.tracked == []

"""A batch whose program is killed at any moment: what was finished is kept, nothing else is."""

from __future__ import annotations

import shutil
from collections.abc import Callable
from pathlib import Path

import pytest

from tests.batch.batches import QUICK, Counting, batch, do_here, entries_of, ledger_of, leftovers
from tests.batch.walks import make_walk
from tracking.batch import BatchRun, Limits, Listener, Outcome, batch_folder
from tracking.batch.plan import Planner
from tracking.batch.publication import publish
from tracking.batch.task import Finished, Task, Workplace


class Interrupting(Listener):
    """Ctrl-C after the first recording."""

    def ended(self, *_: object) -> None:
        raise KeyboardInterrupt


@pytest.fixture
def walk(tmp_path: Path) -> Path:
    return make_walk(tmp_path / "walk", truth=True)


def finished_unseen(walk: Path, out: Path, token: str = "00ff") -> tuple[Task, Outcome]:
    """What a worker leaves that finished a task for a program that was killed meanwhile."""
    out.mkdir(exist_ok=True)
    planner = Planner(QUICK, Limits(), out)
    (planned,) = planner.plan(entries_of(walk), {}).to_do
    task = Task(walk.name, walk, out, token, QUICK, planner.asked, planned.signature)
    return task, do_here(task)


def test_work_that_was_finished_unseen_is_taken_in_and_not_done_again(
    walk: Path, tmp_path: Path
) -> None:
    out = tmp_path / "out"
    _, made = finished_unseen(walk, out)
    assert made.tracked
    count = Counting()
    outcome = batch(out, [walk], do=count)["walk"]
    assert count.names == []
    assert outcome.is_done
    assert outcome.score == made.score
    assert (out / "walk.h5").is_file()
    assert leftovers(out) == []


def test_it_is_taken_in_also_where_it_was_put_in_place_already(walk: Path, tmp_path: Path) -> None:
    out = tmp_path / "out"
    task, made = finished_unseen(walk, out)
    publish(task.workplace, task.name, made)
    count = Counting()
    assert batch(out, [walk], do=count)["walk"].is_done
    assert count.names == []


def cut_the_session(place: Workplace) -> None:
    place.session.write_bytes(place.session.read_bytes()[:-100])


def lose_the_session(place: Workplace) -> None:
    place.session.unlink()


def lose_the_outcome(place: Workplace) -> None:
    place.outcome.unlink()


def cut_the_outcome(place: Workplace) -> None:
    place.outcome.write_bytes(place.outcome.read_bytes()[:-20])


def say_something_else(place: Workplace) -> None:
    place.outcome.write_text('{"name": "walk", "path": 3, "asked": [], "outcome": {}}')


@pytest.mark.parametrize(
    "damage",
    [cut_the_session, lose_the_session, lose_the_outcome, cut_the_outcome, say_something_else],
)
def test_what_is_not_whole_is_removed_and_done_again(
    walk: Path, tmp_path: Path, damage: Callable[[Workplace], None]
) -> None:
    out = tmp_path / "out"
    task, _ = finished_unseen(walk, out)
    damage(task.workplace)
    count = Counting()
    assert batch(out, [walk], do=count)["walk"].is_done
    assert count.tracked == ["walk"]
    assert leftovers(out) == []


def test_work_that_was_asked_for_otherwise_is_not_taken_for_this(
    walk: Path, tmp_path: Path
) -> None:
    out = tmp_path / "out"
    finished_unseen(walk, out)
    frame = walk / "left" / "0003.png"
    shutil.copy(walk / "left" / "0004.png", frame)
    count = Counting()
    assert batch(out, [walk], do=count)["walk"].is_done
    assert count.tracked == ["walk"]


def test_a_program_that_is_interrupted_keeps_what_is_finished(tmp_path: Path) -> None:
    walks = [make_walk(tmp_path / f"walk{n}", n) for n in range(3)]
    out = tmp_path / "out"

    def stopping(task: Task) -> Outcome | None:
        if task.name == "walk1":
            return None
        return do_here(task)

    with pytest.raises(KeyboardInterrupt):
        batch(out, walks, do=stopping, listener=Interrupting())
    rows, _ = ledger_of(out)
    assert "walk0" in rows
    assert leftovers(out) == []
    count = Counting()
    outcomes = batch(out, walks, do=count)
    assert all(outcome.is_done for outcome in outcomes.values())
    assert sorted(count.names + list(rows)) == ["walk0", "walk1", "walk2"]


def test_attempts_whose_end_nobody_saw_are_told_as_lost(walk: Path, tmp_path: Path) -> None:
    out = tmp_path / "out"
    with batch_folder(out) as ledger:
        ledger.begin_attempt("walk", "run", "token", "1")
        ledger.commit()
        BatchRun(ledger, out, QUICK, Limits()).plan([])
        assert [attempt.result for attempt in ledger.attempts()] == ["lost"]


def test_work_under_a_name_that_leads_elsewhere_is_not_taken_in(walk: Path, tmp_path: Path) -> None:
    out = tmp_path / "top" / "out"
    out.parent.mkdir()
    task, made = finished_unseen(walk, out)
    crafted = Finished("../../victim", walk, task.asked, made)
    task.workplace.outcome.write_bytes(crafted.as_bytes())
    assert batch(out, [walk])["walk"].is_done
    assert not (tmp_path / "victim.h5").exists()

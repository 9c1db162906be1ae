"""What a batch tells of itself while it works, and how it is asked to stop."""

from __future__ import annotations

from pathlib import Path

import pytest

from tracking.batch import BatchState, Doing, Listener, StateFile, ask_to_stop, batch_folder, watch
from tracking.batch.watch import STATE, STOP, WatchedBatch, WorkedOn


class _Heard(Listener):
    def __init__(self) -> None:
        self.states: list[BatchState] = []

    def moved(self, state: BatchState) -> None:
        self.states.append(state)


def _state() -> BatchState:
    doing = {
        "1": Doing("1", "a", "tracking", 3, 12),
        "2": Doing("2"),
        "3": Doing("3", "b", "saving"),
    }
    return BatchState(10, 4, 1, 0, 2, doing, 61.5)


def test_whoever_looks_sees_how_far_it_is_as_long_as_it_works(tmp_path: Path) -> None:
    assert watch(tmp_path) is None
    heard = _Heard()
    with batch_folder(tmp_path):
        assert watch(tmp_path) == WatchedBatch()
        told = StateFile(tmp_path, {"a": tmp_path / "x" / "a", "b": tmp_path / "b"}, heard)
        told.began(_state())
        works = (
            WorkedOn(tmp_path / "x" / "a", "tracking", 0.25),
            WorkedOn(tmp_path / "b", "saving", None),
        )
        assert watch(tmp_path) == WatchedBatch(10, 4, 1, 0, 61.5, works)
        told.moved(_state())
        assert len(heard.states) == 1
        told.close()
        assert not (tmp_path / STATE).exists()
    assert watch(tmp_path) is None


def test_recordings_still_to_be_done_are_told_by_their_places(tmp_path: Path) -> None:
    places = {name: tmp_path / "in" / name for name in "abc"}
    with batch_folder(tmp_path):
        told = StateFile(tmp_path, places, Listener())
        told.began(BatchState(3, 1, left=dict.fromkeys(("b", "c", "of a shard"))))
        batch = watch(tmp_path)
        assert batch is not None
        assert batch.left == {places["b"], places["c"]}


def test_a_state_that_a_killed_batch_left_says_nothing(tmp_path: Path) -> None:
    StateFile(tmp_path, {}, Listener()).began(_state())
    assert (tmp_path / STATE).exists()
    assert watch(tmp_path) is None


@pytest.mark.parametrize("text", ["", "[", "[]", '{"total": "many"}', '{"total": 1}'])
def test_a_damaged_state_is_a_batch_of_which_nothing_is_known(tmp_path: Path, text: str) -> None:
    with batch_folder(tmp_path):
        (tmp_path / STATE).write_text(text)
        assert watch(tmp_path) == WatchedBatch()


def test_a_state_that_is_a_link_is_not_followed(tmp_path: Path) -> None:
    (tmp_path / "elsewhere").write_text("kept")
    with batch_folder(tmp_path):
        (tmp_path / STATE).symlink_to(tmp_path / "elsewhere")
        assert watch(tmp_path) == WatchedBatch()
        (tmp_path / f"{STATE}.part").symlink_to(tmp_path / "elsewhere")
        StateFile(tmp_path, {}, Listener()).began(_state())
        assert watch(tmp_path) == WatchedBatch(10, 4, 1, 0, 61.5)
    assert (tmp_path / "elsewhere").read_text() == "kept"


def test_who_asks_it_to_stop_interrupts_it_once(tmp_path: Path) -> None:
    ask_to_stop(tmp_path)
    told = StateFile(tmp_path, {}, Listener())
    told.moved(_state())  # the one before was meant
    ask_to_stop(tmp_path)
    with pytest.raises(KeyboardInterrupt):
        told.moved(_state())
    told.close()
    assert not (tmp_path / STOP).exists()

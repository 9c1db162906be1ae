"""What a batch notes of a recording, and its page: as they are now, not as they once were."""

from __future__ import annotations

import shutil
from dataclasses import replace
from pathlib import Path

import pytest

from tests.batch.batches import QUICK, Counting, batch
from tests.batch.walks import FRAMES, make_walk
from tracking.batch import Outcome
from tracking.translation import Message


@pytest.fixture(scope="module")
def first(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A recording with ground truth, and a finished batch of it with pages; not to be changed."""
    top = tmp_path_factory.mktemp("first")
    walk = make_walk(top / "walk", 1, truth=True)
    assert done_again(top)[0].score is not None
    assert walk.is_dir()
    return top


@pytest.fixture
def top(first: Path, tmp_path: Path) -> Path:
    """A copy of it."""
    return Path(shutil.copytree(first, tmp_path / "top", copy_function=shutil.copy2))


def done_again(top: Path, **order) -> tuple[Outcome, Counting]:
    """What became of the recording when the batch is done again, and what was worked on."""
    count = Counting()
    wanted = replace(QUICK, report=True, **order)
    return batch(top / "out", [top / "walk"], wanted, count)["walk"], count


def about(notes: tuple[Message, ...], words: str) -> list[str]:
    return [note for note in notes if words in note]


def test_a_note_on_a_truth_goes_once_it_is_mended(top: Path) -> None:
    truth = top / "walk" / "truth.txt"
    right = truth.read_text()
    truth.write_text("1,1,nonsense\n")
    damaged, _ = done_again(top)
    assert len(about(damaged.notes, "it is not scored")) == 1
    truth.write_text(right)
    mended, count = done_again(top)
    assert mended.score is not None
    assert about(mended.notes, "it is not scored") == []
    assert count.tracked == []


def test_a_note_on_a_truth_stays_while_it_is_damaged(top: Path) -> None:
    (top / "walk" / "truth.txt").write_text("1,1,nonsense\n")
    done_again(top)
    (top / "walk" / "other.txt").write_text("has it looked at again")
    still, count = done_again(top)
    assert count.names == ["walk"]
    assert len(about(still.notes, "it is not scored")) == 1


def test_a_note_on_a_format_goes_with_the_format(top: Path) -> None:
    asked, _ = done_again(top, exports=("pedpy-txt",))
    assert len(about(asked.notes, "no pedpy-txt: ")) == 1
    (top / "walk" / "other.txt").write_text("has it looked at again")
    without, _ = done_again(top)
    assert about(without.notes, "no pedpy-txt: ") == []


def test_a_recording_shorter_than_its_truth_is_noted_also_where_the_score_holds(top: Path) -> None:
    truth = top / "walk" / "truth.txt"
    truth.write_text(f"{truth.read_text()}{FRAMES + 6},1,20,23,23,86,1,-1,-1,-1\n")
    for _ in range(2):
        outcome, count = done_again(top)
        (note,) = about(outcome.notes, "the ground truth goes on")
        assert f"to frame {FRAMES + 6}, the recording has {FRAMES}," in note
        assert f"--frames 0:{FRAMES}" in note
        assert (count.names, count.tracked) == (["walk"], [])
        (top / "walk" / "other.txt").write_text("has it looked at again")


@pytest.mark.parametrize("gone", ["report", "report/walk", "report/walk/report.html"])
def test_a_page_that_somebody_deleted_is_made_again(top: Path, gone: str) -> None:
    place = top / "out" / gone
    if place.is_dir():
        shutil.rmtree(place)
    else:
        place.unlink()
    outcome, count = done_again(top)
    assert outcome.page
    assert (count.names, count.tracked) == (["walk"], [])
    assert "walk" in (top / "out" / "report" / "walk" / "report.html").read_text()
    assert done_again(top)[1].names == []

"""What a tracker told of its work is kept with its run."""

from __future__ import annotations

from contextlib import closing
from dataclasses import replace
from pathlib import Path

import h5py
import pytest
from made_up_sessions import make_recording, make_run

from tracking.errors import SessionError
from tracking.session import Session, describe
from tracking.session.run_notes import LONGEST_NOTE, MOST_NOTES


def made(folder: Path, notes: tuple[str, ...]) -> Path:
    path = folder / "s.h5"
    run = replace(make_run(), notes=notes)
    Session.create(make_recording(folder / "footage"), [run], path).close()
    return path


def notes_in(path: Path) -> tuple[str, ...]:
    with closing(Session.open(path)) as session:
        return session.runs[0].notes


def test_notes_are_read_as_they_were_saved_and_saved_again(tmp_path: Path) -> None:
    notes = ("the right camera is dead in frames 100 to 299", "\u00fc: 8 frames late")
    path = made(tmp_path, notes)
    with closing(Session.open(path)) as session:
        session.save(tmp_path / "again.h5")
    assert notes_in(path) == notes_in(tmp_path / "again.h5") == notes
    assert describe(path)["runs"][0]["notes"] == list(notes)


def test_a_run_without_notes_has_none_in_the_file_and_is_read(tmp_path: Path) -> None:
    path = made(tmp_path, ())
    with h5py.File(path, "r") as file:
        assert "notes" not in file["runs/0"].attrs
    assert notes_in(path) == ()


def test_only_so_many_and_so_long_ones_are_kept(tmp_path: Path) -> None:
    kept = notes_in(made(tmp_path, ("no\nendings " * 400, *"abc" * 20)))
    assert len(kept) == MOST_NOTES
    assert len(kept[0]) == LONGEST_NOTE
    assert "\n" not in kept[0]


@pytest.mark.parametrize(
    ("text", "note"),
    [
        (r'["\ud800 bad"]', "? bad"),
        (r'["\u001b]0;title\u0007"]', "?]0;title?"),
        (r'["left\u202eright"]', "left?right"),
    ],
)
def test_signs_that_steer_terminals_or_are_none_are_not_told(
    tmp_path: Path, text: str, note: str
) -> None:
    path = made(tmp_path, ("a",))
    with h5py.File(path, "r+") as file:
        file["runs/0"].attrs["notes"] = text
    assert describe(path)["runs"][0]["notes"] == [note]
    assert notes_in(path) == (note,)


def test_signs_that_are_none_are_saved_as_question_marks(tmp_path: Path) -> None:
    assert notes_in(made(tmp_path, ("a \ud800 b",))) == ("a ? b",)


@pytest.mark.parametrize("text", ["{", '"line"', "[1]", "[" * 5000, "[]" + " " * (1 << 20)])
def test_notes_of_a_file_that_are_none_are_damage(tmp_path: Path, text: str) -> None:
    path = made(tmp_path, ("a",))
    with h5py.File(path, "r+") as file:
        file["runs/0"].attrs["notes"] = text
    with pytest.raises(SessionError, match=r"damaged|like no session's"):
        describe(path)

"""What an edit is called is kept as data beside its English sentence, and shown in any language."""

from __future__ import annotations

import json
import sqlite3
from collections.abc import Callable
from contextlib import closing
from dataclasses import replace
from pathlib import Path

import h5py
import pytest
from made_up_sessions import make_session

from tracking.editing import (
    Change,
    Entry,
    plan_delete,
    plan_draw_box,
    plan_label_part,
    plan_lines,
    plan_mark_occluded,
    plan_mark_reviewed,
    plan_move_box,
    plan_occluders,
    plan_rename,
    plan_set_attribute,
    plan_swap,
    plan_verdict,
)
from tracking.session import Session
from tracking.session.session_writer import companions
from tracking.tracks import CountingLine, Occluder, PartLabel, Verdict
from tracking.translation import Message, tr

SWAP = "Swap 1 and 2 from frame 10 on"


@pytest.fixture
def saved(tmp_path: Path) -> Path:
    """Edited, saved and closed; a last edit waits in the journal."""
    with closing(make_session(tmp_path)) as session:
        session.apply(plan_swap(session.tracks, 1, 2, 10))
        session.apply(plan_rename(session.tracks, session.labels, 1, 'An {a} "b"'))
        session.undo_alone(1)
        path = session.save()
        session.apply(plan_swap(session.tracks, 1, 3, 3, 5))
        return path


def entries_of(path: Path) -> tuple[Entry, ...]:
    with closing(Session.open(path)) as session:
        return session.history.entries


@pytest.mark.usefixtures("pseudo")
def test_edits_of_a_file_and_of_its_journal_are_shown_in_the_users_language(saved: Path) -> None:
    assert [tr(entry.text) for entry in entries_of(saved)] == [
        "⟦Swap 1 and 2 ⟦from frame 10 on⟧⟧",
        '⟦Name 1 "An {a} "b""⟧',
        "⟦Undo edit 1 alone: ⟦Swap 1 and 2 ⟦from frame 10 on⟧⟧⟧",
        "⟦Swap 1 and 3 ⟦in frames 3 to 4⟧⟧",
    ]


@pytest.mark.usefixtures("pseudo")
def test_the_columns_of_the_text_stay_english(saved: Path) -> None:
    with h5py.File(saved) as file:
        assert file["edits/text"].asstr()[0] == SWAP
    with closing(sqlite3.connect(companions(saved) / "journal.sqlite")) as journal:
        texts = journal.execute("SELECT text FROM steps").fetchall()
    assert texts == [("Swap 1 and 3 in frames 3 to 4",)]


@pytest.mark.parametrize(
    "data",
    [
        "{",
        "[" * 3000,
        "[]",
        json.dumps({"text": "Delete {a}", "values": {"a": 1}}),  # says something else
        json.dumps({"text": "{a}", "values": {"a": [SWAP]}}),
        json.dumps({"text": f"{SWAP}{{a:s}}", "values": {"a": ""}}) + " " * 5000,
    ],
)
def test_a_line_whose_values_are_damaged_keeps_its_sentence(saved: Path, data: str) -> None:
    with h5py.File(saved, "a") as file:
        file["edits/message"][0] = data
    first = entries_of(saved)[0].text
    assert (first, first.values) == (SWAP, {})


def test_a_line_of_a_few_letters_cannot_fill_the_memory(saved: Path) -> None:
    data: dict[str, object] = {"text": "{a}" * 200, "values": {"a": "x" * 200}}
    for _ in range(3):
        data = {"text": "{a}" * 200, "values": {"a": data}}
    assert len(json.dumps(data)) < 4000
    with h5py.File(saved, "a") as file:
        file["edits/message"][0] = json.dumps(data)
    assert entries_of(saved)[0].text == SWAP


def test_the_undoing_of_an_undoing_is_cut_and_still_has_its_values(saved: Path) -> None:
    with closing(Session.open(saved)) as session:
        for number in range(3, 30):
            session.undo_alone(number)
        session.save()
    last = entries_of(saved)[-1].text
    assert (len(last), last[-1], last.template) == (200, "…", "Undo edit {number} alone: {text}")


PLANS: dict[str, Callable[[Session], Change]] = {
    "⟦Move the box of 1 in frame 3⟧": lambda s: plan_move_box(
        s.tracks, 1, 3, (2.0, 3.0, *(float(s.tracks.of_track(1, 3, 4)[n][0]) for n in SIZES))
    ),
    "⟦Resize the box of 1 in frame 3⟧": lambda s: plan_move_box(s.tracks, 1, 3, (2.0, 3.0, 40, 80)),
    "⟦Draw new track 5 in frame 3⟧": lambda s: plan_draw_box(s.tracks, None, 3, (2.0, 3.0, 4.0, 5)),
    "⟦Draw a box of 1 in frame 99⟧": lambda s: plan_draw_box(s.tracks, 1, 99, (2.0, 3.0, 4.0, 5.0)),
    "⟦Mark 1 as ⟦occluded⟧ ⟦in frame 3⟧⟧": lambda s: plan_mark_occluded(s.tracks, [1], 3, 4),
    "⟦Delete track 1⟧": lambda s: plan_delete(s.tracks, 1),
    "⟦Mark ⟦all tracks⟧ as reviewed ⟦in frame 3⟧⟧": lambda s: plan_mark_reviewed(s.labels, 0, 3, 4),
    "⟦Set coat of 1 to red and blue⟧": lambda s: plan_set_attribute(
        s.tracks, s.labels, 1, "coat", "red\nand  blue"
    ),
    '⟦Draw ⟦occluder⟧ "a"⟧': lambda s: plan_occluders(
        s.labels, [Occluder("a", ((0.0, 0.0), (9.0, 0.0), (9.0, 9.0)))]
    ),
    '⟦Draw ⟦counting line⟧ "a"⟧': lambda s: plan_lines(
        s.labels, [CountingLine("a", (0.0, 0.0), (1.0, 0.0))]
    ),
    "⟦Label ⟦the ⟦head⟧ of 1 in frame 3⟧⟧: ⟦unsure⟧": lambda s: plan_label_part(
        s.labels, PartLabel(3, 1, 0, (1.0, 2.0, 3.0, 4.0), None)
    ),
    "⟦Dismiss⟧: ⟦crossing of ⟦nobody⟧ in frame 3⟧": lambda s: plan_verdict(
        s.labels, Verdict("crossing", (), 3, "dismissed")
    ),
    "⟦Corrected⟧: 1 and 2 met": lambda s: plan_verdict(
        s.labels, Verdict("crossing", (), 3, "fixed"), "1 and 2\nmet"
    ),
}
SIZES = ("width", "height")


@pytest.mark.usefixtures("pseudo")
@pytest.mark.parametrize("said", PLANS)
def test_all_words_of_an_edit_are_translated_after_it_was_saved(said: str, tmp_path: Path) -> None:
    with closing(make_session(tmp_path)) as session:
        session.apply(PLANS[said](session))
        path = session.save()
    assert tr(entries_of(path)[0].text) == said


def test_a_text_that_is_no_message_is_kept_as_it_is(tmp_path: Path) -> None:
    with closing(make_session(tmp_path)) as session:
        swap = plan_swap(session.tracks, 1, 2, 10)
        session.apply(replace(swap, text=Message("of {another} program")))
        path = session.save()
    assert entries_of(path)[0].text == "of {another} program"

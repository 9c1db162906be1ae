"""States of large edits are not unpacked again and again while they are made."""

from __future__ import annotations

import numpy as np
import pytest

from tracking.editing import State, state_as_text, state_from_text
from tracking.editing.log import text
from tracking.editing.log.text import RecentStates
from tracking.tracks import CORRECTED_COLUMNS


def rows(count: int, seed: int) -> dict[str, np.ndarray]:
    rng = np.random.default_rng(seed)
    columns = {n: (9 * rng.random(count)).astype(kind) for n, kind in CORRECTED_COLUMNS.items()}
    return {**columns, "frame": np.arange(count, dtype=np.int32), "track": np.full(count, 3, "i4")}


def test_what_was_just_written_is_read_as_its_text_says_and_cannot_be_written_to(monkeypatch):
    given = State(rows=rows(50, 3105))
    written = state_as_text(given)
    known = state_from_text(written)
    monkeypatch.setattr(text, "_RECENT", RecentStates())
    read = state_from_text(written)
    for name, dtype in CORRECTED_COLUMNS.items():
        assert known.rows[name].dtype == read.rows[name].dtype == dtype
        assert known.rows[name].tobytes() == read.rows[name].tobytes()
        with pytest.raises(ValueError, match="read-only"):
            known.rows[name][0] = 1


def test_the_arrays_an_edit_was_planned_with_stay_the_callers_own():
    given = State(rows=rows(5, 3106))
    written = state_as_text(given)
    given.rows["left"][:] = -1.0
    assert (state_from_text(written).rows["left"] != -1.0).all()


def test_few_states_are_kept_and_no_large_one(monkeypatch):
    monkeypatch.setattr(text, "_CHARACTERS", 16)
    held = RecentStates()
    for number in range(100):
        held.put(str(number), State())
    held.put("longer than all others", State())
    kept = [number for number in range(100) if held.get(str(number)) is not None]
    assert kept == list(range(92, 100))
    assert held.get("longer than all others") is None

"""Taking the other annotator's word in one disagreement."""

import numpy as np
import pytest

from app.features.comparison.agreement import AgreementPresenter, OtherSession
from tracking.editing import apply_change
from tracking.recording import open_recording
from tracking.scoring import ScoringTable, agreement
from tracking.tracks import CORRECTED_COLUMNS, Labels, TrackTable

FRAMES = 60
PLACES = {1: 20.0, 2: 120.0}


def _table(people):
    """Rows of (track, place, frames)."""
    frames = np.concatenate([np.fromiter(which, int) for _, _, which in people])
    tracks = np.concatenate([np.full(len(which), track) for track, _, which in people])
    lefts = np.concatenate([np.full(len(which), left) for _, left, which in people])
    order = np.lexsort((tracks, frames))
    rows = {name: np.zeros(len(order), kind) for name, kind in CORRECTED_COLUMNS.items()}
    rows["frame"], rows["track"], rows["left"] = frames[order], tracks[order], lefts[order]
    rows["x"][:] = rows["y"][:] = np.nan  # nobody knows the floor
    rows["top"][:], rows["width"][:], rows["height"][:] = 20, 30, 80
    return TrackTable(rows)


@pytest.fixture
def presenter(tiny_recording):
    """A presenter of what two tables disagree about."""
    with open_recording(tiny_recording) as recording:

        def make(ours, theirs):
            tables = (ScoringTable.from_columns(one.columns()) for one in (ours, theirs))
            other = OtherSession("their.h5", theirs, agreement(*tables, gap=5), 0)
            return AgreementPresenter(recording, other, lambda _: (0, 0, 0))

        yield make


def _people(table):
    return {
        one: (table.frames_of_track(one).tolist(), table.of_track(one)["left"].tolist())
        for one in table.track_ids
    }


def test_of_a_swap_both_people_stand_as_they_have_them(presenter):
    every = range(FRAMES)
    ours = _table([(1, PLACES[1], every), (2, PLACES[2], every)])
    middle, ends = range(20, 40), [*range(20), *range(40, FRAMES)]
    theirs = _table(
        [
            (10, PLACES[1], ends),
            (20, PLACES[2], ends),
            (20, PLACES[1], middle),
            (10, PLACES[2], middle),
        ]
    )
    shown = presenter(ours, theirs)
    one = next(d for d in shown.other.agreement.disagreements if (d.track_a, d.track_b) == (1, 20))
    number = shown.other.agreement.disagreements.index(one)
    apply_change(ours, Labels(), shown.plan_theirs(number, ours))
    assert ours.frames_of_track(1).tolist() == ours.frames_of_track(2).tolist() == list(every)
    assert ours.of_track(1, 20, 40)["left"].tolist() == [PLACES[2]] * 20
    assert ours.of_track(2, 20, 40)["left"].tolist() == [PLACES[1]] * 20


def test_frames_in_which_both_agree_stay(presenter):
    every = range(FRAMES)
    ours = _table([(1, PLACES[1], every)])
    apart = [*range(10, 13), *range(16, 20)]
    theirs = _table([(10, PLACES[1], [f for f in every if f not in apart]), (10, 220.0, apart)])
    shown = presenter(ours, theirs)
    number = next(
        at for at, d in enumerate(shown.other.agreement.disagreements) if d.kind == "only a"
    )
    change = shown.plan_theirs(number, ours)
    apply_change(ours, Labels(), change)
    assert ours.frames_of_track(1).tolist() == list(every)
    assert ours.of_track(1, 13, 16)["left"].tolist() == [PLACES[1]] * 3
    assert set(ours.of_track(1, 16, 20)["left"].tolist()) == {220.0}

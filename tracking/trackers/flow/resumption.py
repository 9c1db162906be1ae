"""Going on with people as corrected."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
from numpy.typing import NDArray

from tracking.trackers.flow.walkers import Walkers, begin_walkers
from tracking.trackers.shared.corrected_rows import LED_ON_S, only
from tracking.trackers.shared.resumption import Resume
from tracking.tracks.columns import Columns, places_of

Floats = NDArray[np.float64]

_SLOPE_S = 0.5


def resume_walkers(resume: Resume) -> Walkers:
    """Everybody to be followed on who has a place on the floor, as they stand before the frame."""
    rows = only(resume.rows, np.isfinite(places_of(resume.rows)).all(axis=1))
    people = np.unique(rows["track"])
    states = [_state(rows, track, resume) for track in people]
    place = np.array([state[0] for state in states]).reshape(-1, 2)
    pace = np.array([state[1] for state in states]).reshape(-1, 2)
    walkers = begin_walkers(people.astype(np.int32), place, pace)
    return replace(walkers, walked=np.ones(len(walkers), bool))


def _state(rows: Columns, track: int, resume: Resume) -> tuple[Floats, Floats]:
    """Place m and pace m/s of a person in the frame before the first."""
    own = np.flatnonzero(rows["track"] == track)
    late = own[rows["frame"][own] >= rows["frame"][own[-1]] - round(_SLOPE_S * resume.fps)]
    place = places_of(rows, late)
    span_s = (rows["frame"][late[-1]] - rows["frame"][late[0]]) / resume.fps
    pace = (place[-1] - place[0]) / span_s if span_s > 0 else np.zeros(2)
    gap_s = (resume.frame - 1 - rows["frame"][own[-1]]) / resume.fps
    return place[-1] + pace * min(gap_s, LED_ON_S), pace

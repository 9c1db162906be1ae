"""The people to go on with: as corrected, in the colours the footage shows."""

from __future__ import annotations

from collections.abc import Iterable

import numpy as np
from numpy.typing import NDArray

from tracking.geometry import FlatView
from tracking.people import Observation
from tracking.trackers.shared.corrected_rows import (
    LED_ON_S,
    is_apart,
    is_seen,
    only,
    place_on_floor,
)
from tracking.trackers.shared.resumption import Resume
from tracking.trackers.spheroid.appearance import ColourLook, learn_colours
from tracking.trackers.spheroid.hypotheses import Floats, SpheroidPeople, begin_people
from tracking.trackers.spheroid.perception import FlatObservation
from tracking.trackers.spheroid.settings import SpheroidSettings
from tracking.tracks.columns import Columns, places_of

_SPREADS = (0.1, 0.3)
_HEIGHT_SD_M = 0.07
_SLOPE_S = 0.6


def resume_people(
    resume: Resume,
    observations: Iterable[Observation],
    flat: FlatView,
    settings: SpheroidSettings,
    usual_m: float,
    random: np.random.Generator,
) -> tuple[SpheroidPeople, float]:
    """Everybody to be followed on, and the seconds at which they stand so.

    Rows without a place on the floor stand where their boxes end. Somebody hidden is started where
    the rows lead, as one who was missed.

    Args:
        observations: of the frames `resume.colour_frames`, in order.
    """
    rows = place_on_floor(resume.rows, flat.view)
    track = np.unique(rows["track"])
    mean, missed_s = _now(rows, track, resume)
    height = np.full(len(track), usual_m)
    people = begin_people(
        track.astype(np.int32), mean, height, _HEIGHT_SD_M, settings.particles, _SPREADS, random
    )
    time_s = 0.0
    for seen in observations:
        assert isinstance(seen, FlatObservation), "spheroids step on flat observations"
        time_s = seen.time_s
        people = _learn_colours(people, only(rows, rows["frame"] == seen.frame), seen, flat)
    return people.replace(missed_s=missed_s), time_s


def _now(rows: Columns, track: NDArray[np.int32], resume: Resume) -> tuple[Floats, Floats]:
    """States (people, 4) in the frame before the first, and seconds since their last rows."""
    mean, missed_s = np.zeros((len(track), 4)), np.zeros(len(track))
    for k, one in enumerate(track):
        own = only(rows, rows["track"] == one)
        late = own["frame"] >= own["frame"][-1] - max(1, round(_SLOPE_S * resume.fps))
        time_s = own["frame"][late] / resume.fps
        missed_s[k] = (resume.frame - 1 - own["frame"][-1]) / resume.fps
        for axis, name in enumerate(("x", "y")):
            pace = float(np.polyfit(time_s, own[name][late], 1)[0]) if len(time_s) > 1 else 0.0
            led_on = pace * min(missed_s[k], LED_ON_S)
            mean[k, axis], mean[k, 2 + axis] = own[name][-1] + led_on, pace
    return mean, missed_s


def _learn_colours(
    people: SpheroidPeople,
    rows: Columns,
    seen: FlatObservation,
    flat: FlatView,
) -> SpheroidPeople:
    """The people with the colours seen of them in one frame."""
    good = is_seen(rows) & is_apart(rows)
    place = np.searchsorted(people.track, rows["track"])
    xy = people.xy.copy()
    xy[place] = places_of(rows)
    alone = np.zeros(len(people), bool)
    alone[place] = good
    colours, known = ColourLook(flat, seen.working.picture).at(xy, people.height)
    return learn_colours(people, colours, known, alone)

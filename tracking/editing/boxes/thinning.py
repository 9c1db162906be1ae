"""A tracker's stretch as keyframes: few enough to be corrected by hand."""

from __future__ import annotations

import numpy as np

from tracking.editing.boxes.interpolation import How, Way
from tracking.editing.boxes.keyframes import vouch_for
from tracking.editing.boxes.standing import Floats, boxes_of, places_of
from tracking.editing.boxes.stretches import Flags, replaced, spanned
from tracking.editing.change import Change, State
from tracking.editing.scope import Scope, check_scope, scope_text
from tracking.editing.selection import Rows, picked, stacked
from tracking.errors import EditError
from tracking.geometry import View
from tracking.tracks import Columns, Source, TrackTable, check_known


def plan_thin(
    table: TrackTable,
    track: int,
    start: int = 0,
    end: int | None = None,
    tolerance_px: float = 3.0,
    tolerance_m: float = 0.15,
    how: How | None = None,
    *,
    view: View | None = None,
    fps: float | None = None,
) -> Change:
    """Turn a stretch into keyframes with interpolation between them.

    Where no edge of a box and no place on the floor would be farther off than the tolerances, the
    row is interpolated; the others become keyframes, by dividing at the worst row again and again
    ([DouglasPeucker1973], here on box and place at once). Keyframes that are there stay, and so
    does what borders on rows whose box or place is unknown where its own is known.

    Args:
        table, track: what.
        start, end: half-open range of frames; end None: from there on.
        tolerance_px: of the boxes' edges. tolerance_m: of places that are known.
        how, view, fps: of the interpolation.

    Raises:
        EditError: fewer than three rows are there, a tolerance is not positive, or every row would
            have to stay.
    """
    check_known(table, track)
    check_scope(start, end)
    old = table.of_track(track, start, end)
    if len(old["frame"]) < 3:
        raise EditError(
            f"track {track} has fewer than three boxes {scope_text(start, end)}; nothing to thin"
        )
    if not (tolerance_px > 0 and tolerance_m > 0):
        raise EditError(f"tolerances of {tolerance_px} px and {tolerance_m} m: both are above 0")
    way = Way(how, view, fps)
    keys = _kept(old, way, (tolerance_px, tolerance_m))
    new = _thinned(old, keys, way)
    before, after = replaced(old, new)
    if keys.all() or not len(after["frame"]):
        raise EditError(f"track {track}: no row can be left out; allow a larger tolerance")
    count = len(old["frame"])
    text = f"Thin {track} {scope_text(start, end)} to {int(keys.sum())} keyframes of {count} boxes"
    frame, scope = int(old["frame"][0]), Scope(start, end)
    return Change("thin", text, frame, State(rows=before), State(rows=after), scope)


def _kept(rows: Columns, way: Way, tolerances: tuple[float, float]) -> Flags:
    """(n,) which rows become keyframes."""
    keys = np.asarray(rows["source"] == Source.PERSON)
    keys[0] = keys[-1] = True
    known = np.isfinite(np.column_stack([boxes_of(rows), places_of(rows)]))
    borders = np.flatnonzero((known[1:] != known[:-1]).any(axis=1))
    keys[borders] = keys[borders + 1] = True
    open_rows = np.flatnonzero(~keys)
    while len(open_rows):
        there = picked(rows, open_rows)
        between = spanned(picked(rows, keys), there["frame"], way, there)
        off, stretch = _off(there, between, tolerances), np.cumsum(keys)[open_rows]
        order = np.lexsort((off, stretch))
        worst = order[np.flatnonzero(np.diff(stretch[order], append=-1))]
        worst = worst[off[worst] > 1]
        keys[open_rows[worst]] = True
        divided = np.isin(stretch, stretch[worst])
        divided[worst] = False
        open_rows = open_rows[divided]
    return keys


def _thinned(rows: Columns, keys: Flags, way: Way) -> Rows:
    """The rows with those that are no keys interpolated between those that are."""
    ends, there = picked(rows, keys), picked(rows, ~keys)
    between = spanned(ends, there["frame"], way, there)
    vouch_for(ends)
    return stacked([ends, between])


def _off(rows: Columns, thinned: Columns, tolerances: tuple[float, float]) -> Floats:
    """(n,) how far box and place are off, in tolerances; what is unknown is not off."""
    edges, apart = boxes_of(thinned) - boxes_of(rows), places_of(thinned) - places_of(rows)
    edges[:, 2:] += edges[:, :2]
    box, place = np.abs(edges).max(axis=1), np.linalg.norm(apart, axis=1)
    return np.asarray(np.fmax(np.fmax(box / tolerances[0], place / tolerances[1]), 0.0))

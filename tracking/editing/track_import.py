"""Tracks made elsewhere, taken into the corrected table as one edit; and what of them is told."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass, replace
from typing import Any

import numpy as np
from numpy.typing import NDArray

from tracking.arrays import Flags
from tracking.editing.boxes.floor_boxes import (
    SIDES,
    USUAL_HEIGHT_M,
    body_heights,
    body_positions,
    boxes_of,
    places_of,
)
from tracking.editing.boxes.interpolation import Way
from tracking.editing.boxes.keyframe_reduction import thin_tracks
from tracking.editing.core.change import Change, LabelState, State
from tracking.editing.core.scope import tracks_text
from tracking.editing.core.selection import Rows, select_rows, stack_rows
from tracking.errors import EditError
from tracking.geometry import View
from tracking.progress import Progress, no_progress
from tracking.tracks import Columns, Labels, Schema, Source, TrackLabel, TrackTable, row_keys
from tracking.translation import msg

_SAME = 1e-6
"""Pixels or metres: text of other tools shifts numbers to and fro, which leaves dust."""

_PLACE, _VELOCITY = ("x", "y"), ("vx", "vy")

_FEWEST = 3
"""Rows of a track that is thinned."""

SeenAs = Callable[[NDArray[Any], NDArray[Any]], NDArray[Any]]
"""What a format keeps of visibilities, given them and which boxes are predicted."""


@dataclass(frozen=True, slots=True)
class ThinningResult:
    """How far tracks were thinned.

    Attributes:
        tracks: how many were. boxes: they had. keyframes: they have now.
    """

    tracks: int = 0
    boxes: int = 0
    keyframes: int = 0


def plan_import(
    table: TrackTable,
    labels: Labels,
    rows: Columns,
    told: Mapping[int, TrackLabel],
    source: str,
    *,
    view: View | None = None,
    vouched: bool = False,
    seen_as: SeenAs | None = None,
    schema: Schema = (),
) -> Change:
    """Put tracks made elsewhere into the table: new ones are added, known ones become as they are.

    Tracks that are not among the rows stay as they are. Of a known track, rows that the other tool
    did not change stay to the bit, and so do numbers it knows nothing of; names and attributes it
    gives take the place of those there were, others stay.

    Args:
        rows: `CORRECTED_COLUMNS`, by frame then track; NaN where unknown; source 0 throughout where
            the other tool knows no keyframes.
        told: what it says of whole tracks. schema: which attributes people have, as it says;
            labels that have a schema keep theirs. source: what it is called, as the log tells it.
        view: the left camera over its floor: whose box moved without a place goes along with it;
            without a view, or where the box has no height, that place is unknown.
        vouched: a tracker's row that the file calls a keyframe becomes a person's also where
            nothing else of it changed. Else it stays a tracker's: tools that know keyframes alone
            have to call every row of a tracker one.
        seen_as: how the other tool grades visibility, so that what it had to round is not told from
            what somebody changed; None: it keeps it as it is.

    Raises EditError where nothing would change.
    """
    before, after = _merged(table, rows, view, seen_as, vouched=vouched)
    ids = np.unique(rows["track"]).tolist()
    was, will = _labels(labels, {track: told[track] for track in ids if track in told})
    if schema and not labels.schema:
        was, will = replace(was, schema=()), replace(will, schema=schema)
    return _change(State(rows=before, labels=was), State(rows=after, labels=will), source)


def _change(before: State, after: State, source: str) -> Change:
    """The import with these two sides. Raises EditError where nothing would change."""
    if (
        not len(before.rows["frame"])
        and not len(after.rows["frame"])
        and (before.labels == after.labels)
    ):
        raise EditError(
            "nothing to import: {source} says what the corrected tracks say", source=source
        )
    touched = np.union1d(before.rows["track"], after.rows["track"]).tolist()
    who = tracks_text(touched or list(before.labels.tracks))
    text = msg("Import {who} from {source}", who=who, source=" ".join(source.split()))
    frames = [int(side.rows["frame"][0]) for side in (before, after) if len(side.rows["frame"])]
    return Change("import", text, min(frames, default=0), before, after)


def thin_dense(
    rows: Columns,
    tolerance_px: float,
    *,
    view: View | None = None,
    fps: float | None = None,
    report: Progress = no_progress,
) -> tuple[Rows, ThinningResult]:
    """Rows in which tracks without interpolated rows are keyframes with interpolation between.

    A track whose every row is a keyframe, or of which nobody says which rows are, is thinned as
    `plan_thin` does: no edge of a box ends up farther off than the tolerance. Tracks of fewer than
    three rows, and those of which no row can be left out, stay as they are. report: called with
    rows; raises to cancel.

    Raises EditError where the tolerance is not positive.
    """
    if not tolerance_px > 0:
        raise EditError(
            "a tolerance of {tolerance_px} px; give one above 0", tolerance_px=tolerance_px
        )
    dense = np.isin(rows["track"], _dense_tracks(rows))
    by_track = np.flatnonzero(dense)
    by_track = by_track[np.argsort(row_keys(rows["track"], rows["frame"])[by_track])]
    thin, changed = thin_tracks(
        select_rows(rows, by_track), tolerance_px, Way(view=view, fps=fps), report
    )
    keys = int(np.count_nonzero(thin["source"][changed] == Source.PERSON))
    tracks = len(np.unique(thin["track"][changed]))
    told = ThinningResult(tracks, int(np.count_nonzero(changed)), keys)
    return stack_rows([select_rows(rows, ~dense), thin]), told


def _dense_tracks(rows: Columns) -> list[int]:
    """The tracks of three rows and more whose rows are all keyframes, or all of a tracker."""
    tracks, place, counts = np.unique(rows["track"], return_inverse=True, return_counts=True)
    uniform = np.zeros(len(tracks), bool)
    for source in (Source.TRACKER, Source.PERSON):
        uniform |= np.bincount(place[rows["source"] == source], minlength=len(tracks)) == counts
    dense: list[int] = tracks[uniform & (counts >= _FEWEST)].tolist()
    return dense


def on_the_floor(rows: Columns, view: View) -> Rows:
    """Rows with places told from their boxes' feet, where they have none; see `body_positions`.

    A box without height is a point: it tells nothing of feet.
    """
    placed = select_rows(rows, slice(None))
    boxes = boxes_of(placed)
    whole = np.isfinite(boxes).all(axis=1) & (boxes[:, 3] > 0)
    lacking = np.flatnonzero(np.isnan(placed["x"]) & whole)
    if len(lacking):
        heights = np.full(len(lacking), USUAL_HEIGHT_M)
        places = body_positions(view, boxes[lacking], heights)
        placed["x"][lacking], placed["y"][lacking] = places.T
    return placed


def _merged(
    table: TrackTable, rows: Columns, view: View | None, seen_as: SeenAs | None, *, vouched: bool
) -> tuple[Rows, Rows]:
    """Which rows go, and the rows that come, with what only the old ones know."""
    ids = np.unique(rows["track"]).tolist()
    old = stack_rows(table.of_track(track) for track in ids if track in table)
    new = select_rows(rows, slice(None))
    was, will = _same_places(old, new)
    same = _are_same(select_rows(old, was), select_rows(new, will), seen_as, vouched=vouched)
    goes, comes = np.ones(len(old["frame"]), bool), np.ones(len(new["frame"]), bool)
    goes[was[same]] = comes[will[same]] = False
    changed = select_rows(new, will[~same])
    _keep_what_is_known(select_rows(old, was[~same]), changed, view, seen_as)
    for name, column in changed.items():
        new[name][will[~same]] = column
    after = select_rows(new, comes)
    if view is not None and np.isnan(rows["x"]).all():
        after = on_the_floor(after, view)
    return select_rows(old, goes), after


def _same_places(old: Columns, new: Columns) -> tuple[NDArray[np.intp], NDArray[np.intp]]:
    """Rows of both that are of one track in one frame."""
    keys = [row_keys(part["frame"], part["track"]) for part in (old, new)]
    _, was, will = np.intersect1d(keys[0], keys[1], assume_unique=True, return_indices=True)
    return was, will


def _are_same(old: Columns, new: Columns, seen_as: SeenAs | None, *, vouched: bool) -> Flags:
    """(n,) which new rows say nothing else than the old ones."""
    same = np.ones(len(old["frame"]), bool)
    for name in (*SIDES, *_PLACE):
        same &= np.isnan(new[name]) | _near(old, new, name)
    same &= np.isnan(new["visibility"]) | _seen_alike(old, new, old["predicted"], seen_as)
    if new["source"].any():  # else the other tool knows no keyframes
        held = (old["source"] == Source.TRACKER) & (new["source"] == Source.PERSON) & (not vouched)
        same &= held | (old["source"] == new["source"])
    return same


def _seen_alike(old: Columns, new: Columns, predicted: Flags, seen_as: SeenAs | None) -> Flags:
    """(n,) where the new rows say of visibility what the other tool would keep of the old one."""
    if seen_as is None:
        return _near(old, new, "visibility")
    return _near({"visibility": seen_as(old["visibility"], predicted)}, new, "visibility")


def _keep_what_is_known(old: Rows, new: Rows, view: View | None, seen_as: SeenAs | None) -> None:
    """Fill in what the new rows do not know, where it still holds."""
    alike = _seen_alike(old, new, new["predicted"], seen_as)
    new["visibility"] = np.where(alike, old["visibility"], new["visibility"])
    for name in (*SIDES, "confidence", "visibility"):
        new[name] = np.where(np.isnan(new[name]), old[name], new[name])
    stands = np.logical_and.reduce([_near(old, new, name) for name in SIDES])
    lacking = np.isnan(new["x"])
    for name in _PLACE:
        new[name] = np.where(lacking & stands, old[name], new[name])
    stays = np.logical_and.reduce([_near(old, new, name) for name in _PLACE])
    for name in _VELOCITY:
        new[name] = np.where(np.isnan(new[name]) & stays, old[name], new[name])
    moved = np.flatnonzero(lacking & ~stands & (new["height"] > 0))
    if view is not None and len(moved):
        boxes = boxes_of(old)[moved]
        heights = body_heights(view, places_of(old)[moved], boxes)
        new["x"][moved], new["y"][moved] = body_positions(view, boxes_of(new)[moved], heights).T


def _near(old: Columns, new: Columns, name: str) -> Flags:
    """(n,) where a column is the same but for dust; unknown and known are not."""
    near = np.abs(new[name] - old[name]) <= _SAME
    return np.asarray(near | (np.isnan(new[name]) & np.isnan(old[name])))


def _labels(labels: Labels, told: Mapping[int, TrackLabel]) -> tuple[LabelState, LabelState]:
    """Both sides of what is said of tracks, where it changes."""
    before, after = {}, {}
    for track, label in told.items():
        known = labels.of_track(track)
        attributes = dict(sorted({**known.attributes, **label.attributes}.items()))
        new = TrackLabel(label.name or known.name, attributes, label.notes or known.notes)
        if new != known:
            before[track], after[track] = known, new
    return LabelState(tracks=before), LabelState(tracks=after)

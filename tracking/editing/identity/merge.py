"""Planners that make one track of several."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Literal

import numpy as np
from numpy.typing import NDArray

from tracking.editing.boxes.interpolation import How, Way
from tracking.editing.boxes.stretches import interpolate_between
from tracking.editing.core.change import (
    Change,
    LabelState,
    State,
    Stretches,
    no_rows,
    no_stretches,
)
from tracking.editing.core.scope import frames_text, tracks_text
from tracking.editing.core.selection import Rows, rows_in, stack_rows
from tracking.editing.identity.identities import assign_to, stretches_of
from tracking.errors import EditError
from tracking.geometry import View
from tracking.tracks import Labels, TrackLabel, TrackTable, check_known
from tracking.translation import Message, msg

Keep = Literal["first", "second", "surer"]
Frames = NDArray[np.int32]


def plan_merge_tracks(
    table: TrackTable,
    into: int,
    others: Sequence[int],
    keep: Keep = "first",
    labels: Labels | None = None,
    *,
    fill: bool = False,
    how: How | None = None,
    view: View | None = None,
    fps: float | None = None,
) -> Change:
    """Make one track of several: everything of the others becomes the first one's.

    Args:
        table, into, others: which, and whose id stays.
        keep: where several stand in a frame, whose row stays: that of the earliest named of them
            ("first"), of the last named ("second"), or of highest confidence ("surer").
        labels: given, the first takes over what the others' say and its own does not.
        fill: gaps left between rows of different tracks are interpolated.
        how, view, fps: of that interpolation.

    Raises:
        EditError: a track is unknown or named twice, there are no others, or keep is another word.
    """
    tracks = (into, *others)
    _check(table, tracks, keep)
    frames, owners, shared = _kept(table, tracks, keep)
    moved, dropped = _given_up(table, tracks, frames, owners)
    way = Way(how, view, fps)
    filled = _bridges(table, into, frames, owners, way) if fill else dict(no_rows())
    said, says = _merged_labels(labels, into, others)
    return Change(
        "merge",
        _text(tracks, keep, shared, len(filled["frame"])),
        min(table.frame_range(track)[0] for track in others),
        State(moved, dropped, said),
        State(assign_to(moved, into), filled, says),
    )


def _check(table: TrackTable, tracks: tuple[int, ...], keep: Keep) -> None:
    """Raise EditError where these, the one that stays first, cannot be merged so."""
    check_known(table, *tracks)
    if len(tracks) < 2:
        raise EditError(
            "nothing to merge into track {track}; choose at least one more track", track=tracks[0]
        )
    for track in tracks:
        if tracks.count(track) > 1:
            raise EditError(
                "merge of track {track} with itself; choose different tracks", track=track
            )
    if keep not in ("first", "second", "surer"):
        raise EditError("merge: keep is {keep!r}; it is 'first', 'second' or 'surer'", keep=keep)


def _given_up(
    table: TrackTable, tracks: tuple[int, ...], frames: Frames, owners: NDArray[np.int64]
) -> tuple[Stretches, Rows]:
    """The stretches that go from the others to the first track, and the rows that go for good.

    Args:
        frames, owners: (n,) all frames, ascending, and whose row stays in each.
    """
    into, dropped, moved = tracks[0], [no_rows()], [no_stretches()]
    for track in tracks:
        own = table.frames_of_track(track)
        kept = frames[owners == track]
        dropped.append(rows_in(table, track, np.setdiff1d(own, kept, assume_unique=True)))
        if track != into:
            moved.append(stretches_of(track, kept, frames[owners != track]))
    return np.concatenate(moved), stack_rows(dropped)


def _kept(
    table: TrackTable, tracks: tuple[int, ...], keep: Keep
) -> tuple[Frames, NDArray[np.int64], int]:
    """All frames, ascending, whose row stays in each, and in how many frames several stood."""
    each = [table.frames_of_track(track) for track in tracks]
    frames = np.concatenate(each)
    rank = np.repeat(np.arange(len(tracks)), [len(own) for own in each])
    doubt = np.zeros(len(frames))
    if keep == "surer":
        sure = np.concatenate([table.of_track(track)["confidence"] for track in tracks])
        doubt = -np.nan_to_num(sure.astype(np.float64), nan=-1.0)
    order = np.lexsort((-rank if keep == "second" else rank, doubt, frames))
    first = np.flatnonzero(np.diff(frames[order], prepend=-1))
    stays = order[first]
    shared = np.count_nonzero(np.diff(first, append=len(frames)) > 1)
    return frames[stays], np.array(tracks)[rank[stays]], int(shared)


def _bridges(
    table: TrackTable, into: int, frames: Frames, owners: NDArray[np.int64], way: Way
) -> Rows:
    """Rows for the gaps between rows that were of different tracks."""
    gaps = np.flatnonzero((np.diff(frames) > 1) & (np.diff(owners) != 0))
    missing = [np.arange(frames[at] + 1, frames[at + 1], dtype=np.int32) for at in gaps]
    if not missing:
        return dict(no_rows())
    borders = np.unique(np.concatenate([gaps, gaps + 1]))
    ends = stack_rows(
        rows_in(table, track, frames[borders[owners[borders] == track]])
        for track in np.unique(owners[borders]).tolist()
    )
    ends["track"][:] = into
    return interpolate_between(ends, np.concatenate(missing), way, no_rows())


_SURER = msg("the surer row")


def _text(tracks: tuple[int, ...], keep: Keep, shared: int, filled: int) -> Message:
    text = msg("Merge {who} into {track}", who=tracks_text(tracks[1:]), track=tracks[0])
    if shared:
        whose: object = {"first": tracks[0], "second": tracks[-1], "surer": _SURER}[keep]
        who = msg("both") if len(tracks) == 2 else msg("several")
        if len(tracks) > 2 and keep != "surer":
            whose = msg("the first of them") if keep == "first" else msg("the last of them")
        text += msg(
            "; where {who} stand ({frames}), {whose} is kept",
            who=who,
            frames=frames_text(shared),
            whose=whose,
        )
    if filled:
        text += msg("; {frames} between them interpolated", frames=frames_text(filled))
    return text


def _merged_labels(
    labels: Labels | None, into: int, others: Sequence[int]
) -> tuple[LabelState, LabelState]:
    """What the tracks' labels said and will say."""
    said = [track for track in others if labels is not None and track in labels.tracks]
    if labels is None or not said:
        return LabelState(), LabelState()
    own = joined = labels.of_track(into)
    for track in said:
        joined = _joined(joined, labels.of_track(track))
    before = {into: own, **{track: labels.of_track(track) for track in said}}
    return LabelState(before), LabelState({into: joined, **dict.fromkeys(said, TrackLabel())})


def _joined(own: TrackLabel, other: TrackLabel) -> TrackLabel:
    notes = "\n".join(text for text in (own.notes, other.notes) if text)
    return TrackLabel(own.name or other.name, {**other.attributes, **own.attributes}, notes)

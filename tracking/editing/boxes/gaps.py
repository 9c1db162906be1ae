"""Gaps in tracks: where they are, and filling them."""

from __future__ import annotations

from collections.abc import Iterable

import numpy as np

from tracking.editing.boxes.interpolation import How, Way
from tracking.editing.boxes.stretches import interpolate_between
from tracking.editing.core.change import Change, State, no_rows
from tracking.editing.core.scope import Scope, check_tracks, frames_text, scope_text, tracks_text
from tracking.editing.core.selection import Rows, rows_in, stack_rows
from tracking.errors import EditError
from tracking.geometry import View
from tracking.tracks import TrackTable, check_known
from tracking.translation import msg

Gap = tuple[int, int]
"""A half-open range of frames between two rows of a track that has none in them."""


def gaps_of(table: TrackTable, track: int) -> tuple[Gap, ...]:
    """Where the track is missing between its first and its last row."""
    frames = table.frames_of_track(track)
    before = np.flatnonzero(np.diff(frames) > 1)
    starts, ends = frames[before] + 1, frames[before + 1]
    return tuple(zip(starts.tolist(), ends.tolist(), strict=True))


def plan_fill_gap(
    table: TrackTable,
    track: int,
    frame: int,
    how: How | None = None,
    *,
    view: View | None = None,
    fps: float | None = None,
) -> Change:
    """Fill the gap of a track that a frame lies in; the rows are marked as interpolated.

    Raises EditError where the track stands in the frame, or nothing is before or after it.
    """
    check_known(table, track)
    gap = next((gap for gap in gaps_of(table, track) if gap[0] <= frame < gap[1]), None)
    if gap is None:
        raise EditError(
            "frame {frame} lies in no gap of track {track}; go to one first",
            frame=frame,
            track=track,
        )
    text = msg("Fill the gap of {track} {where}", track=track, where=scope_text(*gap))
    rows = _filling(table, track, [gap], Way(how, view, fps))
    return Change("fill", text, gap[0], State(), State(rows=rows), Scope(*gap))


def plan_fill_gaps(
    table: TrackTable,
    tracks: Iterable[int],
    longest: int,
    how: How | None = None,
    *,
    view: View | None = None,
    fps: float | None = None,
) -> Change:
    """Fill all gaps of some tracks that are no longer than so many frames.

    Raises EditError where there is none.
    """
    chosen = check_tracks(table, tracks)
    way, parts, filled = Way(how, view, fps), [no_rows()], list[Gap]()
    for track in chosen:
        gaps = [gap for gap in gaps_of(table, track) if gap[1] - gap[0] <= longest]
        if gaps:
            filled += gaps
            parts.append(_filling(table, track, gaps, way))
    rows = stack_rows(parts)
    if not filled:
        raise EditError(
            "{who}: no gap of up to {frames}; allow longer ones",
            who=tracks_text(chosen),
            frames=frames_text(longest),
        )
    gaps_text = msg("the gap") if len(filled) == 1 else msg("{count} gaps", count=len(filled))
    text = msg(
        "Fill {gaps_text} of {who} of up to {frames}",
        gaps_text=gaps_text,
        who=tracks_text(chosen),
        frames=frames_text(longest),
    )
    scope = Scope(min(start for start, _ in filled), max(end for _, end in filled))
    return Change("fill", text, int(rows["frame"][0]), State(), State(rows=rows), scope)


def _filling(table: TrackTable, track: int, gaps: list[Gap], way: Way) -> Rows:
    borders = np.array([(start - 1, end) for start, end in gaps])
    frames = np.concatenate([np.arange(*gap, dtype=np.int32) for gap in gaps])
    ends = rows_in(table, track, np.unique(borders).astype(np.int32))
    return interpolate_between(ends, frames, way, no_rows())

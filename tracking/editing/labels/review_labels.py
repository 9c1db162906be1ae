"""Planners of what was looked at: reviewed ranges, and verdicts on review items."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import replace

import numpy as np

from tracking.editing.core.change import Change, LabelState, State
from tracking.editing.core.scope import Scope, scope_text, tracks_text
from tracking.editing.labels.track_labels import writable
from tracking.errors import EditError
from tracking.tracks import (
    Labels,
    ReviewedRange,
    TrackTable,
    Verdict,
    between,
    check_known,
    check_reviewed,
    check_verdict,
)
from tracking.translation import Message, msg

_SAID = {"right": msg("Looked at, right"), "fixed": msg("Corrected"), "dismissed": msg("Dismiss")}


def plan_mark_reviewed(
    labels: Labels,
    tracks: int | Iterable[int],
    start: int,
    end: int,
    table: TrackTable | None = None,
) -> Change:
    """Say that a track (0: all), or several, were looked at in frames start to end and are right.

    Args:
        table: where given, only the frames are marked in which each track has a row.

    Raises EditError for an empty range, where all of it is marked already, and where none of the
    tracks has a row in it.
    """
    asked = _ranges(tracks, start, end)
    marked = asked if table is None else _with_rows(asked, table)
    if not marked:
        raise EditError(
            "{who}: no boxes {where}; choose other frames",
            who=_who(asked),
            where=scope_text(start, end),
        )
    start, end = min(seen.start for seen in marked), max(seen.end for seen in marked)
    new = _joined([*labels.reviewed, *marked])
    who = _who(marked)
    if new == labels.reviewed:
        raise EditError(
            "{who}: marked as reviewed already {where}", who=who, where=scope_text(start, end)
        )
    text = msg("Mark {who} as reviewed {where}", who=who, where=scope_text(start, end))
    return _change("reviewed", text, Scope(start, end), labels.reviewed, new)


def plan_unmark_reviewed(
    labels: Labels, tracks: int | Iterable[int], start: int, end: int
) -> Change:
    """Take back that a track, or several, were looked at in frames start to end; 0: whoever was.

    Raises EditError for an empty range, where nothing of it is marked, and where a track is marked
    only together with all others.
    """
    unmarked = _ranges(tracks, start, end)
    chosen = {seen.track for seen in unmarked}
    new = []
    for seen in labels.reviewed:
        if 0 in chosen or seen.track in chosen:
            new += _without(seen, start, end)
        else:
            new.append(seen)
    who = _who(unmarked)
    if tuple(new) == labels.reviewed:
        together = any(
            seen.track == 0 and seen.start < end and start < seen.end for seen in labels.reviewed
        )
        why = (
            msg("marked for all tracks together; unmark all")
            if together
            else msg("not marked as reviewed")
        )
        raise EditError("{who}: {why} {where}", who=who, why=why, where=scope_text(start, end))
    text = msg("Unmark {who} as reviewed {where}", who=who, where=scope_text(start, end))
    return _change("unreviewed", text, Scope(start, end), labels.reviewed, tuple(new))


def plan_verdict(labels: Labels, verdict: Verdict, text: str = "") -> Change:
    """Say what came of looking at a review item. text: what it was, for the log; may be a message.

    Raises EditError for an unknown decision, and where that was said already.
    """
    before, after = _verdicts(labels, verdict)
    named = text or msg(
        "{kind} of {tracks} in frame {frame}",
        kind=" ".join(verdict.kind.split()),
        tracks=_listed(verdict.tracks),
        frame=verdict.frame,
    )
    what = named if isinstance(named, Message) else " ".join(writable(named).split())
    line = msg("{said}: {what}", said=_SAID[verdict.decision], what=what)
    return Change("verdict", line, verdict.frame, State(labels=before), State(labels=after))


def plan_verdicts(labels: Labels, verdicts: Sequence[Verdict], text: Message) -> Change:
    """Say what came of looking at several review items, as one step.

    Those of which that was said already stay as they are. text: what they were, for the log.

    Raises EditError for an unknown decision, for different decisions, and where nothing is new.
    """
    new = [one for one in verdicts if labels.verdicts.get(one.key) != one]
    if not new:
        raise EditError("all of these review items are decided like this already")
    if len({one.decision for one in new}) > 1:
        raise EditError("review items are decided together with one decision only")
    sides = [_verdicts(labels, one) for one in new]
    before, after = (
        LabelState(verdicts=tuple(one for state in states for one in state.verdicts))
        for states in zip(*sides, strict=True)
    )
    line = msg("{said}: {what}", said=_SAID[new[0].decision], what=text)
    return Change("verdict", line, new[0].frame, State(labels=before), State(labels=after))


def with_verdict(change: Change, labels: Labels, verdict: Verdict) -> Change:
    """The change with the verdict on the review item it settles, so that both are undone together.

    Raises EditError for an unknown decision, and where that was said already.
    """
    before, after = _verdicts(labels, verdict)
    sides = (change.before, before.verdicts), (change.after, after.verdicts)
    old, new = (
        replace(side, labels=replace(side.labels, verdicts=(*side.labels.verdicts, *verdicts)))
        for side, verdicts in sides
    )
    return replace(change, before=old, after=new)


def _verdicts(labels: Labels, verdict: Verdict) -> tuple[LabelState, LabelState]:
    check_verdict(verdict)
    writable(verdict.kind)
    old = labels.verdicts.get(verdict.key)
    if old == verdict:
        raise EditError(
            "the {kind} of {tracks} in frame {frame} is {decision} already",
            kind=verdict.kind,
            tracks=_listed(verdict.tracks),
            frame=verdict.frame,
            decision=verdict.decision,
        )
    return LabelState(verdicts=() if old is None else (old,)), LabelState(verdicts=(verdict,))


def _ranges(tracks: int | Iterable[int], start: int, end: int) -> list[ReviewedRange]:
    chosen = sorted(set(tracks)) if isinstance(tracks, Iterable) else [tracks]
    if not chosen:
        raise EditError("no track is named; choose one, or all")
    ranges = [ReviewedRange(int(track), int(start), int(end)) for track in chosen]
    for seen in ranges:
        check_reviewed(seen)
    return ranges


def _with_rows(ranges: Sequence[ReviewedRange], table: TrackTable) -> list[ReviewedRange]:
    """The parts of the ranges in which their track has rows; all tracks (0) stay as they are."""
    found: list[ReviewedRange] = []
    for seen in ranges:
        if not seen.track:
            found.append(seen)
            continue
        check_known(table, seen.track)
        frames = table.frames_of_track(seen.track)
        inside = frames[between(frames, seen.start, seen.end)]
        runs = np.split(inside, np.flatnonzero(np.diff(inside) > 1) + 1)
        found += [ReviewedRange(seen.track, int(r[0]), int(r[-1]) + 1) for r in runs if len(r)]
    return found


def _who(ranges: Sequence[ReviewedRange]) -> str:
    tracks = tuple(dict.fromkeys(seen.track for seen in ranges))
    if 0 in tracks:
        return msg("all tracks")
    return (
        msg("track {track}", track=tracks[0])
        if len(tracks) == 1
        else msg("tracks {who}", who=tracks_text(tracks))
    )


def _listed(tracks: Sequence[int]) -> str:
    """The tracks of a review item, which may be of nobody."""
    return tracks_text(tracks) if tracks else msg("nobody")


def _without(seen: ReviewedRange, start: int, end: int) -> list[ReviewedRange]:
    """What is left of a range where another one is taken out of it."""
    if seen.end <= start or end <= seen.start:
        return [seen]
    left = replace(seen, end=min(seen.end, start)), replace(seen, start=max(seen.start, end))
    return [part for part in left if part.start < part.end]


def _joined(ranges: Sequence[ReviewedRange]) -> tuple[ReviewedRange, ...]:
    """Sorted, with ranges of one track that touch made one."""
    joined: list[ReviewedRange] = []
    for seen in sorted(ranges):
        last = joined[-1] if joined else None
        if last is not None and last.track == seen.track and seen.start <= last.end:
            joined[-1] = replace(last, end=max(last.end, seen.end))
        else:
            joined.append(seen)
    return tuple(joined)


def _change(
    kind: str,
    text: Message,
    scope: Scope,
    old: tuple[ReviewedRange, ...],
    new: tuple[ReviewedRange, ...],
) -> Change:
    out, into = set(old) - set(new), set(new) - set(old)
    before = LabelState(reviewed=tuple(sorted(out)))
    after = LabelState(reviewed=tuple(sorted(into)))
    return Change(kind, text, scope.start, State(labels=before), State(labels=after), scope)

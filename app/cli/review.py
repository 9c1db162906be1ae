"""`review`: where a session's tracks are likely wrong."""

from __future__ import annotations

from contextlib import closing
from dataclasses import asdict
from pathlib import Path
from typing import Any

from app.cli.output import print_json, print_line, progress
from app.cli.sessions import open_session
from tracking.review import ReviewItem, filter_undecided, find_review_items, rank
from tracking.translation import msg


def run_review(path: Path, order: str, most: int | None, *, as_json: bool) -> None:
    """Print the review items that nobody has decided yet."""
    with (
        closing(open_session(path)) as session,
        progress(msg("looking through the tracks")) as told,
    ):
        fps, labels = session.recording.fps, session.labels
        found = find_review_items(
            session.tracks,
            session.corrected_run,
            fps,
            labels,
            progress=told,
            size=session.recording.size,
        )
        left = filter_undecided(found, labels, fps, session.tracks)
    shown = rank(left, order)[:most]
    if as_json:
        entries = [_entry(one, fps) for one in shown]
        print_json({"found": len(found), "open": len(left), "review_items": entries})
        return
    if not shown:
        print_line(_nothing(len(found)))
        return
    print_line(msg("   frame  sure    rows  what may be wrong (what would correct it)"))
    for one in shown:
        print_line(
            msg(
                "{frame:>8}  {likelihood:4.0%}  {cost:>6.0f}  {text} ({fix})",
                frame=one.frame,
                likelihood=one.likelihood,
                cost=one.cost,
                text=one.text,
                fix=one.fix,
            )
        )


def _nothing(found: int) -> str:
    """What is said where no review item is left."""
    if not found:
        return msg("Nothing is flagged.")
    return msg(
        "Nothing is left to look at: all {found} review items are decided or reviewed.", found=found
    )


def _entry(review_item: ReviewItem, fps: float) -> dict[str, Any]:
    """A review item by the names of its fields, with its second and what it is worth."""
    return {**asdict(review_item), "time_s": review_item.frame / fps, "worth": review_item.worth}

"""`review`: where a session's tracks are likely wrong."""

from __future__ import annotations

from collections.abc import Iterable
from contextlib import closing
from dataclasses import asdict
from pathlib import Path
from typing import Any

from app.cli.output import print_json, print_line, progress
from app.cli.sessions import open_session
from app.core.i18n import tr
from app.core.scenes.review_words import COUNTED, decided_text, risk_text
from tracking.progress import Progress
from tracking.review import (
    ReviewFinding,
    ReviewItem,
    ReviewItemFinder,
    ReviewState,
    rank,
    review_state,
)
from tracking.session import Session
from tracking.session.hand_made import is_hand_made
from tracking.translation import msg


def run_review(
    path: Path, order: str, most: int | None, *, hand_made: bool = False, as_json: bool
) -> None:
    """Print the review items that nobody has decided yet.

    hand_made: also those of what people drew, and of imported labels.
    """
    with (
        closing(open_session(path)) as session,
        progress(msg("looking through the tracks")) as told,
    ):
        fps, labels = session.recording.fps, session.labels
        quiet = not hand_made and is_hand_made(session.corrected_run)
        finding = ReviewFinding() if quiet else _found(session, hand_made, told)
        state = review_state(finding, labels, session.tracks, fps)
    shown = rank(state.left, order)[:most]
    if as_json:
        print_json({**_figures(state, searched=not quiet), "review_items": _entries(shown, fps)})
        return
    if not shown:
        print_line(_quiet() if quiet else _nothing(len(state.found)))
    else:
        _print_items(shown)
    if not quiet and state.items:
        print_line()
        print_line(decided_text(state.decided, state.items, state.reviewed))
        print_line(risk_text(state.errors))
        print_line(tr(COUNTED))


def _print_items(shown: Iterable[ReviewItem]) -> None:
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


def _found(session: Session, hand_made: bool, told: Progress) -> ReviewFinding:
    return ReviewItemFinder().find(
        session.tracks,
        session.corrected_run,
        session.recording.fps,
        session.labels,
        progress=told,
        size=session.recording.size,
        hand_made=hand_made,
    )


def _quiet() -> str:
    """What is said of tracks that no tracker made."""
    return msg("Labels that people made are not searched; --hand-made searches them.")


def _nothing(found: int) -> str:
    """What is said where no review item is left."""
    if not found:
        return msg("Nothing is flagged.")
    return msg(
        "Nothing is left to look at: all {found} review items are decided or reviewed.", found=found
    )


def _figures(state: ReviewState, *, searched: bool) -> dict[str, Any]:
    """How far the review is; nothing is expected of tracks that were not searched."""
    left = state.errors
    expected = {"expected": left.mean, "low": left.low, "high": left.high}
    return {
        "searched": searched,
        "found": len(state.found),
        "decided": state.decided,
        "open": len(state.left),
        "boxes_reviewed": state.reviewed,
        "errors_left": expected if searched else None,
    }


def _entries(shown: Iterable[ReviewItem], fps: float) -> list[dict[str, Any]]:
    return [_entry(one, fps) for one in shown]


def _entry(review_item: ReviewItem, fps: float) -> dict[str, Any]:
    """A review item by the names of its fields, with its second and what it is worth."""
    return {**asdict(review_item), "time_s": review_item.frame / fps, "worth": review_item.worth}

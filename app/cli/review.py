"""`review`: where a session's tracks are likely wrong."""

from __future__ import annotations

from contextlib import closing
from dataclasses import asdict
from pathlib import Path
from typing import Any

from app.cli.output import print_json, progress
from tracking.review import Suspicion, find_suspicions, open_suspicions, ranked
from tracking.session import Session


def run_review(path: Path, order: str, most: int | None, *, as_json: bool) -> None:
    """Print the suspicions that nobody has decided yet."""
    with closing(Session.open(path)) as session, progress("looking through the tracks") as told:
        fps = session.recording.fps
        run = session.runs[session.adopted] if session.adopted is not None else None
        view = session.recording.view()
        found = find_suspicions(session.tracks, run, fps, session.labels, view, told)
        left = open_suspicions(found, session.labels, fps)
    shown = ranked(left, order)[:most]
    if as_json:
        print_json({"found": len(found), "open": len(left), "suspicions": list(map(_entry, shown))})
        return
    for one in shown:
        print(f"{one.frame:>8}  {one.likelihood:4.0%}  {one.cost:>7.0f}  {one.text} -> {one.fix}")

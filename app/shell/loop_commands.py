"""The commands that play a stretch again and again, and slowly around an event."""

from __future__ import annotations

from typing import Final

from app.core.commands.command import Command
from app.core.commands.conditions import recording
from app.core.i18n import tr
from app.features.review.controller import ReviewController
from app.shell.window_app import WindowApp

_MENU = "Playback/Speed and loops"


def _stretch(app: WindowApp) -> tuple[int, int] | None:
    """The range that is set, else the review item's, else that of the selected person."""
    document = app.document
    if document is None:
        return None
    count, item = document.recording.frame_count, app.of(ReviewController).current
    frames = document.correcting.marked or ((item.start, item.end) if item is not None else None)
    if frames is None and document.selection:
        rows = document.tracks.of_track(document.selection.track)["frame"]
        frames = (int(rows[0]), int(rows[-1]) + 1) if len(rows) else None
    if frames is None:
        return None
    start, stop = max(0, frames[0]), min(frames[1], count)
    return (start, stop) if stop - start > 1 else None


def _loops(app: WindowApp) -> bool:
    return app.document is not None and app.open.playback.clock.loop is not None


def _can_loop(app: WindowApp) -> str:
    document = app.document
    if document is None or _loops(app) or document.correcting.marked or document.selection:
        return recording(app)
    if app.of(ReviewController).current is not None:
        return ""
    return tr("set a range with [ and ], go to a review item or select a person first")


def _loop(app: WindowApp) -> None:
    """Over the stretch of now, or no more."""
    playback, stretch = app.open.playback, _stretch(app)
    if _loops(app) or stretch is None:
        playback.set_loop(None)
        return
    playback.set_loop(stretch)
    app.say(tr("Frames {first} to {last} again and again", first=stretch[0], last=stretch[1] - 1))


def _is_slow(app: WindowApp) -> bool:
    return app.document is not None and app.open.playback.clock.event is not None


def _event(app: WindowApp) -> int:
    """Where the pending edit cuts, else where the review item happened, else the playhead."""
    flow, item = app.open.document.flow, app.of(ReviewController).current
    if flow is not None and flow.has_cut:
        return flow.cut
    return item.frame if item is not None else app.open.playback.clock.frame


def _slow(app: WindowApp) -> None:
    """Around the event of now, or no more."""
    app.open.playback.set_event(None if _is_slow(app) else _event(app))


COMMANDS: Final = (
    Command[WindowApp](
        "play.loop",
        "Loop over the range, item or person",
        _MENU,
        ("Ctrl+L",),
        _can_loop,
        _loop,
        checked=_loops,
        separated=True,
        also="repeat again",
    ),
    Command[WindowApp](
        "play.slow",
        "Slow motion around the event",
        _MENU,
        ("Ctrl+Shift+L",),
        recording,
        _slow,
        checked=_is_slow,
        also="slowly quarter speed swap",
    ),
)

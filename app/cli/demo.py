"""`demo`: the whole way from a recording to a score, on a scene made for it."""

from __future__ import annotations

import os
from contextlib import closing
from pathlib import Path

from app.cli.destination import check_folder, nearest_folder
from app.cli.display import has_display, why_no_window
from app.cli.option_groups import Order
from app.cli.output import print_json, print_lines, print_table, progress, say
from app.cli.score_inputs import score_of
from app.cli.track import has_work, save_partial_run, save_session, track_recording
from app.cli.tracks import tracks_at, truth_at
from app.core.interrupts import ending_at_once
from app.features.files.demonstration import Demonstration
from tracking.recording import open_recording
from tracking.scoring import Score
from tracking.session import Session
from tracking.translation import msg

_BYTES = 64 << 20


def run_demo(out: Path | None, *, gui: bool, as_json: bool) -> None:
    """Make the recording and open the window on it, or do without a window what it would do."""
    demo = Demonstration(out) if out is not None else Demonstration.of_user()
    if not demo.recording.exists():
        check_folder(nearest_folder(demo.folder), _BYTES)
    with progress(msg("making the recording")) as advance:
        demo.make(advance)
    if gui and not as_json and has_display():
        why_not = why_no_window()
        if not why_not:
            raise SystemExit(_show(demo))
        say(msg("no window: {why_not}", why_not=why_not))
    session = _session(demo.recording, demo.session)
    score = score_of(tracks_at(session), truth_at(demo.recording))
    picture = _picture(session, demo.picture)
    _print(demo.recording, session, picture, score, as_json=as_json)


def _show(demo: Demonstration) -> int:
    """The window, playing: on what somebody has worked on, else tracking the recording anew."""
    with ending_at_once():
        from app.shell.application import run

    worked_on = demo.session.exists() and _is_worked_on(demo.session)
    shown = demo.session if worked_on else demo.recording
    say(msg("opening the window on {shown}", shown=shown))
    return run(shown, play=True, save_at=demo.session)


def _session(recording: Path, place: Path) -> Path:
    """The recording's session: tracked anew, unless somebody has worked on it."""
    if place.exists() and _is_worked_on(place):
        say(msg("{place} holds corrections and is kept", place=place))
        return place
    check_folder(place.parent, _BYTES)
    with open_recording(recording) as footage:
        with save_partial_run(footage, place):
            run = track_recording(footage, Order(), place.parent)
        save_session(footage, run, place)
    return place


def _is_worked_on(place: Path) -> bool:
    with closing(Session.open(place)) as session:
        return has_work(session) or bool(session.damage)


def _picture(session: Path, place: Path) -> Path:
    """The real window on the session, drawn without a screen."""
    os.environ["QT_QPA_PLATFORM"] = "offscreen"
    with ending_at_once():
        from PySide6.QtCore import qInstallMessageHandler

        from app.shell.application import picture

    before = qInstallMessageHandler(_pass_on)
    try:
        return picture(session, place)
    finally:
        qInstallMessageHandler(before)


def _pass_on(_kind: object, _context: object, message: str) -> None:
    """Qt's messages, but for what an absent screen cannot do: of every window it says so."""
    if not message.startswith("This plugin does not support"):
        say(message)


def _print(recording: Path, session: Path, picture: Path, score: Score, *, as_json: bool) -> None:
    if as_json:
        paths = {"recording": str(recording), "session": str(session), "picture": str(picture)}
        print_json({**paths, "score": score.as_json()})
        return
    print_table(
        [(msg("recording"), recording), (msg("session"), session), (msg("picture"), picture)]
    )
    print_lines(score.as_text())

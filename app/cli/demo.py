"""`demo`: the whole way from a recording to a score, on a scene made for it."""

from __future__ import annotations

import os
from contextlib import closing
from pathlib import Path

from platformdirs import user_data_path

from app.cli.destination import check_folder, nearest_folder
from app.cli.display import has_display
from app.cli.output import print_json, print_table, progress, say
from app.cli.score import score_of
from app.cli.track import Order, has_work, save_session, tracked
from app.cli.tracks import tracks_at, truth_at
from tracking.errors import OutputError, TrackwrightError
from tracking.recording import open_recording
from tracking.scoring import Score
from tracking.session import Session
from tracking.synthesis import render_recording

SCENE, SECONDS, PEOPLE, SEED = "plaza", 20.0, 8, 4
_BYTES = 64 << 20


def run_demo(out: Path | None, *, gui: bool, as_json: bool) -> None:
    """Make the recording and open the window on it, or do without a window what it would do."""
    folder = out or user_data_path("trackwright", appauthor=False) / "demonstration"
    recording = _recording(folder)
    if gui and not as_json and has_display():
        from app.views.application import run

        say(f"opening the window on {recording}")
        raise SystemExit(run(recording))
    session = _session(recording, folder / "session.h5")
    score = score_of(tracks_at(session), truth_at(recording))
    picture = _picture(session, folder / "window.png")
    _print(recording, session, picture, score, as_json=as_json)


def _recording(folder: Path) -> Path:
    """The built-in recording, made where it is not there yet."""
    place = folder / "recording"
    if place.exists():
        _check_whole(place)
        return place
    check_folder(nearest_folder(folder), _BYTES)
    with progress("making the recording") as advance:
        return render_recording(place, SCENE, SECONDS, PEOPLE, SEED, advance)


def _check_whole(place: Path) -> None:
    try:
        open_recording(place).close()
    except TrackwrightError as error:
        raise OutputError(f"{error}; remove {place} and it is made anew") from error


def _session(recording: Path, place: Path) -> Path:
    """The recording's session: tracked anew, unless somebody has worked on it."""
    if place.exists() and _is_worked_on(place):
        say(f"{place} holds corrections and is kept")
        return place
    check_folder(place.parent, _BYTES)
    with open_recording(recording) as footage:
        save_session(footage, tracked(footage, Order()), place)
    return place


def _is_worked_on(place: Path) -> bool:
    with closing(Session.open(place)) as session:
        return has_work(session)


def _picture(session: Path, place: Path) -> Path:
    """The real window on the session, drawn without a screen."""
    os.environ["QT_QPA_PLATFORM"] = "offscreen"
    from PySide6.QtCore import qInstallMessageHandler

    from app.views.application import picture

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
    print_table([("recording", recording), ("session", session), ("picture", picture)])
    print(score.as_text())

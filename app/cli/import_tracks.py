"""`import`: tracks made elsewhere into a session, with a report of what could not be meant."""

from __future__ import annotations

from contextlib import closing
from dataclasses import asdict, dataclass
from pathlib import Path
from typing import Any

import typer

from app.cli.destination import check_file
from app.cli.option_groups import Bare
from app.cli.output import print_json, say
from app.cli.recordings import opened
from app.cli.track import refuse_to_lose
from app.presenters.files.opening import known_recordings, remember_place
from tracking.errors import FormatError, SessionError
from tracking.formats import Filmed, TrackFormat, format_named, format_of
from tracking.session import (
    Importable,
    ImportOrigin,
    ImportWish,
    RecordingMissing,
    Session,
    filmed_by,
    importable,
    session_of_import,
    take_into,
)
from tracking.tracks import TrackTable

_MOST_SHOWN = 20
"""Bad rows in the table people read; --json tells more of them."""


@dataclass(frozen=True, slots=True)
class Order:
    """What is to be imported, as typed.

    Attributes:
        tracks: the file. format: its name; None: told by content.
        recording, eyes: what the tracks are of, for a new session. out: that session.
        into: a session that is there already, instead.
        wish: how tracks are taken. take_good: also where some rows are bad.
        force: replace a session with corrections.
    """

    tracks: Path
    format: str | None
    recording: Path | None
    eyes: Bare
    out: Path | None
    into: Path | None
    wish: ImportWish
    take_good: bool = False
    force: bool = False


def run_import(order: Order, *, as_json: bool) -> None:
    """Import the tracks; print where they are and what was not taken.

    Raises:
        FormatError: the file cannot be read, or some rows are bad and were not allowed to be.
        typer.BadParameter: neither a new session nor one that is there is named, or both.
    """
    known = _format_of(order)
    if order.into is not None:
        _refuse_both(order)
        _into_session(order, order.into, known, as_json=as_json)
    elif order.out is None:
        raise typer.BadParameter("name the session to make, or one with --into", param_hint="--out")
    else:
        _into_new_session(order, order.out, known, as_json=as_json)


def _format_of(order: Order) -> TrackFormat:
    named = format_of(order.tracks) if order.format is None else format_named(order.format)
    if named.read is None:
        raise FormatError(f"{named.title} is only written; import another format")
    return named


def _refuse_both(order: Order) -> None:
    """A session knows its recording and its place."""
    given = {"--out": order.out, "--recording": order.recording, "--left": order.eyes.left}
    for name, value in given.items():
        if value is not None:
            raise typer.BadParameter(
                "the session of --into says that; leave it out", param_hint=name
            )


def _into_new_session(order: Order, out: Path, known: TrackFormat, *, as_json: bool) -> None:
    with opened(order.recording, order.eyes) as recording:
        check_file(out)
        refuse_to_lose(out, force=order.force)
        found = _found(order, known, filmed_by(recording), None, as_json=as_json)
        with closing(session_of_import(recording, found, _origin(order, known))) as session:
            session.save(out)
            remember_place(session, recording)
    _tell(order, found, known, out, None, as_json=as_json)


def _into_session(order: Order, into: Path, known: TrackFormat, *, as_json: bool) -> None:
    with closing(Session.open(into)) as session:
        if session.read_only:
            why = session.why_read_only.removeprefix(f"{session.path}: ")
            raise SessionError(f"{into} cannot be changed: {why}")
        found = _found(order, known, _filmed(session), session.tracks, as_json=as_json)
        entry = take_into(session, found, _origin(order, known))
        if entry is not None:
            session.save()
    _tell(order, found, known, into, entry is not None, as_json=as_json)


def _origin(order: Order, known: TrackFormat) -> ImportOrigin:
    return ImportOrigin.of(order.tracks, known.name)


def _filmed(session: Session) -> Filmed:
    """What is known of a session's recording, also where that is out of reach."""
    try:
        with session.open_recording(known=known_recordings()) as recording:
            return filmed_by(recording)
    except RecordingMissing:
        say("note: the recording is out of reach, and with it what camera and floor would tell")
        footage = session.recording
        return Filmed(footage.frame_count, footage.fps, footage.size)


def _found(
    order: Order, known: TrackFormat, filmed: Filmed, table: TrackTable | None, *, as_json: bool
) -> Importable:
    """The tracks, where they may be taken."""
    assert known.read is not None  # see `_format_of`
    found = importable(known.read(order.tracks, filmed), filmed, order.wish, table)
    for note in found.notes:
        say(f"note: {note}")
    if found.bad_count:
        if found.bad_count > 1:
            _show_bad_rows(order.tracks, found)
        if not order.take_good:
            if as_json:
                print_json(_report(order, found, known, None))
            raise FormatError(_refusal(order.tracks, found))
    if not len(found.rows["frame"]):
        raise FormatError(f"{order.tracks} holds no tracks; nothing to import")
    return found


def _refusal(path: Path, found: Importable) -> str:
    first = found.bad_rows[0]
    many = "1 row" if found.bad_count == 1 else f"{found.bad_count} rows"
    begins = "in" if found.bad_count == 1 else "the first in"
    return (
        f"{path}: {many} cannot be meant, {begins} {first.place}: {first.reason}; "
        "correct the file, or add --take-good to take the others"
    )


def _show_bad_rows(path: Path, found: Importable) -> None:
    """A table of the bad rows on stderr."""
    from rich.console import Console
    from rich.table import Table

    table = Table("place", "reason", title=f"Rows of {path.name} that cannot be meant")
    for row in found.bad_rows[:_MOST_SHOWN]:
        table.add_row(row.place, row.reason)
    more = found.bad_count - min(found.bad_count, _MOST_SHOWN)
    if more:
        table.caption = f"and {more} more" + ("" if more > 1000 else "; --json tells them")
    Console(stderr=True).print(table)


def _report(
    order: Order, found: Importable, known: TrackFormat, session: Path | None
) -> dict[str, Any]:
    return {
        "session": None if session is None else str(session),
        "file": str(order.tracks),
        "format": known.name,
        "tracks": found.tracks if session is not None else 0,
        "rows": len(found.rows["frame"]) if session is not None else 0,
        "good_rows": len(found.rows["frame"]),
        "bad_count": found.bad_count,
        "bad_rows": [asdict(row) for row in found.bad_rows],
        "thinned": asdict(found.thinned),
        "notes": list(found.notes),
    }


def _tell(
    order: Order,
    found: Importable,
    known: TrackFormat,
    session: Path,
    changed: bool | None,
    *,
    as_json: bool,
) -> None:
    """What was imported; changed: whether that was news to a session, None: it is a new one."""
    if as_json:
        report = _report(order, found, known, session)
        print_json(report | ({} if changed is None else {"changed": changed}))
        return
    thinned = found.thinned
    say(f"{known.title}: {found.tracks} tracks, {len(found.rows['frame'])} rows")
    if thinned.tracks:
        boxes = f"{thinned.boxes} boxes to {thinned.keyframes} keyframes"
        say(f"{thinned.tracks} tracks thinned: {boxes}")
    if found.bad_count:
        say(f"left out: {found.bad_count} rows that cannot be meant")
    if changed is False:
        say("the session says so already; nothing was changed")
    print(session)

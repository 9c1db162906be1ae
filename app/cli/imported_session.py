"""Imported tracks on their way into a session: a new one, or one that is there already."""

from __future__ import annotations

from contextlib import closing, nullcontext
from dataclasses import asdict
from pathlib import Path

from app.cli.destination import check_file
from app.cli.import_tracks import Source, show_bad_rows
from app.cli.output import print_json, print_line, progress, say
from app.cli.recordings import open_with_options
from app.cli.sessions import refuse_read_only
from app.cli.track import refuse_to_lose
from app.core.document.document_loader import known_recordings, remember_place
from tracking.formats import Filmed, Imported
from tracking.formats.schema_files import read_schema, schema_of_project
from tracking.progress import no_progress
from tracking.session import (
    Importable,
    ImportOrigin,
    ImportWish,
    RecordingMissing,
    Session,
    describe_footage,
    fit_to_recording,
    session_of_import,
    take_into,
)
from tracking.tracks import Schema, TrackTable
from tracking.translation import count_msg, msg


def into_new_session(source: Source, read: Imported | None, out: Path) -> None:
    """Make a session of the tracks, and tell what is in it."""
    order = source.order
    with open_with_options(order.recording, order.bare) as recording:
        check_file(out)
        refuse_to_lose(out, force=order.force)
        schema = _schema(order.attributes, recording.folder, out.parent)
        found = _fitted(source, read, describe_footage(recording), None, schema)
        with closing(session_of_import(recording, found, _origin(source))) as session:
            session.save(out)
            remember_place(session, recording)
    _tell(source, found, out, changed=True)


def into_session(source: Source, read: Imported | None, into: Path) -> None:
    """Take the tracks into a session that is there, as one edit, and tell what that was."""
    with closing(Session.open(into)) as session:
        refuse_read_only(session, into)
        schema = session.labels.schema or _schema(None, into.parent)
        found = _fitted(source, read, _filmed(session), session.tracks, schema)
        entry = take_into(session, found, _origin(source))
        if entry is not None:
            session.save()
    _tell(source, found, into, changed=entry is not None)


def _origin(source: Source) -> ImportOrigin:
    return ImportOrigin.of(source.order.tracks, source.format.name)


def _filmed(session: Session) -> Filmed:
    """What is known of a session's recording, also where that is out of reach."""
    try:
        with session.open_recording(known=known_recordings()) as recording:
            return describe_footage(recording)
    except RecordingMissing:
        say(
            msg("note: the recording is out of reach, and with it what camera and floor would tell")
        )
        footage = session.recording
        return Filmed(footage.frame_count, footage.fps, footage.size)


def _schema(named: Path | None, *folders: Path) -> Schema:
    """Which attributes people have: of the file that is named, else of the project.

    Raises FormatError where the file that is named cannot be read.
    """
    found = schema_of_project(*folders) if named is None else read_schema(named)
    for note in found.notes:
        say(msg("note: {note}", note=note))
    return found.schema


def _fitted(
    source: Source,
    read: Imported | None,
    filmed: Filmed,
    table: TrackTable | None,
    schema: Schema,
) -> Importable:
    """The tracks, as the recording's; rows beyond it are bad like any other."""
    order = source.order
    if read is None or (source.format.in_camera and filmed.view is not None):
        read = source.read(filmed)  # now places, or boxes, can be told
    wish = ImportWish(order.thin_px, order.as_new, order.only_people)
    thins = progress("Thinning") if wish.thin_px is not None else nullcontext(no_progress)
    with thins as report:
        found = fit_to_recording(read, filmed, wish, table, report, schema)
    source.refuse_bad_rows(found.bad_rows, found.bad_count)
    for note in found.notes:
        say(msg("note: {note}", note=note))
    return found


def _tell(source: Source, found: Importable, session: Path, *, changed: bool) -> None:
    """What was imported; changed: whether it was news."""
    rows, thinned = len(found.rows["frame"]), found.thinned
    if found.bad_count and source.order.report:
        show_bad_rows(source.order.tracks, found.bad_rows, found.bad_count)
    if source.as_json:
        said = {"session": str(session), "tracks": found.tracks, "rows": rows, "changed": changed}
        bad = source.report(found.bad_rows, found.bad_count)
        print_json({**said, **bad, "thinned": asdict(thinned), "notes": list(found.notes)})
        return
    if found.bad_count:
        left_out = (
            msg("1 row is")
            if found.bad_count == 1
            else msg("{bad_count} rows are", bad_count=found.bad_count)
        )
        more = "" if source.order.report else msg("; --report lists them")
        say(msg("note: {left_out} invalid and left out{more}", left_out=left_out, more=more))
    tracks = count_msg(found.tracks, "{n} track", "{n} tracks")
    say(msg("{title}: {tracks}, {rows} rows", title=source.format.title, tracks=tracks, rows=rows))
    if thinned.tracks:
        boxes = msg(
            "{boxes} boxes to {keyframes} keyframes",
            boxes=thinned.boxes,
            keyframes=thinned.keyframes,
        )
        say(msg("{tracks} tracks thinned: {boxes}", tracks=thinned.tracks, boxes=boxes))
    if not changed:
        say(msg("the session says so already; nothing was changed"))
    print_line(session)

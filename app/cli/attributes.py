"""`attributes`: which attributes the people of a session have, taken from a file or written."""

from __future__ import annotations

from contextlib import closing
from pathlib import Path

from app.cli.destination import check_file
from app.cli.export import check_is_own
from app.cli.output import print_json, print_line, say
from app.cli.sessions import open_session, refuse_read_only
from app.features.files.own_files import remember
from tracking.editing import SchemaChange, plan_schema
from tracking.formats.schema_files import read_schema, write_schema
from tracking.session import Session
from tracking.session.import_schema import attribute_text
from tracking.tracks import Attribute, Schema, missing_values, schema_as_values, unfit_values
from tracking.translation import Message, msg


def run_attributes(
    path: Path, take: Path | None, out: Path | None, *, force: bool, as_json: bool
) -> None:
    """Take a schema into a session, write it, or print it with what does not suit it.

    Raises FormatError where a file is no schema, EditError where nothing would change.
    """
    if out is not None:
        check_file(out)
        check_is_own([out], force=force)
    if take is not None:
        _take(path, take)
    with closing(open_session(path)) as session:
        labels, tracks = session.labels, session.tracks.track_ids
    schema = labels.schema
    notes = [*unfit_values(schema, labels.tracks), *missing_values(schema, labels.tracks, tracks)]
    if out is not None:
        write_schema(out, schema)
        remember([out])
    _print(schema, notes, as_json=as_json)


def _take(path: Path, file: Path) -> None:
    """Change a session's schema as one edit, and save it."""
    read = read_schema(file)
    for note in read.notes:
        say(msg("note: {note}", note=note))
    with closing(Session.open(path)) as session:
        refuse_read_only(session, path)
        wanted = SchemaChange(read.schema)
        session.apply(plan_schema(session.tracks, session.labels, wanted))
        session.save()


def _print(schema: Schema, notes: list[Message], *, as_json: bool) -> None:
    if as_json:
        print_json({"attributes": schema_as_values(schema), "notes": notes})
        return
    for note in notes:
        say(msg("note: {note}", note=note))
    if not schema:
        say(msg("the session does not say which attributes people have"))
    for attribute in schema:
        print_line(_line(attribute))


def _line(attribute: Attribute) -> Message:
    """E.g. "role: choice of guest, staff, default guest; required"."""
    what = attribute_text(attribute)
    if attribute.required:
        return msg("{name}: {what}; required", name=attribute.name, what=what)
    return msg("{name}: {what}", name=attribute.name, what=what)

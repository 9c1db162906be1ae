"""`import`: tracks made elsewhere into a session, with a report of invalid rows.

The file is read before anything is opened or made for it, and before what takes long to load: a
file that cannot be taken is refused at once.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from contextlib import AbstractContextManager, nullcontext
from dataclasses import asdict, dataclass, replace
from pathlib import Path
from typing import Any

import typer

from app.cli.option_groups import Bare
from app.cli.output import escape_controls, progress, say
from tracking.errors import FormatError
from tracking.formats import BadRow, Filmed, Imported, Stated, TrackFormat, format_named, format_of
from tracking.progress import Progress, no_progress
from tracking.translation import count_msg, msg, tr

_MOST_SHOWN = 20
"""Bad rows in the table people read; --json tells more of them."""

_WATCHED_BYTES = 1 << 22


@dataclass(frozen=True, slots=True)
class Order:
    """What is to be imported, as typed.

    Attributes:
        tracks: the file. format: its name; None: told by content.
        recording, bare: what the tracks are of, for a new session. out: that session.
        into: a session that is there already, instead.
        thin_px: thin dense tracks within this tolerance. as_new: with new ids.
        unit: of a text that does not say its own, as `bare.fps` is; None: it does.
        only_people: leave out what is none. take_good: take the good rows where others are bad.
        force: replace a session with corrections. report: list the rows that are invalid.
        attributes: a file that says which people have, of a new session; None: the project's.
    """

    tracks: Path
    format: str | None
    recording: Path | None
    bare: Bare
    out: Path | None
    into: Path | None
    unit: str | None = None
    thin_px: float | None = None
    as_new: bool = False
    only_people: bool = False
    take_good: bool = False
    force: bool = False
    report: bool = False
    attributes: Path | None = None


def run_import(order: Order, *, as_json: bool) -> None:
    """Import the tracks; print where they are and what was not taken.

    Raises:
        FormatError: the file cannot be read, or some rows are bad and were not allowed to be.
        typer.BadParameter: neither a new session nor one that is there is named, or both.
    """
    _check_whereto(order)
    source = Source(order, _format_of(order), as_json)
    # Where boxes are told in percent, the recording is asked first how large pictures are.
    found = None if source.format.in_percent else source.read(Filmed())
    from app.cli.imported_session import into_new_session, into_session  # take long to load

    if order.into is not None:
        into_session(source, found, order.into)
    elif order.out is not None:
        into_new_session(source, found, order.out)


def _check_whereto(order: Order) -> None:
    """Refuse options that exclude each other: a session knows its recording and its place."""
    if order.thin_px is not None and not 0 < order.thin_px < math.inf:  # NaN, too
        raise typer.BadParameter(msg("give pixels above 0"), param_hint="--thin")
    if order.into is None:
        if order.out is None:
            raise typer.BadParameter(
                msg("name the session to make, or one with --into"), param_hint="--out"
            )
        return
    given = {"--out": order.out, "--recording": order.recording, "--left": order.bare.left}
    given["--attributes"] = order.attributes
    for name, value in given.items():
        if value is not None:
            raise typer.BadParameter(
                msg("the session of --into says that; leave it out"), param_hint=name
            )


def _format_of(order: Order) -> TrackFormat:
    """The format that is named, else told by content.

    Raises FormatError where nothing tells it, BadParameter where none of that name is read, or it
    has a unit of its own.
    """
    found = _format_asked(order)
    if order.unit is not None and not found.unit_unsaid:
        raise typer.BadParameter(
            msg("{title} has a unit of its own; leave it out", title=found.title),
            param_hint="--unit",
        )
    return found


def _format_asked(order: Order) -> TrackFormat:
    if order.format is None:
        return _readable(format_of(order.tracks))
    try:
        return _readable(format_named(order.format))
    except FormatError as error:
        raise typer.BadParameter(tr(error.message), param_hint="--format") from error


def _readable(found: TrackFormat) -> TrackFormat:
    if found.read is None:
        raise FormatError("{title} is only written; import another format", title=found.title)
    return found


@dataclass(frozen=True, slots=True)
class Source:
    """A file whose tracks are asked for.

    Attributes:
        order: as typed. format: of the file. as_json: the report is printed as one document.
    """

    order: Order
    format: TrackFormat
    as_json: bool

    def read(self, filmed: Filmed) -> Imported:
        """The tracks of the file. Raises FormatError where they cannot be taken."""
        read = self.format.read
        filmed = replace(filmed, stated=Stated(self.order.unit or "", self.order.bare.fps))
        if read is None:
            raise FormatError(
                "{title} is only written; import another format", title=self.format.title
            )
        with self._watched() as report:
            found = read(self.order.tracks, filmed, report)
        self.refuse_bad_rows(found.bad_rows, found.bad_count)
        if not len(found.columns["frame"]):
            raise FormatError(
                "{tracks} holds no tracks; nothing to import", tracks=self.order.tracks
            )
        return found

    def _watched(self) -> AbstractContextManager[Progress]:
        """A progress bar, where reading takes long enough to be watched."""
        path = self.order.tracks
        is_long = path.is_file() and path.stat().st_size > _WATCHED_BYTES
        return (
            progress(msg("Reading {name}", name=path.name)) if is_long else nullcontext(no_progress)
        )

    def refuse_bad_rows(self, rows: Sequence[BadRow], count: int) -> None:
        """Refuse a file with invalid rows, unless the valid ones alone are asked for.

        Raises FormatError, which names the first one; with --report all are listed before.
        """
        if not count or self.order.take_good:
            return
        if self.order.report:
            show_bad_rows(self.order.tracks, rows, count)
        reason = count_msg(
            count,
            "{path}: {n} row is invalid, in {place}: {reason}",
            "{path}: {n} rows are invalid, the first in {place}: {reason}",
            path=self.order.tracks,
            place=rows[0].place,
            reason=rows[0].reason,
        )
        raise FormatError(
            reason,
            "correct the file, or add --take-good to import the others"
            if count == 1 or self.order.report
            else "correct the file, or add --take-good to import the others, --report to list all",
        )

    def report(self, rows: Sequence[BadRow], count: int) -> dict[str, Any]:
        """What a report says of the file."""
        return {
            "file": str(self.order.tracks),
            "format": self.format.name,
            "bad_count": count,
            "bad_rows": [asdict(row) for row in rows],
        }


def show_bad_rows(path: Path, rows: Sequence[BadRow], count: int) -> None:
    """A table of bad rows on stderr."""
    from rich.console import Console
    from rich.table import Table
    from rich.text import Text

    rows_told = msg("1 invalid row") if count == 1 else msg("{count} invalid rows", count=count)
    table = Table(
        "place",
        "reason",
        title=Text(
            escape_controls(msg("{rows_told} of {name}", rows_told=rows_told, name=path.name))
        ),
    )
    for row in rows[:_MOST_SHOWN]:
        table.add_row(Text(escape_controls(row.place)), Text(escape_controls(row.reason)))
    Console(stderr=True).print(table)
    if count > _MOST_SHOWN:
        say(
            msg(
                "and {n} more; --json tells the first {count} of all",
                n=count - _MOST_SHOWN,
                count=len(rows),
            )
        )

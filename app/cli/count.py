"""`count`: passages over lines and people in regions, of a session's tracks."""

from __future__ import annotations

from contextlib import closing
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import typer

from app.cli.destination import check_file, check_text_replaced
from app.cli.option_groups import InPicture, OnFloor
from app.cli.output import (
    STDOUT,
    escape_controls,
    print_json,
    print_line,
    refuse_two_documents,
    say,
    text_at,
)
from app.cli.sessions import open_session
from app.cli.shape_options import line_of, refuse_repeated, region_of
from app.cli.tracks import rough_note
from app.features.files.export import select_exported
from tracking.counting import (
    Counts,
    CountSettings,
    LineCount,
    NotOnFloorError,
    Occupancy,
    count,
    write_counts,
)
from tracking.errors import CountingError, SettingsError
from tracking.session import Session
from tracking.settings import settings_from
from tracking.text_columns import columns_of, to_left, to_right
from tracking.tracks import CountingLine, Region
from tracking.translation import joined, msg, tr

_OPTIONS = {"step_s": "--step", "jitter_m": "--jitter", "jitter_px": "--jitter-px"}
"""How each setting is typed."""


@dataclass(frozen=True, slots=True)
class Places:
    """What is counted over and in.

    Attributes:
        lines, regions: in the order they were typed. drawn: they are those of the session.
    """

    lines: tuple[CountingLine, ...]
    regions: tuple[Region, ...]
    drawn: bool = False


def run_count(
    path: Path,
    named: Places,
    settings: CountSettings,
    run: int | None,
    csv: Path | None,
    *,
    as_json: bool,
) -> None:
    """Print the counts; with csv the steps go into that file, or with - to stdout alone."""
    refuse_two_documents(csv, "--csv", as_json=as_json)
    if csv is not None and csv != STDOUT:
        _check_csv(csv)
    with closing(open_session(path)) as session:
        places = _places(session, named)
        counts = _counted(session, places, settings, run)
        rough = session.recording.is_rough
    _say_what(places, run)
    if rough:
        say(rough_note())
    if csv is not None:
        with text_at(csv) as place:
            write_counts(place, counts)
        say(
            msg(
                "{count} steps of {step_s:g} s: {csv}",
                count=len(counts.steps),
                step_s=settings.step_s,
                csv=csv,
            )
        )
    if csv == STDOUT:
        return
    if as_json:
        print_json(counts_as_json(counts))
    else:
        for line in _lines_of(counts):
            print_line(line)


def _counted(session: Session, places: Places, settings: CountSettings, run: int | None) -> Counts:
    """Counts of the tracks. Raises CountingError, which names the session."""
    recording, path = session.recording, session.path
    columns = select_exported(session, run)
    length = recording.fps, recording.frame_count
    try:
        return count(columns, *length, places.lines, places.regions, settings)
    except NotOnFloorError as error:
        raise NotOnFloorError(
            "{path}: {reason}",
            error.to_do,
            option="--picture-line, --picture-region",
            path=path,
            reason=error.reason,
        ) from error
    except CountingError as error:
        raise CountingError(
            "{path}: {reason}", error.to_do, path=path, reason=error.reason
        ) from error


def places_named(floor: OnFloor, picture: InPicture) -> Places:
    """What was typed. Raises BadParameter where something is no line or region."""
    over = [line_of(text, in_picture=False) for text in floor.line or ()]
    over += [line_of(text, in_picture=True) for text in picture.picture_line or ()]
    within = [region_of(text, in_picture=False) for text in floor.region or ()]
    within += [region_of(text, in_picture=True) for text in picture.picture_region or ()]
    refuse_repeated(over, "line")
    refuse_repeated(within, "region")
    return Places(tuple(over), tuple(within))


def counts_as_json(counts: Counts) -> dict[str, Any]:
    """As the contract names it."""
    lines = {one.line.name: dict(_ways(one)) for one in counts.lines}
    regions = {one.region.name: {"person_steps": one.person_steps} for one in counts.regions}
    return {"lines": lines, "regions": regions}


def _check_csv(csv: Path) -> None:
    check_file(csv)
    check_text_replaced(csv, "--csv")


def _places(session: Session, named: Places) -> Places:
    """What was named, else what is drawn in the session."""
    if named.lines or named.regions:
        return named
    drawn = Places(session.labels.lines, session.labels.regions, drawn=True)
    if not (drawn.lines or drawn.regions):
        raise CountingError(
            "{path} has no lines or regions drawn in it; name some (--line, --region)",
            path=session.path,
        )
    return drawn


def _say_what(places: Places, run: int | None) -> None:
    tracks = msg("the corrected tracks") if run is None else msg("run {run}", run=run)
    origin = msg("drawn in the session") if places.drawn else msg("as named")
    lines, regions = (
        joined(", ", (item.name for item in items)) for items in (places.lines, places.regions)
    )
    named = (
        lines and msg("lines {names}", names=lines),
        regions and msg("regions {names}", names=regions),
    )
    what = joined("; ", filter(None, named))
    say(msg("{tracks}; {what}, {origin}", tracks=tracks, what=what, origin=origin))


def _ways(line: LineCount) -> tuple[tuple[str, int], tuple[str, int]]:
    forward, backward = line.totals
    return ("forward", forward), ("backward", backward)


def _lines_of(counts: Counts) -> list[str]:
    """The totals for people: a table of lines, then one of regions."""
    told = []
    if counts.lines:
        rows = [(one.line.name, *(str(n) for _, n in _ways(one))) for one in counts.lines]
        told += _table((tr("line"), tr("forward"), tr("backward")), rows)
    if counts.regions:
        headings = (tr("region"), tr("person-steps"), tr("most people"), tr("mean people"))
        told += _table(headings, [_region_row(one) for one in counts.regions])
    return told


def _region_row(one: Occupancy) -> tuple[str, ...]:
    most = int(one.people.max(initial=0))
    mean = one.people.mean() if len(one.people) else 0.0
    return one.region.name, str(one.person_steps), str(most), f"{mean:.2f}"


def _table(headings: tuple[str, ...], rows: list[tuple[str, ...]]) -> list[str]:
    """Names to the left, numbers to the right."""
    lines = [[escape_controls(cell) for cell in row] for row in (headings, *rows)]
    widths = [max(map(columns_of, column)) for column in zip(*lines, strict=True)]
    return [
        "  ".join(
            [to_left(row[0], widths[0])]
            + [to_right(cell, width) for cell, width in zip(row[1:], widths[1:], strict=True)]
        )
        for row in lines
    ]


def count_settings(step_s: float, jitter_m: float, jitter_px: float) -> CountSettings:
    """What was typed. Raises BadParameter for a step or a distance that cannot be."""
    typed = {"step_s": step_s, "jitter_m": jitter_m, "jitter_px": jitter_px}
    for name, value in typed.items():
        try:
            settings_from(CountSettings, {name: value})
        except SettingsError as error:
            raise typer.BadParameter(tr(error.message), param_hint=_OPTIONS[name]) from error
    return CountSettings(**typed)

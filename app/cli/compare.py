"""`compare`: two people's sessions of one recording."""

from __future__ import annotations

from contextlib import closing
from pathlib import Path

from app.cli.output import print_json, print_line, print_table
from app.cli.sessions import open_session
from app.core.document.recording_match import refuse_other_recording
from tracking.scoring import (
    Agreement,
    BoxMatch,
    EitherMatch,
    FloorMatch,
    Match,
    ScoringTable,
    agreement,
    stretch_gap,
)
from tracking.session import RecordingReference
from tracking.translation import msg

_LISTED = 20


def run_compare(a: Path, b: Path, match: str, radius_m: float, *, as_json: bool) -> None:
    """Print how far the corrected tracks of two sessions agree.

    Raises:
        SessionError: one cannot be read, or they are of different recordings.
    """
    table_a, reference_a = _of_session(a)
    table_b, reference_b = _of_session(b)
    refuse_other_recording(reference_a, reference_b, str(b))
    gap = stretch_gap(reference_a.fps)
    found = agreement(table_a, table_b, _how(match, radius_m), gap=gap)
    if as_json:
        print_json(found.as_json())
    else:
        _print(found)


def _how(match: str, radius_m: float) -> Match:
    if match == "box":
        return BoxMatch()
    return FloorMatch(radius_m) if match == "floor" else EitherMatch(radius_m)


def _of_session(path: Path) -> tuple[ScoringTable, RecordingReference]:
    with closing(open_session(path)) as session:
        return ScoringTable.from_columns(session.tracks.columns()), session.recording


def _print(found: Agreement) -> None:
    figures = found.as_json()
    shares = {name: figures[name] for name in ("IDF1", "kappa")}
    print_table(
        [
            (msg("frames"), found.frames),
            (msg("rows compared"), found.rows),
            *((name, "-" if share is None else f"{share:.4f}") for name, share in shares.items()),
            (msg("disagreements"), len(found.disagreements)),
        ]
    )
    for one in found.disagreements[:_LISTED]:
        who = msg(
            "{track_a} here, {track_b} there",
            track_a=one.track_a or msg("nobody"),
            track_b=one.track_b or msg("nobody"),
        )
        print_line(
            msg("frames {start} to {last}: {who}", start=one.start, last=one.end - 1, who=who)
        )
    left = len(found.disagreements) - _LISTED
    if left > 0:
        print_line(msg("and {left} more; --json lists all", left=left))

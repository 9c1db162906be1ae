"""Runs of the trackers of body parts, kept as long as nothing they were made with has changed.

Beside all else a run hangs on the failure detector, where its tracker acts on one.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from functools import cache
from pathlib import Path
from typing import Any

from tests.benchmarks.kept_results import LIBRARIES, keep, path_of, sources_of, tables_in
from tracking.failure import built_in_detector
from tracking.tracks import Columns

_ROOMS = (
    *("failure/*.py", "filtering/**/*.py", "foreground/**/*.py", "geometry/**/*.py"),
    *("people/**/*.py", "pipeline/**/*.py", "recording/**/*.py", "setting*.py"),
    *("trackers/*.py", "trackers/three_part/**/*.py", "tracks/**/*.py"),
)


@dataclass(frozen=True, slots=True, eq=False)
class Seen:
    """What a tracker saw: the columns of its tracks and of their parts."""

    tracks: Columns
    parts: Columns


def kept_run(folder: Path, chosen: tuple[Any, ...], judged: bool, make: Callable[[], Seen]) -> Seen:
    """The run over a clip's folder as it is kept, made where it is not.

    Args:
        chosen: the tracker and its settings. judged: whether it acts on the built-in detector.
    """
    detector = built_in_detector().fingerprint if judged else ""
    path = path_of(folder, sources(), LIBRARIES, repr(chosen), detector)
    if path.is_file():
        return Seen(**tables_in(path, ("tracks", "parts")))
    seen = make()
    keep(path, {"tracks": seen.tracks, "parts": seen.parts})
    return seen


@cache
def sources() -> str:
    """A hash over the sources of all rooms that a run goes through."""
    return sources_of(_ROOMS)

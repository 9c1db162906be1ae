"""What light, a failing right camera and poor cameras do to our tracker."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from pathlib import Path
from typing import Any

from tests.benchmarks.rendered_clips import Clip
from tests.benchmarks.spheroid.ghosts import ghosts_s
from tests.benchmarks.stereo.clip_scores import figures_of
from tests.benchmarks.stereo.clips import folder
from tests.benchmarks.stereo.columns import OURS
from tests.benchmarks.stereo.disturbances import DISTURBANCES, disturbed
from tests.benchmarks.stereo.trackers import runs_over
from tests.benchmarks.stereo.troubles import TROUBLES, troubled
from tests.benchmarks.stereo.truth import truth_of
from tracking.scoring import BoxMatch, ScoringTable, score

DIMMED = "part of the light goes out"
SOUND = "nothing"


def measure(
    dimmed: Sequence[Clip], sound: Sequence[Clip], kept: Path | None = None
) -> list[dict[str, Any]]:
    """Scores of each clip, and for how long a track stood where nobody was."""
    return [
        {"what": what, "clip": clip.scene, **_row(place)}
        for what, clip, place in _recordings(dimmed, sound, kept)
    ]


def _recordings(
    dimmed: Sequence[Clip], sound: Sequence[Clip], kept: Path | None
) -> Iterator[tuple[str, Clip, Path]]:
    for clip in dimmed:
        yield DIMMED, clip, folder(clip, kept)
    for clip in sound:
        place = folder(clip, kept)
        yield SOUND, clip, place
        for trouble in TROUBLES:
            yield trouble.name, clip, troubled(place, trouble)
        for disturbance in DISTURBANCES:
            yield disturbance.name, clip, disturbed(place, disturbance)


def _row(place: Path) -> dict[str, Any]:
    truth = truth_of(place)
    tracks = runs_over(place, [OURS])[OURS].tracks
    result = score(truth.table, ScoringTable.from_columns(tracks), BoxMatch(0.5))
    alone_s = ghosts_s(truth.columns, dict(tracks), truth.fps)
    return {**figures_of(result), "alone_s": float(alone_s.max(initial=0.0))}

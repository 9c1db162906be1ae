"""One camera in other scenes and in real footage, beside two cameras on the same truth."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path
from typing import Any

from tests.benchmarks.rendered_clips import Clip, folder_of, run_of
from tracking.formats import read_mot
from tracking.scoring import FloorMatch, Score, ScoringTable, score

ONE_EYE = ("spheroid", "three-part")
BESIDE_TWO = (*ONE_EYE, "stereo-direction")
REAL = ("pets-s2l1-real",)
RADIUS_M = 1.0


def places(clips: Sequence[Clip], kept: Path | None = None) -> list[dict[str, Any]]:
    """Scores of each rendered scene, by tracker."""
    return [
        told(clip.scene, tracker, scored(folder_of(clip, kept), tracker))
        for clip in clips
        for tracker in BESIDE_TWO
    ]


def real(data: Path) -> list[dict[str, Any]]:
    """Scores of the real recordings that are there, of trackers that one camera is enough for."""
    return [
        told(name, tracker, scored(data / name, tracker))
        for name in REAL
        if (data / name / "truth.txt").is_file()
        for tracker in ONE_EYE
    ]


def scored(folder: Path, tracker: str) -> Score | None:
    """The tracker's score by floor distance; None where it says no floor positions."""
    tracks = run_of(folder, tracker).tracks
    truth = ScoringTable.from_columns(read_mot(folder / "truth.txt"), dont_cares=True)
    result = ScoringTable.from_columns(tracks)
    if len(result) and (result.position != result.position).all():
        return None
    return score(truth, result, FloorMatch(RADIUS_M))


def told(name: str, tracker: str, result: Score | None) -> dict[str, Any]:
    """The figures of a score that are reported."""
    row: dict[str, Any] = {"recording": name, "tracker": tracker}
    if result is None:
        return row
    figures = result.as_json()
    row.update({key: figures[key] for key in ("MOTA", "IDF1", "HOTA", "id_switches")})
    row["error_cm"] = 100 * figures["position_error_m"]["mean"]
    row["kept"], row["detected"] = figures["people_kept"], figures["people_detected"]
    return row

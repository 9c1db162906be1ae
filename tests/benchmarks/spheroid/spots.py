"""Floor error of people who stand on marks or walk between them ([Waechter2013] tables 1, 2)."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from tests.benchmarks.rendered_clips import Clip, floor_truth, folder_of, moments, run_of
from tests.benchmarks.spheroid.people_kept import Followed, follow
from tracking.synthesis.marks import MARKS_M

TRACKER = "spheroid"
_RADIUS_M = 0.6  # farther off is not that person


def standing(clips: Sequence[Clip], kept: Path | None = None) -> dict[str, Any]:
    """Error of each mark: mean and deviation in cm, share of frames that are followed."""
    return _by_name(clips, "stands", kept)


def walking(clips: Sequence[Clip], kept: Path | None = None) -> dict[str, Any]:
    """The same of each straight line, and the distance across it, as the paper measured."""
    return _by_name(clips, "walks", kept)


def _by_name(clips: Sequence[Clip], kind: str, kept: Path | None) -> dict[str, Any]:
    found: dict[str, list[Followed]] = {}
    for clip in clips:
        folder = folder_of(clip, kept)
        followed = follow(floor_truth(folder), run_of(folder, TRACKER).tracks, _RADIUS_M)
        for moment in moments(folder):
            if moment.kind == kind:
                rows = followed.during(moment.start, moment.end, moment.person)
                found.setdefault(moment.name, []).append(rows)
    errors = {
        name: np.concatenate([rows.error_m for rows in several]) for name, several in found.items()
    }
    result: dict[str, Any] = {name: told_of(values) for name, values in errors.items()}
    if kind == "walks":
        for name, several in found.items():
            result[name]["across_cm"] = _mean_cm(
                np.concatenate([_across(rows, name) for rows in several])
            )
    result["all"] = told_of(np.concatenate(list(errors.values())))
    return result


def told_of(error_m: NDArray[np.float64]) -> dict[str, Any]:
    known = error_m[np.isfinite(error_m)]
    return {
        "mean_cm": _mean_cm(error_m),
        "std_cm": float(100 * known.std()) if len(known) else None,
        "followed": len(known) / max(len(error_m), 1),
        "frames": len(error_m),
    }


def _mean_cm(error_m: NDArray[np.float64]) -> float | None:
    known = error_m[np.isfinite(error_m)]
    return float(100 * known.mean()) if len(known) else None


def _across(rows: Followed, name: str) -> NDArray[np.float64]:
    """Distance of what was found from the straight line between two marks."""
    start, end = (np.array(MARKS_M[mark]) for mark in name.split("-"))
    along = (end - start) / np.linalg.norm(end - start)
    return np.abs((rows.found - start) @ np.array([-along[1], along[0]]))

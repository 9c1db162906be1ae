"""`info`: what a recording or a session holds."""

from __future__ import annotations

from pathlib import Path
from typing import Any

from app.cli.destination import is_session
from app.cli.info_lines import lines_of
from app.cli.option_groups import Bare
from app.cli.output import print_json, print_table
from app.cli.recordings import open_with_options
from tracking.formats import people_in_mot
from tracking.geometry.floor_error import (
    FOOT_ERROR_PX,
    LARGE_ERROR_M,
    distance_of_large_errors,
)
from tracking.recording import Recording
from tracking.translation import Message, msg

_FLAT_M = 15.0
"""A camera is low, or looks flat over the floor, where places err much from this near on."""


def run_info(path: Path | None, bare: Bare, *, as_json: bool) -> None:
    """Print it."""
    if path is not None and path.is_file() and is_session(path):
        facts = _of_session(path)
    else:
        with open_with_options(path, bare) as recording:
            facts = _of_recording(recording)
    if as_json:
        print_json(facts)
    else:
        facts.pop("damage", None)  # told on stderr
        print_table(list(lines_of(facts)))


def _of_recording(recording: Recording) -> dict[str, Any]:
    ground = recording.ground
    return {
        "kind": "recording",
        "path": str(recording.path),
        "name": recording.name,
        "frames": recording.frame_count,
        "fps": recording.fps,
        "size": list(recording.size),
        "duration": recording.duration_s,
        "stereo": recording.is_stereo,
        "depth": recording.has_depth,
        "calibrated": recording.calibration is not None,
        "ground": None
        if ground is None
        else {"height": ground.height_m, "tilt": ground.tilt_deg, "roll": ground.roll_deg},
        "region": _region_share(recording),
        "truth_people": _truth_people(recording),
        "tracks": 0,
        "edits": 0,
        "notes": [*recording.notes, *_metre_notes(recording)],
    }


def _region_share(recording: Recording) -> float | None:
    """Share of the left image in which people are looked for; None: all of it."""
    looked_at = recording.looked_at
    return None if looked_at is None else round(float((looked_at > 0).mean()), 4)


def _metre_notes(recording: Recording) -> list[Message]:
    """Where the camera is so low or flat that metres mean little."""
    if recording.view is None:
        return []
    distance_m = distance_of_large_errors(recording.view, recording.looked_at)
    if distance_m is None or distance_m >= _FLAT_M:
        return []
    return [
        msg(
            "warning: the camera is low or looks flat over the floor: from {distance:.1f} m on, "
            "places are off by more than {error:g} m where feet are seen {pixels:g} pixels too "
            "high; count and measure nearer to it, or leave that part out ([region])",
            distance=distance_m,
            error=LARGE_ERROR_M,
            pixels=FOOT_ERROR_PX,
        )
    ]


def _of_session(path: Path) -> dict[str, Any]:
    from tracking.session import describe  # takes longer to import than a recording to open

    facts = describe(path)
    facts["duration"] = facts.pop("duration_s")
    return facts


def _truth_people(recording: Recording) -> int | None:
    """People in the truth beside the recording; None without one."""
    if recording.truth_path is None:
        return None
    return people_in_mot(recording.truth_path)

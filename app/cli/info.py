"""`info`: what a recording or a session holds."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from pathlib import Path
from typing import Any

from app.cli.destination import is_session
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
_LONGEST, _LONGEST_FACT = 60, 4096
"""Letters of a setting, and of a line: the longest path of a file fits."""


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
        print_table([(name, _short(text, _LONGEST_FACT)) for name, text in _rows(facts)])


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


def _rows(facts: Mapping[str, Any]) -> Iterator[tuple[str, str]]:
    """Facts as lines for people: each run and each kind of label has one of its own."""
    for name, value in facts.items():
        if name == "runs":
            for number, run in enumerate(value):
                yield msg("run {number}", number=number), _run(run)
                yield from (
                    (msg("run {number}, note", number=number), note) for note in run["notes"]
                )
        elif name == "labels":
            parts = value["parts"].items()
            yield from (
                (msg("{part} labels", part=part.replace("_", "-")), _shown(said))
                for part, said in parts
            )
            others = (item for item in value.items() if item[0] != "parts")
            yield from ((what.replace("_", " "), _shown(count)) for what, count in others)
        elif name == "size":
            yield name, " x ".join(str(side) for side in value)
        else:
            yield name.replace("_", " "), _shown(value)


def _run(run: Mapping[str, Any]) -> str:
    """How a run was made, in a line."""
    first, end = run["frames"]
    said = [
        run["tracker"],
        msg("frames {first} to {last}", first=first, last=end - 1),
        msg("seed {seed}", seed=run["seed"]),
    ]
    if run["detector"]:
        said.append(
            msg(
                "{origin} detector {detector}",
                origin=run["detector_from"],
                detector=run["detector"],
            )
        )
    said += [
        msg(
            "{count} boxes of {file} ({format}, {fingerprint})",
            count=given["count"],
            file=_short(given["file"]),
            format=given["format"],
            fingerprint=given["fingerprint"][:12],
        )
        for given in run["detections_input"]
    ]
    said += [f"{name} {_short(_shown(value))}" for name, value in run["settings"].items()]
    return ", ".join(said)


def _short(text: str, longest: int = _LONGEST) -> str:
    """Outlines of occluders, as a setting, are longer than anybody reads."""
    return text if len(text) <= longest else f"{text[: longest - 1]}…"


def _shown(value: Any) -> str:
    """A fact as people read it."""
    if value is None:
        return "-"
    if isinstance(value, bool):
        return "yes" if value else "no"
    if isinstance(value, float):
        return f"{value:.6g}"
    if isinstance(value, dict):
        return ", ".join(f"{name} {_shown(part)}" for name, part in value.items())
    if isinstance(value, list):
        return "; ".join(_shown(part) for part in value) or "-"
    return str(value)

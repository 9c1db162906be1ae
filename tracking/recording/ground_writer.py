"""The floor written into a recording.toml that is somebody's own text."""

from __future__ import annotations

import re
from pathlib import Path

from tracking.atomic_output import replace_with
from tracking.errors import OutputError, RecordingError
from tracking.geometry import Ground
from tracking.recording.manifest import MANIFEST_NAME, manifest_text, parse_ground

_DIGITS = 6
"""Micrometres and millionths of a degree: what is found is never surer."""
_TABLE = re.compile(r"^\s*\[ground\]\s*(#.*)?$")
_ANY_TABLE = re.compile(r"^\s*\[")
_KEY = re.compile(r"^\s*(height|tilt|roll|R|t)\s*=")


def write_ground(folder: Path, ground: Ground) -> None:
    """Put the floor into a folder's recording.toml; everything else stays, comments too.

    Raises:
        RecordingError: the manifest cannot be read, or its floor is written in a form that cannot
            be replaced line by line.
        OutputError: the file cannot be written; the old one stays.
    """
    ground = rounded_ground(ground)
    text = manifest_text(folder)
    changed = with_ground(text, ground)
    where = str(folder / MANIFEST_NAME)
    if parse_ground(changed, where) != ground:
        raise RecordingError(
            "{where}: its [ground] is written in a form that cannot be replaced; take it out and "
            "write again",
            where=where,
        )
    try:
        replace_with(folder / MANIFEST_NAME, changed.encode())
    except OutputError as error:
        raise error.advising("choose another folder") from error


def rounded_ground(ground: Ground) -> Ground:
    """The floor as it is written."""
    values = (ground.height_m, ground.tilt_deg, ground.roll_deg)
    return Ground(*(round(float(value), _DIGITS) for value in values))


def with_ground(text: str, ground: Ground) -> str:
    """The manifest's text with this floor."""
    values = (ground.height_m, ground.tilt_deg, ground.roll_deg)
    new = [
        f"{name} = {value!r}"
        for name, value in zip(("height", "tilt", "roll"), values, strict=True)
    ]
    lines = text.rstrip("\n").split("\n")
    begin = next((row for row, line in enumerate(lines) if _TABLE.match(line)), None)
    if begin is None:
        return "\n".join([*lines, "", "[ground]", *new]) + "\n"
    kept, rest = _without_values(lines[begin + 1 :])
    return "\n".join([*lines[: begin + 1], *new, *kept, *rest]) + "\n"


def _without_values(lines: list[str]) -> tuple[list[str], list[str]]:
    """The lines of the table but its values, which may go on over lines, and those after it."""
    kept: list[str] = []
    open_brackets = 0
    for row, line in enumerate(lines):
        if not open_brackets and _ANY_TABLE.match(line):
            return kept, lines[row:]
        if open_brackets or _KEY.match(line):
            code = line.partition("#")[0]
            open_brackets += code.count("[") - code.count("]")
        else:
            kept.append(line)
    return kept, []

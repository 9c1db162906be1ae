"""The footage that trackers are judged by, and what is known of it."""

from __future__ import annotations

from collections.abc import Collection, Iterable, Mapping
from dataclasses import dataclass
from pathlib import Path

import numpy as np

from tests.benchmarks.clips import Clip, folder_of
from tests.benchmarks.command import tell
from tracking.errors import CalibrationError, RecordingError
from tracking.recording import Recording, open_recording
from tracking.trackers import TRACKERS, require
from tracking.tracks import CountingLine

Box = tuple[int, int, int, int]

REAL = "real"
OTHER_RENDERER = "rendered by others"
OWN = "our own scenes"

_NAMED = {
    REAL: (
        *("towncentre-real", "pets-s2l1-real", "tud-campus-real"),
        *("office-camera0-real", "office-camera2-real", "overhead-real"),
    ),
    OTHER_RENDERER: tuple(
        f"rendered-{scene}" for scene in ("corridor", "lobby", "pillars", "ceiling", "plaza")
    ),
}
_OWN = {
    f"own-{scene}": Clip(scene, 6001, 15.0)
    for scene in ("lobby", "plaza", "square", "uniforms", "pillars", "corridor", "ceiling")
}
"""Of a seed for choosing settings."""

BY_EYE: Mapping[str, Mapping[int, tuple[Box, ...]]] = {
    "office-camera0-real": {
        60: ((444, 26, 526, 264), (548, 48, 632, 288)),
        110: ((420, 35, 500, 230), (407, 76, 524, 400)),
        160: ((472, 43, 558, 281), (320, 108, 428, 411)),
        210: ((444, 35, 511, 264), (253, 119, 372, 405)),
        260: ((552, 17, 628, 227), (478, 63, 563, 314)),
    },
    "office-camera2-real": {
        60: ((476, 199, 617, 725), (444, 91, 552, 335)),
        110: ((541, 199, 730, 697), (797, 32, 946, 416)),
        160: ((530, 141, 714, 643), (903, 69, 1072, 440)),
        210: ((520, 201, 678, 697), (974, 82, 1169, 481)),
        260: ((22, 227, 325, 704), (563, 95, 745, 554)),
    },
}
"""People who walk, by frame: left, top, right, bottom in px, drawn by eye where nobody labelled."""

_SHORT = 100
"""Frames below which a recording is short."""

_LINES = {
    "rendered-corridor": CountingLine("y = 6 m", (3.0, 6.0), (-3.0, 6.0)),
    "overhead-real": CountingLine("below the camera", (0.0, -3.0), (0.0, 3.0)),
}


@dataclass(frozen=True, slots=True)
class Footage:
    """One recording.

    Attributes:
        name: in tables.
        kind: `REAL`, `OTHER_RENDERER` or `OWN`.
        folder: the recording's.
    """

    name: str
    kind: str
    folder: Path

    @property
    def labelled(self) -> bool:
        """Whether ground truth lies beside it."""
        return (self.folder / "truth.txt").is_file()

    @property
    def is_short(self) -> bool:
        """Whether so little happens in it that one run says little."""
        with self.open() as recording:
            return recording.frame_count < _SHORT

    def open(self) -> Recording:
        """The recording, to be closed by the caller."""
        return open_recording(self.folder)

    def suits(self, tracker: str) -> bool:
        """Whether the recording has what the tracker needs: cameras, calibration, floor."""
        with self.open() as recording:
            try:
                require(TRACKERS[tracker], recording)
            except (RecordingError, CalibrationError):
                return False
            return True


def all_footage(
    data: Path, only: Collection[str] | None = None, kept: Path | None = None
) -> list[Footage]:
    """What there is; recordings that are missing from the folder of data are told.

    Args:
        data: where those are that are not ours.
        only: names; None: all.
        kept: where our own are kept, None: in the user's cache.
    """
    found = []
    for name in footage_names():
        if only is not None and name not in only:
            continue
        if name in _OWN:
            found.append(Footage(name, OWN, folder_of(_OWN[name], kept)))
        elif (data / name / "recording.toml").is_file():
            kind = REAL if name in _NAMED[REAL] else OTHER_RENDERER
            found.append(Footage(name, kind, data / name))
        else:
            tell(f"no {name} in {data.name} (--data or TRACKWRIGHT_DATA): it is left out")
    return found


def footage_names() -> list[str]:
    """Of all that is looked for."""
    return [*(name for names in _NAMED.values() for name in names), *_OWN]


def counting_line(footage: Footage, places: Iterable[tuple[float, float]]) -> CountingLine:
    """The line on the floor over which passages are counted.

    Args:
        places: (n, 2) true x, y in metres; the line goes through the middle of them, across the
            camera's direction, where nobody has chosen one.
    """
    if footage.name in _LINES:
        return _LINES[footage.name]
    known = np.array([*places], float).reshape(-1, 2)
    y, (left, right) = float(np.median(known[:, 1])), np.quantile(known[:, 0], (0.0, 1.0))
    return CountingLine(f"y = {y:.1f} m", (float(right) + 2.0, y), (float(left) - 2.0, y))

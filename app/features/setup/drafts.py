"""What was entered in a set-up, kept outside the recording until that is written."""

from __future__ import annotations

import hashlib
import json
from collections.abc import Mapping
from dataclasses import asdict
from pathlib import Path
from threading import Lock
from typing import Any, get_args

from app.core.document.document_loader import own_folder
from app.features.setup.scene import (
    BoardForm,
    CalibrationMethod,
    FloorMethod,
    RoughForm,
    SetupState,
)
from tracking.atomic_output import replace_with
from tracking.calibration.boards import BOARD_KINDS
from tracking.calibration.floor import FloorPoint
from tracking.errors import TrackwrightError
from tracking.geometry import Ground, StereoCalibration
from tracking.geometry.calibration_writer import format_calibration
from tracking.owned_files import make_folder, read_file
from tracking.recording.depth_pictures import checked_scale
from tracking.recording.image_pairs import LAYOUTS
from tracking.recording.region_of_interest import RegionOfInterest, outlines_of
from tracking.setup import SetupPlan
from tracking.tracks import CountingLine, Occluder

_MOST_BYTES = 512 * 1024
_KEPT = 20
_MOST_POINTS = 200
_FORMAT = 2


class Drafts:
    """The set-ups that were begun and not written, a file each."""

    def __init__(self, folder: Path | None = None) -> None:
        self._folder = own_folder() / "setups" if folder is None else folder
        self._written: set[Path] = set()
        self._forgotten: set[Path] = set()
        self._lock = Lock()

    def save(self, state: SetupState) -> None:
        """Keep what was entered; nothing where there are no cameras yet. Raises OutputError."""
        if state.plan is None:
            return
        make_folder(self._folder.parent)
        make_folder(self._folder)
        text = json.dumps({"format": _FORMAT, **_plain(asdict(state))}, indent=1)
        with self._lock:
            if self._file(state.plan) in self._written:
                return
            replace_with(self._file(state.plan), text.encode())
        for old in self._files()[_KEPT:]:
            self._remove(old)

    def find(self, plan: SetupPlan) -> SetupState | None:
        """What was entered for these cameras; None: nothing, or it cannot be read."""
        return self._read(self._file(plan))

    def latest(self) -> SetupState | None:
        """The set-up that was interrupted last, whose cameras are still there; None: none."""
        for file in self._files():
            state = self._read(file)
            if state is not None and state.plan is not None and state.plan.left.exists():
                return state
        return None

    def forget(self, plan: SetupPlan, *, for_good: bool = False) -> None:
        """It is to begin anew; `for_good`: it was written, and saving that is late is left out.

        As that may be undone, its calibrations stay until `close`.
        """
        file = self._file(plan)
        with self._lock:
            if for_good:
                self._written.add(file)
                self._remove(file)
                return
            self._forgotten.add(file)
            file.unlink(missing_ok=True)

    def close(self) -> None:
        """Nothing is undone any more: let calibrations go that no draft names. Raises OSError."""
        drafts = [self._read(file) for file in self._files()] if self._forgotten else []
        plans = [draft.plan for draft in drafts if draft is not None and draft.plan is not None]
        named = {file for plan in plans for file in plan.calibration}
        while self._forgotten:
            for file in self._calibrations(self._forgotten.pop()):
                if file not in named:
                    file.unlink(missing_ok=True)

    def keep_calibration(self, plan: SetupPlan, calibration: StereoCalibration) -> Path:
        """Put a calibration that was made into a file of its own; its path. Raises OutputError."""
        make_folder(self._folder.parent)
        make_folder(self._folder)
        text = format_calibration(calibration)
        name = hashlib.sha256(text.encode()).hexdigest()[:12]
        path = self._folder / f"{self._file(plan).stem}-{name}.yaml"
        replace_with(path, text.encode())
        return path

    def _file(self, plan: SetupPlan) -> Path:
        files = sorted(str(one.absolute()) for one in (plan.left, plan.right) if one is not None)
        key = hashlib.sha256("\n".join([str(plan.at or ""), *files]).encode()).hexdigest()[:16]
        return self._folder / f"{key}.json"

    def _files(self) -> list[Path]:
        """The latest first."""
        if not self._folder.is_dir():
            return []
        files = [file for file in self._folder.glob("*.json") if file.is_file()]
        return sorted(files, key=lambda file: file.stat().st_mtime, reverse=True)

    def _remove(self, file: Path) -> None:
        for one in (file, *self._calibrations(file)):
            one.unlink(missing_ok=True)

    def _calibrations(self, file: Path) -> list[Path]:
        """Those that were made for a draft."""
        return list(self._folder.glob(f"{file.stem}-*.yaml"))

    def _read(self, file: Path) -> SetupState | None:
        if not file.is_file():
            return None
        try:
            values = json.loads(read_file(file, _MOST_BYTES))
            return _state(values) if values.get("format") == _FORMAT else None
        except (TrackwrightError, OSError, ValueError, TypeError, KeyError, AttributeError):
            return None  # damaged, or of another version: the set-up begins anew
        except RecursionError:
            return None


def _plain(value: Any) -> Any:
    """As JSON takes it."""
    if isinstance(value, Path):
        return str(value)
    if isinstance(value, Mapping):
        return {name: _plain(one) for name, one in value.items()}
    if isinstance(value, frozenset):
        return sorted(value)
    if isinstance(value, tuple | list):
        return [_plain(one) for one in value]
    return value


def _state(values: Mapping[str, Any]) -> SetupState:
    """The state; ValueError, TypeError and KeyError where it is none."""
    left_out = values["left_out"]
    pose = values["pose_file"]
    return SetupState(
        plan=_plan(values["plan"]),
        by_hand=frozenset(_texts(values["by_hand"])),
        found=_texts(values["found"]),
        doubts=_texts(values["doubts"]),
        found_lag=None if values["found_lag"] is None else int(values["found_lag"]),
        calibration_method=_one_of(values["calibration_method"], get_args(CalibrationMethod)),
        calibration_told=str(values["calibration_told"]),
        board=_board(values["board"]),
        rough=RoughForm(float(values["rough"]["fov_deg"]), float(values["rough"]["baseline_mm"])),
        left_out=None if left_out is None else frozenset(_texts(left_out)),
        floor_method=_one_of(values["floor_method"], get_args(FloorMethod)),
        floor_told=str(values["floor_told"]),
        floor_doubt=str(values["floor_doubt"]),
        points=tuple(
            FloorPoint(*(float(point[name]) for name in ("u", "v", "x_m", "y_m")))
            for point in values["points"][:_MOST_POINTS]
        ),
        distances=tuple(
            (int(one), int(other), float(metres)) for one, other, metres in values["distances"]
        ),
        pose_file=None if pose is None else Path(str(pose)),
        convention=str(values["convention"]),
        occluders=tuple(
            Occluder(str(one["name"]), _corners(one["polygon"])) for one in values["occluders"]
        ),
        lines=tuple(
            CountingLine(str(one["name"]), *_ends(one), in_picture=True) for one in values["lines"]
        ),
    )


def _plan(values: Mapping[str, Any]) -> SetupPlan:
    ground = values["ground"]
    look, mask = (outlines_of(values["region"][kind]) for kind in ("look", "mask"))
    if not isinstance(look, tuple) or not isinstance(mask, tuple):
        raise ValueError("no outlines")
    layout = values["layout"]
    return SetupPlan(
        left=Path(values["left"]),
        right=None if values["right"] is None else Path(values["right"]),
        name=str(values["name"]),
        layout=None if layout is None else _one_of(layout, LAYOUTS),
        first=_one_of(values["first"], ("left", "right")),
        lag=None if values["lag"] is None else int(values["lag"]),
        fps=None if values["fps"] is None else float(values["fps"]),
        calibration=tuple(Path(file) for file in _texts(values["calibration"])),
        ground=None
        if ground is None
        else Ground(*(float(ground[name]) for name in ("height_m", "tilt_deg", "roll_deg"))),
        region=RegionOfInterest(look, mask),
        depth=None if values["depth"] is None else Path(values["depth"]),
        depth_scale_m=checked_scale(float(values["depth_scale_m"]), "depth"),
        topics=_topics(values["topics"]),
        at=None if values["at"] is None else Path(values["at"]),
    )


def _board(values: Mapping[str, Any]) -> BoardForm:
    return BoardForm(
        str(values["left"]),
        str(values["right"]),
        _one_of(values["kind"], BOARD_KINDS),
        int(values["columns"]),
        int(values["rows"]),
        float(values["square_mm"]),
        _one_of(values["lens"], ("standard", "fisheye")),
    )


def _corners(values: Any) -> tuple[tuple[float, float], ...]:
    return tuple((float(x), float(y)) for x, y in values)


def _ends(values: Any) -> tuple[tuple[float, float], tuple[float, float]]:
    start, end = _corners((values["start"], values["end"]))
    return start, end


def _texts(values: Any) -> tuple[str, ...]:
    if not isinstance(values, list) or not all(isinstance(one, str) for one in values):
        raise ValueError("no texts")
    return tuple(values)


def _topics(values: Any) -> tuple[str, str, str]:
    left, right, depth = _texts(values)
    return left, right, depth


def _one_of(value: Any, known: tuple[Any, ...]) -> Any:
    if value not in known:
        raise ValueError("not known")
    return value

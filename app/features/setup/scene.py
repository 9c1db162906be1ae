"""What the set-up shows: what was entered, what was found of it, and the picture of each step."""

from __future__ import annotations

from dataclasses import dataclass, field
from enum import StrEnum
from pathlib import Path
from typing import Literal

import numpy as np

from tracking.arrays import Floats
from tracking.calibration.boards import BoardCalibration, BoardKind, LensKind
from tracking.calibration.floor import FloorPoint
from tracking.geometry import StereoCalibration
from tracking.recording.frame import Image
from tracking.recording.region_of_interest import Outline
from tracking.setup import SetupPlan
from tracking.tracks import CountingLine, Occluder

Arrangement = Literal[
    "pair", "one", "side-by-side", "top-bottom", "row-interleaved", "frame-sequential"
]
CalibrationMethod = Literal["file", "board", "rough"]
FloorMethod = Literal["measured", "typed", "points", "distances", "board", "pose"]
Shown = Literal["cameras", "rectified", "coverage"]
OutlineKind = Literal["look", "mask", "occluder", "line"]
"""Of the first two recording.toml tells, of the others the session."""
MOST_ROWS_APART_PX = 1.0
"""Rows of the same point in a rectified pair whose calibration fits lie no farther apart."""
Distance = tuple[int, int, float]
"""Numbers of two points, from 0, and metres between them."""


class Step(StrEnum):
    """The steps, in their order."""

    CAMERAS = "cameras"
    CALIBRATION = "calibration"
    FLOOR = "floor"
    REGION = "region"
    WRITE = "write"


class Mark(StrEnum):
    """How a step stands."""

    OPEN = "open"
    DONE = "done"
    WARNING = "warning"


@dataclass(frozen=True, slots=True)
class BoardForm:
    """What was entered of a board. Attributes: square_mm: 0 where it was not given."""

    left: str = ""
    right: str = ""
    kind: BoardKind = "chessboard"
    columns: int = 9
    rows: int = 6
    square_mm: float = 0.0
    lens: LensKind = "standard"


@dataclass(frozen=True, slots=True)
class RoughForm:
    """What was entered for a rough calibration. Attributes: baseline_mm: 0 where not given."""

    fov_deg: float = 65.0
    baseline_mm: float = 0.0


@dataclass(frozen=True, slots=True)
class SetupState:
    """All that was entered or taken; every change of it can be undone, and it is saved as it goes.

    Attributes:
        plan: what will be written; None: no cameras yet.
        by_hand: of "files", "left", "arrangement", "lag", those that a person set.
        found, doubts: what the images tell of the cameras, in words.
        found_lag: frames by which the right camera is late; None: not told by the images.
        calibration_method, floor_method: the form that is shown.
        calibration_told: how the calibration was made, in words; "" for a file.
        left_out: names of pictures of boards that a person left out; None: the program chose.
        floor_told: how the floor was found; floor_doubt: what is odd about it.
        points: clicked on the floor; distances: between them.
        pose_file, convention: of a pose.
        occluders, lines: drawn on the left image, in px, to be kept in a session.
    """

    plan: SetupPlan | None = None
    by_hand: frozenset[str] = frozenset()
    found: tuple[str, ...] = ()
    doubts: tuple[str, ...] = ()
    found_lag: int | None = None
    calibration_method: CalibrationMethod = "file"
    calibration_told: str = ""
    board: BoardForm = BoardForm()
    rough: RoughForm = RoughForm()
    left_out: frozenset[str] | None = None
    floor_method: FloorMethod = "measured"
    floor_told: str = ""
    floor_doubt: str = ""
    points: tuple[FloorPoint, ...] = ()
    distances: tuple[Distance, ...] = ()
    pose_file: Path | None = None
    convention: str = ""
    occluders: tuple[Occluder, ...] = ()
    lines: tuple[CountingLine, ...] = ()


@dataclass(frozen=True, slots=True)
class DrawnOutline:
    """What was drawn. Attributes: corners: px; of a line its ends. name: "" where it has none."""

    kind: OutlineKind
    corners: Outline
    name: str = ""


@dataclass(frozen=True, slots=True, eq=False)
class CameraImages:
    """Images of one instant. Attributes: right: None for one camera. number: of the left image."""

    left: Image
    right: Image | None
    number: int
    frame_count: int


@dataclass(frozen=True, slots=True, eq=False)
class Checked:
    """A plan that was opened as a trial.

    Attributes:
        plan: the one. problem: why it cannot be used; "" where it can. step: where the problem is.
        calibration: as read, in the size of the images; None: none, or not readable.
        read, missing: what the calibration holds and lacks, in words.
        text: recording.toml as it would be. places: which files would be written, in words.
        replaces: a recording.toml is there already.
    """

    plan: SetupPlan | None = None
    problem: str = ""
    step: Step = Step.CAMERAS
    calibration: StereoCalibration | None = None
    read: tuple[str, ...] = ()
    missing: tuple[str, ...] = ()
    text: str = ""
    places: str = ""
    replaces: bool = False


@dataclass(frozen=True, slots=True, eq=False)
class SetupScene:
    """What is shown now.

    Attributes:
        boards: the calibration by boards, where one was made.
        doing: the long work that runs, in words; "": none.
        problems: what failed, beside the step it is of.
        row_error: how far the rows of a point are apart in the rectified pair, px, and in which
            calibration files; None: not looked at.
    """

    state: SetupState = SetupState()
    checked: Checked = Checked()
    images: CameraImages | None = None
    boards: BoardCalibration | None = None
    doing: str = ""
    problems: dict[Step, str] = field(default_factory=dict)
    row_error: tuple[tuple[Path, ...], float] | None = None

    @property
    def misfit_px(self) -> float | None:
        """How far rows are apart where that says the calibration does not fit; None: it may."""
        plan = self.state.plan
        if plan is None or self.row_error is None or self.row_error[0] != plan.calibration:
            return None
        return self.row_error[1] if self.row_error[1] > MOST_ROWS_APART_PX else None

    @property
    def busy(self) -> bool:
        """Whether long work runs."""
        return bool(self.doing)


@dataclass(frozen=True, slots=True, eq=False)
class ShownOutline:
    """A polygon or a line on the picture, (n, 2) px.

    Attributes:
        closed: it is whole, and not being drawn.
        arrow: (2, 2) px, which way over a line is forward; (0, 2): none.
    """

    corners: Floats
    kind: OutlineKind
    chosen: bool = False
    closed: bool = True
    arrow: Floats = field(default_factory=lambda: np.zeros((0, 2)))


@dataclass(frozen=True, slots=True, eq=False)
class SetupPicture:
    """The picture of a step.

    Attributes:
        image: (height, width, 3) BGR; None: nothing yet. titles: (x, text) along the upper edge.
        grid, horizon: lines (n, 2) px on it. figure: (left, top, width, height) of somebody.
        floor_size: (width, height) px of the image's part, from its corner, that they are of.
        points: (n, 2) px, numbered. outlines: polygons. handle: the chosen one of `handles`.
        said: for screen readers, and where there is no image.
    """

    image: Image | None = None
    titles: tuple[tuple[float, str], ...] = ()
    grid: tuple[Floats, ...] = ()
    horizon: Floats | None = None
    figure: tuple[float, float, float, float] | None = None
    floor_size: tuple[float, float] = (0.0, 0.0)
    points: Floats = field(default_factory=lambda: np.zeros((0, 2)))
    outlines: tuple[ShownOutline, ...] = ()
    handle: int = -1
    said: str = ""

    @property
    def handles(self) -> Floats:
        """(n, 2) px that can be dragged: points, then corners of the outlines in their order."""
        corners = [outline.corners.reshape(-1, 2) for outline in self.outlines]
        return np.concatenate([self.points.reshape(-1, 2), *corners])

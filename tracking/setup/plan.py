"""What a recording is to be made of, and the recording.toml that says so."""

from __future__ import annotations

import os
from dataclasses import dataclass, replace
from pathlib import Path

from tracking.atomic_output import replace_with
from tracking.errors import OutputError, RecordingError
from tracking.geometry import Ground
from tracking.recording.depth_pictures import USUAL_SCALE_M
from tracking.recording.image_pairs import Layout, Side
from tracking.recording.manifest import MANIFEST_NAME, Manifest, format_manifest, read_manifest
from tracking.recording.region_of_interest import EVERYWHERE, RegionOfInterest

_HEADINGS = {
    "[left]": "# The left camera, or the only one.",
    "[right]": "# The right camera. lag: frames by which it is late.",
    "[depth]": "# In place of a right camera: an image of 16 bits for each frame; m per unit.",
    "[stereo]": "# One video that holds both cameras.",
    "[calibration]": "# The cameras' lenses, and how they stand to each other.",
    "[ground]": "# The left camera over the floor, m and degrees; tilt 90 looks straight down.",
    "[region]": "# Where people are looked for, in px of the left image.",
}


@dataclass(frozen=True, slots=True)
class SetupPlan:
    """A recording to be.

    Attributes:
        name: for people; "": the folder's. left, right: sources; right None: one camera, or both.
        layout, first: of one source that holds both cameras. lag: frames; None: not told.
        fps: None: as the video says. calibration: one file, or a pair. ground: None: unknown.
        region: where people are looked for.
        depth: in place of a right camera, m per unit `depth_scale_m`. topics: of bags.
    """

    left: Path
    right: Path | None = None
    name: str = ""
    layout: Layout | None = None
    first: Side = "left"
    lag: int | None = None
    fps: float | None = None
    calibration: tuple[Path, ...] = ()
    ground: Ground | None = None
    region: RegionOfInterest = EVERYWHERE
    depth: Path | None = None
    depth_scale_m: float = USUAL_SCALE_M
    topics: tuple[str, str, str] = ("", "", "")

    @property
    def folder(self) -> Path:
        """Where recording.toml goes: the folder that all files share.

        Raises:
            RecordingError: they share none, but the root.
        """
        files = [self.left, *([self.right] if self.right else []), *self.calibration]
        parents = [file.parent.absolute() for file in files]
        common = Path(os.path.commonpath(parents))
        if common == Path(common.anchor) and len(set(parents)) > 1:
            raise RecordingError(
                "{left} and the other files share no folder; put them into one", left=self.left
            )
        return common


def plan_of(folder: Path) -> SetupPlan:
    """The plan of a recording that has a recording.toml; RecordingError where it cannot be read."""
    manifest = read_manifest(folder)
    return SetupPlan(
        left=folder / manifest.left,
        right=folder / manifest.right if manifest.right else None,
        name=manifest.name,
        layout=manifest.layout,
        first=manifest.first,
        lag=manifest.right_lag,
        fps=manifest.fps,
        calibration=tuple(folder / file for file in manifest.calibration),
        ground=manifest.ground,
        region=manifest.region,
        depth=folder / manifest.depth if manifest.depth else None,
        depth_scale_m=manifest.depth_scale_m,
        topics=manifest.topics,
    )


def manifest_of(plan: SetupPlan) -> Manifest:
    """The manifest of a plan, its paths relative to the plan's folder."""
    folder = plan.folder

    def relative(path: Path) -> str:
        return Path(os.path.relpath(path.absolute(), folder)).as_posix()

    ground = plan.ground
    if ground is not None:
        values = (ground.height_m, ground.tilt_deg, ground.roll_deg)
        ground = Ground(*(round(float(value), 4) for value in values))
    return Manifest(
        name=plan.name or folder.name,
        left=relative(plan.left),
        right=relative(plan.right) if plan.right else None,
        layout=plan.layout,
        first=plan.first,
        right_lag=plan.lag,
        fps=plan.fps,
        calibration=tuple(relative(file) for file in plan.calibration),
        ground=ground,
        region=plan.region,
        depth=relative(plan.depth) if plan.depth else None,
        depth_scale_m=plan.depth_scale_m,
        topics=plan.topics,
    )


def setup_text(plan: SetupPlan) -> str:
    """The text of recording.toml, with a comment over each table."""
    lines = ["# Made by trackwright setup; change it by hand as you like."]
    for line in format_manifest(manifest_of(plan)).splitlines():
        lines += [_HEADINGS[line], line] if line in _HEADINGS else [line]
    return "\n".join(lines) + "\n"


def write_setup(plan: SetupPlan, *, replace_old: bool = False) -> Path:
    """Write recording.toml beside the sources, whole or not at all; its path.

    Raises:
        RecordingError: there is one already, and it is not to be replaced.
        OutputError: it cannot be written.
    """
    path = plan.folder / MANIFEST_NAME
    if path.exists() and not replace_old:
        raise RecordingError(
            "{path} exists; open that recording, or replace it", option="--force", path=path
        )
    if path.is_symlink() or (path.exists() and not path.is_file()):
        raise RecordingError("{path} is no plain file; move it away", path=path)
    try:
        replace_with(path, setup_text(plan).encode())
    except OutputError as error:
        raise error.advising("choose another folder") from error
    return path


def with_lag(plan: SetupPlan, lag: int | None) -> SetupPlan:
    """The plan with the lag that was found; none is not worth a line."""
    return replace(plan, lag=lag or None)

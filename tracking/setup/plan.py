"""What a recording is to be made of, and the recording.toml that says so."""

from __future__ import annotations

import os
from dataclasses import dataclass, replace
from pathlib import Path

from tracking.atomic_output import replace_with
from tracking.errors import OutputError, RecordingError, TrackwrightError
from tracking.geometry import Ground, read_calibration
from tracking.geometry.calibration_writer import format_calibration
from tracking.recording.depth_pictures import USUAL_SCALE_M
from tracking.recording.image_pairs import Layout, Side
from tracking.recording.kinds.catalogue import find_sources
from tracking.recording.limits import height_doubt
from tracking.recording.manifest import (
    MANIFEST_NAME,
    Manifest,
    manifest_text,
    names_sources,
    parse_manifest,
)
from tracking.recording.manifest_writer import format_manifest
from tracking.recording.options import OpenOptions
from tracking.recording.recording_loader import open_recording
from tracking.recording.region_of_interest import EVERYWHERE, RegionOfInterest
from tracking.setup.files import is_container
from tracking.setup.kept_text import with_old_text
from tracking.translation import Message, msg

CALIBRATION_NAME = "calibration.yaml"
_MOST_NAMES = 100
_BACKUP = ".bak"
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
        at: folder of the recording that is set up again, or known without recording.toml; None: a
            new one beside the sources.
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
    at: Path | None = None

    @property
    def is_stereo(self) -> bool:
        """Whether there are two cameras."""
        return self.right is not None or self.layout is not None

    @property
    def folder(self) -> Path:
        """Where recording.toml goes: the folder that the cameras' files share.

        Raises:
            RecordingError: they share none, but the root.
        """
        if self.at is not None:
            return self.at
        files = (self.left, self.right, self.depth)
        parents = {_absolute(file).parent for file in files if file is not None}
        try:
            common = Path(os.path.commonpath(parents))
        except ValueError:  # on two drives
            common = Path(next(iter(parents)).anchor)
        if common == Path(common.anchor) and len(parents) > 1:
            raise RecordingError(
                "{left} and the other files share no folder; put them into one", left=self.left
            )
        return common

    @property
    def notes(self) -> tuple[Message, ...]:
        """What is odd about the floor and where the files lie, in words."""
        files = (self.left, self.right, self.depth)
        parents = {_absolute(file).parent for file in files if file is not None}
        doubt = None if self.ground is None else height_doubt(self.ground)
        notes = () if doubt is None else (doubt,)
        if self.at is not None or len(parents) == 1:
            return notes
        return (
            *notes,
            msg(
                "the files lie in {count} folders: recording.toml stands in {folder}, which holds "
                "them all",
                count=len(parents),
                folder=self.folder,
            ),
        )

    @property
    def calibration_file(self) -> Path | None:
        """Where a calibration from elsewhere is to be written; None: it lies in the folder.

        A file there that holds the same is written again. Another calibration stays as it is: the
        recording.toml that is kept as a backup may name it.

        Raises:
            RecordingError: all names are taken, or the files share no folder.
        """
        folder = self.folder
        if all(_absolute(file).is_relative_to(_absolute(folder)) for file in self.calibration):
            return None
        names = (f"calibration-{number}.yaml" for number in range(2, _MOST_NAMES))
        places = [folder / CALIBRATION_NAME, *(folder / name for name in names)]
        if not _is_there(places[0]):
            return places[0]
        text = self._calibration_text()
        for place in places:
            if not _is_there(place) or (text is not None and _holds(place, text)):
                return place
        raise RecordingError(
            "{folder}: {count} calibrations lie there already; take some of them away",
            folder=folder,
            count=len(places),
        )

    def _calibration_text(self) -> str | None:
        """The calibration as it would be written; None where it cannot be read."""
        try:
            return format_calibration(read_calibration(self.calibration, image_size(self)))
        except (TrackwrightError, OSError):
            return None


def _holds(place: Path, text: str) -> bool:
    """Whether a plain file holds this text and nothing else."""
    held = text.encode()
    try:
        if place.is_symlink() or not place.is_file() or place.stat().st_size != len(held):
            return False
        return place.read_bytes() == held
    except OSError:
        return False


def plan_of(folder: Path) -> SetupPlan:
    """The plan of a recording that has a recording.toml; RecordingError where it cannot be read."""
    return plan_from_manifest(folder, manifest_text(folder), own=True)


def plan_of_known(path: Path, options: OpenOptions | None = None) -> SetupPlan | None:
    """The plan of what can be opened already; None: nothing there says what its cameras are.

    That are recordings, bags, tars, and folders of other programs (EuRoC, KITTI, OAK, ZED). Of a
    folder recording.toml is written into itself, over one that names no sources.

    Raises:
        RecordingError: it is one of these, and cannot be read.
    """
    if not path.is_dir():
        return plan_of_container(path, options) if is_container(path) else None
    where = path / MANIFEST_NAME
    own = where.is_file()
    if own and names_sources(manifest_text(path), str(where)):
        return plan_of(path)
    if is_container(path) or find_sources(path) is not None:
        return replace(plan_of_container(path, options), at=path)
    return plan_of(path) if own else None  # says what is missing


def plan_of_container(path: Path, options: OpenOptions | None = None) -> SetupPlan:
    """The plan of a bag, a tar or a known folder as it says itself what its cameras are.

    Raises:
        RecordingError: it cannot be opened.
    """
    with open_recording(path, options) as recording:
        return plan_from_manifest(recording.folder, recording.manifest_text, own=False)


def plan_from_manifest(folder: Path, text: str, *, own: bool) -> SetupPlan:
    """The plan of a recording whose manifest has this text.

    Args:
        folder: what its paths are relative to. own: it is the folder's recording.toml, which is
            to be replaced; else one is written beside the cameras' files.
    """
    manifest = parse_manifest(text, str(folder / MANIFEST_NAME), folder.resolve().name)
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
        at=folder if own else None,
    )


def options_of_plan(plan: SetupPlan) -> OpenOptions:
    """The plan as options that open its recording before anything is written."""
    ground = plan.ground
    return OpenOptions(
        left=plan.left,
        right=plan.right,
        depth=plan.depth,
        depth_scale_m=plan.depth_scale_m,
        topics=plan.topics,
        calibration=plan.calibration,
        height_m=ground.height_m if ground else None,
        tilt_deg=ground.tilt_deg if ground else None,
        roll_deg=ground.roll_deg if ground else None,
        fps=plan.fps,
        layout=plan.layout,
        first=plan.first if plan.layout else None,
        right_lag=plan.lag if plan.is_stereo else None,
        look=plan.region.look,
        mask=plan.region.mask,
    )


def manifest_of(plan: SetupPlan) -> Manifest:
    """The manifest of a plan, its paths relative to the plan's folder."""
    folder = plan.folder

    def relative(path: Path) -> str:
        return Path(os.path.relpath(_absolute(path), _absolute(folder))).as_posix()

    ground = plan.ground
    if ground is not None:
        values = (ground.height_m, ground.tilt_deg, ground.roll_deg)
        ground = Ground(*(round(float(value), 4) for value in values))
    written = plan.calibration_file
    return Manifest(
        name=plan.name or folder.absolute().name,
        left=relative(plan.left),
        right=relative(plan.right) if plan.right else None,
        layout=plan.layout,
        first=plan.first,
        right_lag=plan.lag,
        fps=plan.fps,
        calibration=tuple(map(relative, plan.calibration if written is None else (written,))),
        ground=ground,
        region=plan.region,
        depth=relative(plan.depth) if plan.depth else None,
        depth_scale_m=plan.depth_scale_m,
        topics=plan.topics,
    )


def setup_text(plan: SetupPlan) -> str:
    """The text of recording.toml, with a comment over each table.

    Where the folder has one, its comments and what of it means nothing here are kept, unless that
    text would not say what the plan says.

    Raises:
        RecordingError: the files share no folder, the old recording.toml cannot be read, or no
            name is free for the calibration.
    """
    folder = plan.folder
    text = format_manifest(manifest_of(plan))
    if plan.at is not None and (folder / MANIFEST_NAME).is_file():
        kept = with_old_text(text, manifest_text(folder), _HEADINGS)
        if _says_the_same(kept, text):
            return kept
    lines = ["# Made by trackwright setup; change it by hand as you like."]
    for line in text.splitlines():
        lines += [_HEADINGS[line], line] if line in _HEADINGS else [line]
    return "\n".join(lines) + "\n"


def _says_the_same(text: str, other: str) -> bool:
    """Whether a text reads as the other one does, but for what means nothing here."""
    try:
        one = parse_manifest(text, MANIFEST_NAME, "")
    except RecordingError:
        return False
    return replace(one, unknown=()) == parse_manifest(other, MANIFEST_NAME, "")


def write_setup(plan: SetupPlan, *, replace_old: bool = False) -> Path:
    """Write recording.toml beside the sources, whole or not at all; its path.

    A calibration from elsewhere is written beside it as OpenCV's YAML; a recording.toml that is
    replaced is kept as recording.toml.bak.

    Raises:
        RecordingError: there is one already, and it is not to be replaced.
        CalibrationError: the calibration cannot be read.
        OutputError: it cannot be written.
    """
    path = plan.folder / MANIFEST_NAME
    if path.exists() and not replace_old:
        raise RecordingError(
            "{path} exists; open that recording, or replace it", option="--force", path=path
        )
    if path.is_symlink() or (path.exists() and not path.is_file()):
        raise RecordingError("{path} is no plain file; move it away", path=path)
    text = setup_text(plan)
    copied = plan.calibration_file
    try:
        if path.exists():
            replace_with(path.with_name(path.name + _BACKUP), path.read_bytes())
        if copied is not None:
            calibration = read_calibration(plan.calibration, image_size(plan))
            replace_with(copied, format_calibration(calibration).encode())
        replace_with(path, text.encode())
    except OutputError as error:
        raise error.advising("choose another folder") from error
    return path


def image_size(plan: SetupPlan) -> tuple[int, int]:
    """Width and height in px of one camera's images; RecordingError for unreadable ones."""
    bare = replace(plan, calibration=(), ground=None, region=EVERYWHERE)
    with open_recording(plan.folder, options_of_plan(bare)) as recording:
        return recording.size


def with_lag(plan: SetupPlan, lag: int | None) -> SetupPlan:
    """The plan with the lag that was found; none is not worth a line."""
    return replace(plan, lag=lag or None)


def _absolute(path: Path) -> Path:
    """Without steps back, but links as they are: names say where a recording's files belong."""
    return Path(os.path.abspath(path))  # noqa: PTH100 - links stay


def _is_there(path: Path) -> bool:
    return path.exists() or path.is_symlink()

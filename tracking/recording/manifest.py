"""recording.toml: what a recording folder holds."""

from __future__ import annotations

from dataclasses import dataclass, replace
from pathlib import Path, PurePath
from typing import TypeVar

import numpy as np

from tracking.errors import CalibrationError, RecordingError
from tracking.geometry import Ground, ground_of_pose
from tracking.recording.depth_pictures import USUAL_SCALE_M, checked_scale
from tracking.recording.image_pairs import LAYOUTS, MOST_LAG, Layout, Side
from tracking.recording.limits import checked_fps, checked_ground
from tracking.recording.manifest_table import ManifestTable, read_toml, unknown_keys
from tracking.recording.region_of_interest import EVERYWHERE, Outline, RegionOfInterest, outlines_of
from tracking.translation import joined, msg

MANIFEST_NAME = "recording.toml"
TRUTH_NAME = "truth.txt"
"""MOT text of the ground truth beside it."""
FORMAT = 1
_T = TypeVar("_T", bound=str)
_MAX_BYTES = 64 * 1024
_LONGEST_NAME_BYTES, _LONGEST_PATH_BYTES = 255, 2048
"""Of one file or folder, as common file systems have it; of a path in a recording's folder, which
leaves as much of the 4096 that Linux takes to the folder itself."""
_SIDES: tuple[Side, ...] = ("left", "right")


@dataclass(frozen=True, slots=True)
class Manifest:
    """What a recording is made of. Sources and files are relative to the recording's folder.

    Attributes:
        name: for people.
        left: a video, an image folder or a glob of images; the only camera if `right` is None.
        right: the right camera's source; None: monocular, or both cameras in `left` (see `layout`).
        layout: how both cameras lie in `left`; None: `left` holds one camera.
        first: the camera on the left or at the top, where `layout` is given.
        right_lag: frames by which the right camera is late; negative: the left one; None: not told.
        depth: a source of 16-bit pictures, one for each of `left`; None: no depth.
        depth_scale_m: metres of a unit of depth.
        topics: of `left`, `right` and `depth` where the source is a bag; "": found by content.
        fps: frames a second; None: as the video says.
        calibration: one file, or a pair; empty: not calibrated.
        ground: where the floor is; None: unknown.
        region: where people are looked for.
        unknown: keys that mean nothing here.
    """

    name: str
    left: str
    right: str | None = None
    layout: Layout | None = None
    first: Side = "left"
    right_lag: int | None = None
    depth: str | None = None
    depth_scale_m: float = USUAL_SCALE_M
    topics: tuple[str, str, str] = ("", "", "")
    fps: float | None = None
    calibration: tuple[str, ...] = ()
    ground: Ground | None = None
    region: RegionOfInterest = EVERYWHERE
    unknown: tuple[str, ...] = ()


def read_manifest(folder: Path) -> Manifest:
    """The manifest of a recording folder.

    Raises:
        RecordingError: missing, too large, or not what contract and TOML ask for.
    """
    return parse_manifest(manifest_text(folder), str(folder / MANIFEST_NAME), folder.name)


def manifest_text(folder: Path) -> str:
    """The text of a folder's recording.toml; RecordingError where it cannot be read."""
    path = folder / MANIFEST_NAME
    try:
        if path.exists() and not path.is_file():  # a pipe would keep us waiting for ever
            raise RecordingError("{path}: not a file; put the manifest there", path=path)
        if path.stat().st_size > _MAX_BYTES:
            raise RecordingError(
                "{path}: larger than {size} KiB; not a manifest", path=path, size=_MAX_BYTES // 1024
            )
        return path.read_text("utf-8-sig")
    except OSError as error:
        raise RecordingError(
            "{path}: cannot be read ({reason}); check it", path=path, reason=error.strerror
        ) from error
    except UnicodeDecodeError as error:
        raise RecordingError(
            "{path}: not text in UTF-8; save it again as UTF-8", path=path
        ) from error


def names_sources(text: str, where: str) -> bool:
    """Whether a manifest says what the recording is made of; RecordingError: it is no TOML."""
    content = read_toml(text, where)
    return "left" in content or "stereo" in content


def parse_manifest(
    text: str, where: str, fallback_name: str, found: Manifest | None = None
) -> Manifest:
    """The manifest in a text.

    Args:
        text: TOML.
        where: its path, for messages.
        fallback_name: the name where it gives none.
        found: what its folder was found to hold, for a text that names no sources.
    """
    content = read_toml(text, where)
    table = ManifestTable(content, where)
    if table.get("format", int, FORMAT) != FORMAT:
        raise RecordingError(
            "{where}: format {said} is not known, only {known}; update trackwright",
            where=where,
            said=content["format"],
            known=FORMAT,
        )
    if found is not None:
        _check_without_left(table, found)
        return replace(
            found,
            right_lag=_right_lag(table),
            depth_scale_m=_depth_scale(table, found.depth_scale_m),
            name=table.get("name", str, fallback_name),
            fps=_fps(table) or found.fps,
            calibration=_calibration(table) or found.calibration,
            ground=_ground(table),
            region=_region(table),
            unknown=unknown_keys(content),
        )
    left, right, layout, first = _sources(table)
    return Manifest(
        name=table.get("name", str, fallback_name),
        left=left,
        right=right,
        layout=layout,
        first=first,
        right_lag=_right_lag(table),
        depth=_depth(table),
        depth_scale_m=_depth_scale(table),
        topics=_topics(table),
        fps=_fps(table),
        calibration=_calibration(table),
        ground=_ground(table),
        region=_region(table),
        unknown=unknown_keys(content),
    )


def parse_ground(text: str, where: str) -> Ground | None:
    """The floor in a manifest's text, which need not name sources.

    Args:
        text: TOML. where: its path, for messages.

    Raises:
        RecordingError: it is no TOML, or says a floor that cannot be.
    """
    return _ground(ManifestTable(read_toml(text, where), where))


def _sources(table: ManifestTable) -> tuple[str, str | None, Layout | None, Side]:
    if "stereo" in table:
        if "left" in table or "right" in table:
            raise table.error("stereo", msg("stands beside [left] or [right]; keep one of the two"))
        stereo = table.section("stereo")
        layout = _choice(stereo, "layout", LAYOUTS, LAYOUTS[0])
        return _source(stereo), None, layout, _choice(stereo, "first", _SIDES, "left")
    if "left" not in table:
        raise table.missing(
            "left", msg("is missing; say where the images are: [left] source = ...")
        )
    right = _source(table.section("right")) if "right" in table else None
    return _source(table.section("left")), right, None, "left"


def _depth(table: ManifestTable) -> str | None:
    if "depth" not in table:
        return None
    if "right" in table or "stereo" in table:
        raise table.error(
            "depth", msg("stands beside a right camera; keep one of the two, [depth] or [right]")
        )
    return _source(table.section("depth"))


def _depth_scale(table: ManifestTable, usual_m: float = USUAL_SCALE_M) -> float:
    section = table.section("depth")
    return checked_scale(section.get("scale", float, usual_m), section.place("scale"))


def _check_without_left(table: ManifestTable, found: Manifest) -> None:
    """Refuse what a text that names no [left] says of other sources than those found."""
    right, depth = table.section("right"), table.section("depth")
    for section in (right, depth):
        for key in ("source", "topic"):
            if key in section:
                raise section.error(
                    key, msg("counts beside [left] alone; name the left camera's source, too")
                )
    if "lag" in right and found.right is None and found.layout is None:
        raise right.error("lag", msg("is of a right camera, and none was found; leave it out"))
    if "scale" in depth and found.depth is None:
        raise depth.error("scale", msg("is of depth images, and none were found; leave it out"))


def _topics(table: ManifestTable) -> tuple[str, str, str]:
    left, right, depth = (
        table.section(side).get("topic", str, "") for side in ("left", "right", "depth")
    )
    return left, right, depth


def _source(table: ManifestTable) -> str:
    source: str = table.get("source", str, "")
    if not source:
        raise table.missing("source", msg("is missing; name a video, or images such as left/*.png"))
    if "\0" in source:
        raise table.error("source", msg("holds a zero character; write the file's name"))
    if _is_too_long(source):
        raise table.error(
            "source", msg("is longer than the name of any file; write the file's name")
        )
    return source


def _is_too_long(name: str) -> bool:
    """Whether no file can have the name, so that the system would not even look for it."""
    longest = max((len(part.encode()) for part in PurePath(name).parts), default=0)
    return longest > _LONGEST_NAME_BYTES or len(name.encode()) > _LONGEST_PATH_BYTES


def _choice(table: ManifestTable, key: str, choices: tuple[_T, ...], default: _T) -> _T:
    value = table.get(key, str, default)
    for choice in choices:
        if choice == value:
            return choice
    raise table.error(key, msg("must be one of {choices}", choices=joined(", ", choices)))


def _right_lag(table: ManifestTable) -> int | None:
    side = table.section("stereo" if "stereo" in table else "right")
    lag: int | None = side.get("lag", int, None)
    if lag is not None and abs(lag) > MOST_LAG:
        raise side.error("lag", msg("must be -{most} to {most} frames", most=MOST_LAG))
    return lag


def _fps(table: ManifestTable) -> float | None:
    fps: float | None = table.get("fps", float, None)
    return None if fps is None else checked_fps(fps, table.place("fps"))


def _calibration(table: ManifestTable) -> tuple[str, ...]:
    if "calibration" not in table:
        return ()
    section = table.section("calibration")
    try:
        files = [section.get("file", str, "")]
    except RecordingError:
        files = section.get("file", list, [])
    if not 1 <= len(files) <= 2 or not all(map(_is_file_name, files)):
        raise section.error("file", msg("must be one file name, or a list of two"))
    return tuple(files)


def _is_file_name(value: object) -> bool:
    return isinstance(value, str) and value != "" and "\0" not in value and not _is_too_long(value)


def _ground(table: ManifestTable) -> Ground | None:
    if "ground" not in table:
        return None
    section = table.section("ground")
    if "R" in section or "t" in section:
        return _ground_of_pose(section)
    for key in ("height", "tilt"):
        if key not in section:
            raise section.missing(key, msg("is missing; give height in metres and tilt in degrees"))
    try:
        return checked_ground(
            section.get("height", float, 0.0),
            section.get("tilt", float, 0.0),
            section.get("roll", float, 0.0),
        )
    except CalibrationError as error:
        raise section.error(
            "height", msg("and tilt make no floor: {error}", error=error)
        ) from error


def _ground_of_pose(section: ManifestTable) -> Ground:
    """The floor of a camera's pose: x_camera = R x_world + t, world z up, in metres."""
    try:
        rotation = np.array(section.get("R", list, []), float)
        shift = np.array(section.get("t", list, []), float)
    except (TypeError, ValueError) as error:
        raise section.error("R", msg("and t must be lists of numbers, 3 x 3 and 3")) from error
    if rotation.shape != (3, 3) or shift.shape != (3,):
        raise section.error("R", msg("and t must be lists of numbers, 3 x 3 and 3"))
    try:
        ground = ground_of_pose(rotation, shift)
        return checked_ground(ground.height_m, ground.tilt_deg, ground.roll_deg)
    except CalibrationError as error:
        raise section.error("R", msg("and t make no floor: {error}", error=error)) from error


def _region(table: ManifestTable) -> RegionOfInterest:
    section = table.section("region")
    return RegionOfInterest(_outlines(section, "look"), _outlines(section, "mask"))


def _outlines(section: ManifestTable, key: str) -> tuple[Outline, ...]:
    outlines = outlines_of(section.get(key, list, []))
    if isinstance(outlines, tuple):
        return outlines
    raise section.error(key, outlines)

"""What a recording's calibration and floor give, checked against its pictures."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path

from tracking.errors import CalibrationError
from tracking.geometry import (
    Ground,
    Rectification,
    StereoCalibration,
    View,
    calibration_text,
    depth_pair,
    read_calibration,
)
from tracking.geometry.calibration_file_text import parse_yaml
from tracking.geometry.json_calibration import calibration_of_json, parsed
from tracking.geometry.ros_calibration import calibration_of_ros
from tracking.recording.bags.bag_pictures import calibration_texts, is_bag, open_bag
from tracking.recording.kinds.oak import calibration_in_tar
from tracking.recording.limits import height_doubt
from tracking.recording.tar_pictures import is_tar
from tracking.translation import Message, msg


@dataclass(frozen=True, slots=True, eq=False)
class Calibrated:
    """Cameras and floor of a recording; None where not known.

    Attributes:
        calibration: of the cameras the recording has.
        view: the left camera on the floor.
        rectification: of two calibrated cameras.
        text: the calibration files as read.
        notes: oddities, in words.
    """

    calibration: StereoCalibration | None
    view: View | None
    rectification: Rectification | None
    text: str
    notes: tuple[Message, ...]


def read_calibrated(
    files: Sequence[Path],
    size: tuple[int, int],
    stereo: bool,
    ground: Ground | None,
    *,
    depth: bool = False,
    topics: Sequence[str] = ("", "", ""),
) -> Calibrated:
    """Read a recording's calibration files and fit them to its pictures.

    Args:
        files: none, one or two.
        size: width and height of one camera in px.
        stereo: whether the recording has two cameras.
        ground: where the floor is; None where unknown.
        depth: whether depth stands beside its one camera.
        topics: of the cameras, where a file is a bag.

    Raises:
        CalibrationError: unreadable, or made for pictures of another size.
    """
    if not files:
        return Calibrated(None, None, None, "", ())
    calibration, text = read_with_text(files, size, topics)
    notes: tuple[Message, ...] = ()
    if calibration.left.size != size:
        notes = (_scaled_note(files[0], calibration.left.size),)
        calibration = calibration.scaled_to(size)
    calibration.check_size(size)
    beside = depth_pair(calibration) if depth else calibration
    if not stereo and calibration.right is not None:
        calibration = StereoCalibration.of_one(calibration.left, rough=calibration.rough)
    notes += _shortcomings(files[0], calibration, stereo)
    if ground is not None and (doubt := height_doubt(ground)) is not None:
        notes += (doubt,)
    return Calibrated(
        calibration,
        View(calibration.left, ground) if ground is not None else None,
        Rectification(beside, ground)
        if depth or (stereo and calibration.right is not None)
        else None,
        text,
        notes,
    )


def read_with_text(
    files: Sequence[Path], size: tuple[int, int], topics: Sequence[str] = ("", "", "")
) -> tuple[StereoCalibration, str]:
    """The calibration as its files, a bag or a tar have it, and their text.

    Raises:
        CalibrationError, RecordingError: unreadable.
    """
    if is_tar(files[0]):
        text = calibration_in_tar(files[0])
        return calibration_of_json(parsed(text) or {}, files[0], size), text
    if is_bag(files[0]):
        return _of_bag(files[0], topics, size)
    return read_calibration(files, size), calibration_text(files)


def _scaled_note(file: Path, made_for: tuple[int, int]) -> Message:
    return msg(
        "{name}: made for {width} x {height} px, and scaled to the recording's images",
        name=file.name,
        width=made_for[0],
        height=made_for[1],
    )


def _shortcomings(file: Path, calibration: StereoCalibration, stereo: bool) -> tuple[Message, ...]:
    """What a calibration that can be used lacks."""
    notes: tuple[Message, ...] = ()
    if stereo and calibration.right is None:
        notes += (
            msg("{name}: calibrates the left camera only; there is no depth", name=file.name),
        )
    if calibration.rough:
        lack = msg("{name}: a rough calibration; metres may be off by a tenth", name=file.name)
        notes += (lack,)
    return notes


def _of_bag(
    path: Path, topics: Sequence[str], size: tuple[int, int]
) -> tuple[StereoCalibration, str]:
    """The calibration that a bag's camera_info says, and its text."""
    texts = calibration_texts(open_bag(path, topics).contents)
    if not texts:
        raise CalibrationError(
            "{path}: holds no camera_info of all its cameras; give a calibration file", path=path
        )
    values = [(path, parse_yaml(text, path)) for text in texts]
    return calibration_of_ros(values, size), "\n".join(texts)

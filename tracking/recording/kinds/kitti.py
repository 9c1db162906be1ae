"""KITTI: raw drives, sequences of the odometry and of the tracking benchmark."""

from __future__ import annotations

from pathlib import Path

from tracking.errors import RecordingError
from tracking.recording.kinds.folders import first_file, images_in
from tracking.recording.kinds.kind import FoundSources, RecordingKind
from tracking.recording.time_stamps import has_stamps
from tracking.translation import N_, Message, msg

_FPS = 10.0


def find_kitti(folder: Path) -> FoundSources | None:
    """A sequence, or the only one of a benchmark's tree; None where there is none.

    Raises:
        RecordingError: there are several, of which the user must choose.
    """
    return (_sequence(folder) or _only_sequence(folder)) if folder.is_dir() else None


def _sequence(folder: Path) -> FoundSources | None:
    """A KITTI sequence: image_02 and image_03 in a folder, or one sequence of the benchmark's.

    Known are the raw data's (image_02/data), the odometry benchmark's (image_2) and the tracking
    benchmark's tree (training/image_02/0000 with training/calib/0000.txt).
    """
    for left_name, right_name in (
        ("image_02", "image_03"),
        ("image_2", "image_3"),
        ("image_00", "image_01"),
    ):
        left = images_in(folder / left_name)
        if left is not None:
            right = images_in(folder / right_name)
            calibration = first_file(
                (folder, "calib.txt"), (folder, "calib_cam_to_cam.txt"),
                (folder.parent, "calib_cam_to_cam.txt"),
            )  # fmt: skip
            return _found(left, right, calibration, folder.resolve().name)
    if folder.parent.name == "image_02" and images_in(folder) is not None:
        training = folder.parent.parent
        right = images_in(training / "image_03" / folder.name)
        calibration = first_file((training / "calib", f"{folder.name}.txt"))
        return _found(folder, right, calibration, folder.name)
    return None


def _found(
    left: Path, right: Path | None, calibration: tuple[Path, ...], name: str
) -> FoundSources:
    """The sequence; its rate is KITTI's unless its own time stamps tell it."""
    if has_stamps(left):
        return FoundSources(left, right, calibration=calibration, name=name)
    return FoundSources(
        left, right, calibration=calibration, fps=_FPS, name=name, notes=(_rate_note(),)
    )


def _rate_note() -> Message:
    return msg(
        "frames per second are not stated: {fps:g}, as KITTI has; --fps says otherwise", fps=_FPS
    )


def _only_sequence(folder: Path) -> FoundSources | None:
    for half in (folder, folder / "training", folder / "testing"):
        if (half / "image_02").is_dir():
            found = [place for place in sorted((half / "image_02").iterdir()) if images_in(place)]
            if len(found) > 1:
                raise RecordingError(
                    "{folder}: holds {count} KITTI sequences; open one of them, e.g. {example}",
                    folder=folder,
                    count=len(found),
                    example=found[0],
                )
            return _sequence(found[0]) if found else None
    return None


KITTI = RecordingKind(
    "kitti",
    N_("KITTI: raw drives with time stamps, odometry and tracking sequences"),
    find_kitti,
)

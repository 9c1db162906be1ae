"""What a caller may say about a recording beside, or instead of, its manifest."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path

from tracking.errors import RecordingError
from tracking.geometry import Ground
from tracking.recording.depth_pictures import USUAL_SCALE_M
from tracking.recording.image_pairs import Layout, Side
from tracking.recording.limits import checked_fps, checked_ground
from tracking.recording.region_of_interest import Outline, RegionOfInterest


@dataclass(frozen=True, slots=True)
class OpenOptions:
    """Options of the commands that open a recording; what is None is taken from the recording.

    Attributes:
        left, right: a video, an image folder or a glob of images for each camera.
        calibration: the calibration file, or a pair of files.
        height_m, tilt_deg, roll_deg: where the floor is; see `Ground`.
        fps: frames a second; it counts, whatever the recording says. See `rate`.
        layout: how both cameras lie in one video.
        first: the camera on the left or at the top of it.
        right_lag: frames by which the right camera is late; negative: the left one.
        look, mask: see `RegionOfInterest`; they stand in place of what the recording says.
        allow_outside: a manifest may name files outside its folder.
        depth: beside `left`, in place of `right`, m per unit `depth_scale_m`. topics: of bags, of
            left, right and depth. These three count with `left` alone.
    """

    left: Path | None = None
    right: Path | None = None
    calibration: tuple[Path, ...] = ()
    height_m: float | None = None
    tilt_deg: float | None = None
    roll_deg: float | None = None
    fps: float | None = None
    layout: Layout | None = None
    first: Side | None = None
    right_lag: int | None = None
    look: tuple[Outline, ...] = ()
    mask: tuple[Outline, ...] = ()
    allow_outside: bool = False
    depth: Path | None = None
    depth_scale_m: float = USUAL_SCALE_M
    topics: tuple[str, str, str] = ("", "", "")

    def ground(self, told: Ground | None) -> Ground | None:
        """The floor, with what the options say in place of what the recording says.

        Raises:
            RecordingError: one of height and tilt is given and the other one is not known.
            CalibrationError: no camera stands like that.
        """
        if self.height_m is None and self.tilt_deg is None and self.roll_deg is None:
            return told
        height, tilt, roll = (
            (told.height_m, told.tilt_deg, told.roll_deg) if told else (None, None, 0.0)
        )
        height = height if self.height_m is None else self.height_m
        tilt = tilt if self.tilt_deg is None else self.tilt_deg
        if height is None or tilt is None:
            raise RecordingError(
                "ground: the floor needs both the camera's height and its tilt; give --height "
                "and --tilt"
            )
        return checked_ground(height, tilt, roll if self.roll_deg is None else self.roll_deg)

    def rate(self, told: float | None) -> float | None:
        """Frames a second, the option's in place of what the recording says.

        Raises:
            RecordingError: the option is out of range.
        """
        return told if self.fps is None else checked_fps(self.fps, "--fps")

    def region(self, told: RegionOfInterest) -> RegionOfInterest:
        """Where people are looked for, with the options in place of what the recording says."""
        return RegionOfInterest(self.look or told.look, self.mask or told.mask)

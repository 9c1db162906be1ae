"""Whether cameras and floor can be what they are said to be, by the empty scene itself."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Any

import cv2
import numpy as np

from tracking.arrays import Floats, Picture
from tracking.errors import SettingsError
from tracking.geometry import Ground, Rectification
from tracking.recording import Recording, StereoFrame
from tracking.stereo import SightLines
from tracking.trackers import changed_settings, settings_fields, settings_values
from tracking.translation import Message, joined, msg

_MATCHING = "stereo."
"""Settings of how the cameras are matched begin so; all are numbers with a unit."""
_WIDTH_PX = 400
"""Pictures are shrunk to less than this: a glance is enough."""
_WINDOW_PX = 11
_BEYOND_PX = 1.0
"""What is shifted by so much against what is infinitely far away lies behind the cameras."""
_FEWEST, _MOST = 300, 3000
"""Fewer places of the scene tell nothing, and more than this tell no more."""
_NOISE_PX, _SLOPE = 0.75, 0.08
"""How far a floor may be from a plane, px and as a share of its disparity."""
_FINE = 0.3
"""A floor that was found is fitted again to what is nearer to it by this."""
_GUESSES, _FITS = 300, 4
_MOST_TURN_DEG = 45.0
_HEIGHTS_M = (0.3, 40.0)
_LEAST_FLOOR = 0.3
"""Share of a scene by which a floor is known; on rendered ones it is 0.78 to 1."""
_SUITS = 0.5
"""A floor as told has this share of the one that suits the scene best; a wrong one mostly none."""
_SAME, _LEAST_DETAIL = 0.5, 3.0
"""Grey levels: how much the same images differ at the most, and any picture in itself."""


@dataclass(frozen=True, slots=True)
class SceneDistances:
    """Places of a scene whose distance is known, whatever the floor is.

    Attributes:
        sight: (n, 2) metres forward and up in the world for a metre of depth.
        disparity: (n,) px less that of what is infinitely far away.
        focal_baseline: px m.
    """

    sight: Floats
    disparity: Floats
    focal_baseline: float

    @property
    def is_behind(self) -> bool:
        """Whether most of it would lie behind the cameras, as where the cameras are swapped."""
        enough = len(self.disparity) >= _FEWEST
        return enough and bool(np.mean(self.disparity < -_BEYOND_PX) > 0.5)


def require_sense(settings: Mapping[str, Any]) -> None:
    """Refuse settings that leave no distance to look at; by their dotted names.

    Raises `SettingsError`.
    """
    nearest, farthest = (settings.get(f"stereo.{which}_m") for which in ("nearest", "farthest"))
    if nearest is not None and farthest is not None and nearest >= farthest:
        raise SettingsError(
            "settings stereo.nearest_m={nearest:g} and stereo.farthest_m={farthest:g} leave "
            "nothing between them: give a nearest_m that is less than farthest_m",
            nearest=nearest,
            farthest=farthest,
        )


def changed_matching(tracker: str, settings: Any) -> str:
    """Settings of how the cameras are matched that are not the tracker's defaults, in words.

    What a person is to look like (`people.*`) changes no distance, and is not among them.
    """
    changed = changed_settings(tracker, settings_values(settings))
    return joined(
        ", ",
        (
            msg(
                "{title} is {value:g} {unit}",
                title=field.title,
                value=changed[field.name],
                unit=field.unit,
            )
            for field in settings_fields(type(settings))
            if field.name.startswith(_MATCHING) and field.name in changed
        ),
    )


def doubt_of(recording: Recording, frames: Sequence[StereoFrame]) -> Message:
    """What cannot be right of cameras, height and tilt, for the user; "": nothing.

    Args:
        frames: spread over the recording; all tell whether the cameras differ, the middle one the
            rest.
    """
    rectification, ground = recording.rectification, recording.ground
    frame = frames[len(frames) // 2]
    if rectification is None or ground is None or frame.right is None:
        return Message()
    if _show_the_same(frames):
        return msg(
            "{name}: both cameras show the same images, which tell no distance: give "
            "the right camera's own source, or choose a tracker for one camera",
            name=recording.name,
        )
    scene = measure_scene(rectification, frame.left, frame.right)
    if scene.is_behind:
        return msg(
            "{name}: no distance for what moves: are the cameras swapped?", name=recording.name
        )
    better = better_floor(scene, ground)
    if better is None:
        return Message()
    return msg(
        "{name}: {ground} do not suit the scene, {better} would: check how the camera stands",
        name=recording.name,
        ground=_describe(ground),
        better=_describe(better),
    )


def _show_the_same(frames: Sequence[StereoFrame]) -> bool:
    """Whether both cameras' pictures are the same in all frames that show anything."""
    pairs = [(frame.left, frame.right) for frame in frames if frame.right is not None]
    told = [pair for pair in pairs if float(np.std(pair[0])) > _LEAST_DETAIL]
    return bool(told) and all(_differ(*pair) < _SAME for pair in told)


def _differ(left: Picture, right: Picture) -> float:
    """Grey levels between two pictures, where either shows more than its empty ground.

    Night shows little, and over all of it the pictures hardly differ.
    """
    ground = np.median(left)
    shown = (np.abs(left - ground) > _LEAST_DETAIL) | (np.abs(right - ground) > _LEAST_DETAIL)
    return float(cv2.absdiff(left, right)[shown].mean()) if shown.any() else np.inf


def _describe(ground: Ground) -> str:
    return msg(
        "height {height_m:.3g} m and tilt {tilt_deg:.3g} degrees",
        height_m=ground.height_m,
        tilt_deg=ground.tilt_deg,
    )


def measure_scene(rectification: Rectification, left: Picture, right: Picture) -> SceneDistances:
    """The distances of everything in one frame.

    Args:
        left, right: (height, width, 3) as recorded.
    """
    lines = SightLines(rectification, -(-rectification.size[0] // _WIDTH_PX))
    size = lines.shape[::-1]
    images = [_grey_in(size, image) for image in rectification.rectify(left, right)]
    reach = 16 * max(1, size[0] // 64)
    found = _ranged(images, round(lines.offset), reach)
    rows, columns = np.nonzero(np.isfinite(found))
    some = np.linspace(0, max(len(rows) - 1, 0), min(len(rows), _MOST)).astype(int)
    rows, columns = rows[some], columns[some]
    sight = lines.rays[rows, columns, 1:].astype(np.float64)
    return SceneDistances(sight, found[rows, columns] - lines.offset, lines.focal_baseline)


def _grey_in(size: Sequence[int], image: Picture) -> Picture:
    grey = (
        image if image.ndim == 2 else np.asarray(cv2.cvtColor(image, cv2.COLOR_BGR2GRAY), np.uint8)
    )
    return np.asarray(cv2.resize(grey, tuple(size), interpolation=cv2.INTER_AREA), np.uint8)


def _ranged(images: Sequence[Picture], middle: int, reach: int) -> Floats:
    """(height, width) disparities within `reach` of the middle, NaN where nothing matched."""
    matcher = cv2.StereoBM.create(2 * reach, _WINDOW_PX)
    matcher.setMinDisparity(middle - reach)
    matcher.setTextureThreshold(10)
    matcher.setUniquenessRatio(15)
    matcher.setDisp12MaxDiff(1)
    beside = 2 * reach + abs(middle)
    wide = [cv2.copyMakeBorder(e, 0, 0, beside, beside, cv2.BORDER_REPLICATE) for e in images]
    found = np.asarray(matcher.compute(*wide), np.float64)[:, beside:-beside] / 16
    partner = np.arange(found.shape[1]) - found
    good = (found > middle - reach) & (partner >= 0) & (partner < found.shape[1])
    return np.where(good, found, np.nan)


def better_floor(scene: SceneDistances, ground: Ground) -> Ground | None:
    """Another floor that the scene lies on where it does not on the one told; None: it may.

    A level seen through two lines of sight is a plane of disparities that are linear in `sight`.
    A floor has much of the scene on it and nothing below.
    """
    before = scene.disparity > _BEYOND_PX
    sight, disparity = scene.sight[before], scene.disparity[before]
    if len(disparity) < _FEWEST:
        return None
    planes = _guess(sight, disparity, scene.focal_baseline, ground)
    told = np.array([[0.0, -scene.focal_baseline / ground.height_m]])
    worth = _worth(np.concatenate((told, planes)), sight, disparity)
    best = int(np.argmax(worth))
    if worth[best] < _LEAST_FLOOR or worth[0] >= _SUITS * worth[best]:
        return None
    plane = _fit(planes[best - 1], sight, disparity)
    height, tilt = _stands(plane[None], scene.focal_baseline, ground)
    return Ground(float(height[0]), float(np.clip(tilt[0], -90, 90)), ground.roll_deg)


def _guess(sight: Floats, disparity: Floats, product: float, ground: Ground) -> Floats:
    """(k, 2) planes through two places each, which a camera about as told could stand over."""
    pairs = np.random.default_rng(0).integers(0, len(disparity), (_GUESSES, 2))
    pairs = pairs[np.abs(np.linalg.det(sight[pairs])) > 1e-3]
    planes = np.linalg.solve(sight[pairs], disparity[pairs][..., None])[..., 0]
    height, tilt = _stands(planes, product, ground)
    possible = (height > _HEIGHTS_M[0]) & (height < _HEIGHTS_M[1]) & (tilt < 91)
    return planes[possible & (np.abs(tilt - ground.tilt_deg) < _MOST_TURN_DEG)]


def _stands(planes: Floats, product: float, ground: Ground) -> tuple[Floats, Floats]:
    """Heights, m, and tilts, degrees, of the camera over each of the planes."""
    turn = np.rad2deg(np.arctan2(-planes[:, 0], -planes[:, 1]))
    norm = np.maximum(np.hypot(planes[:, 0], planes[:, 1]), 1e-9)
    return product / norm, ground.tilt_deg - turn


def _worth(planes: Floats, sight: Floats, disparity: Floats) -> Floats:
    """(k,) of the scene, the share on each of the planes less the share below it."""
    there = planes @ sight.T
    over = disparity - there
    slack = _NOISE_PX + _SLOPE * disparity
    on, below = np.abs(over) < slack, over < -slack
    return np.asarray(((on.astype(np.float64) - below) * (there > 0)).mean(axis=1))


def _fit(plane: Floats, sight: Floats, disparity: Floats) -> Floats:
    """The plane, drawn to what lies on it."""
    for _ in range(_FITS):
        slack = _FINE * (_NOISE_PX + _SLOPE * disparity)
        near = np.abs(disparity - sight @ plane) < slack
        if np.count_nonzero(near) < _FEWEST // 10:
            break
        plane = np.asarray(np.linalg.lstsq(sight[near], disparity[near])[0], np.float64)
    return plane

"""Subtraction stereo: range for what moved, and for nothing else."""

from __future__ import annotations

import math

import cv2
import numpy as np
from numpy.typing import NDArray

from tracking.arrays import Mask
from tracking.stereo.row_alignment import Levelling
from tracking.stereo.settings import StereoSettings
from tracking.stereo.sharpness import EvenSharpness
from tracking.stereo.sight_lines import SightLines

Grey = NDArray[np.uint8]
Disparity = NDArray[np.float32]
Parts = NDArray[np.int16]

STEP = 2
"""Pixels between the places that get a disparity."""
_PARTS_OF_PX = 16
_SLACK_PX = 1.0
_FILTER_PX = 2
"""How far beyond a window what the matcher does before matching reaches."""
_SCENES_PER_LEVELLING = 8
"""Times that the scene is ranged from one look at whether the cameras are alike to the next."""
_SAME_PLACE_M, _SAME_PLACE_PX = 0.15, 0.75
"""How far in range, and at most in disparity, a change may be from the background it is on."""


Box = tuple[slice, slice]

_TILE = (4, 8)
"""Rows and columns of pixels that are taken in or left out together; 8 columns are one number."""
_EACH_PX = 1500
"""What a part costs beside its pixels, in pixels."""


class SubtractionStereo:
    """Matches left against right where both are foreground.

    [Kawashita2012], [Kawashita2014] section 2.1: the background is subtracted from each camera on
    its own and what is left is matched. Each pixel is only searched between the disparity of the
    floor it looks at and that of the tallest person that could stand on that line of sight.
    """

    def __init__(self, lines: SightLines, settings: StereoSettings | None = None) -> None:
        self._settings = settings or StereoSettings()
        self._least, self._most = disparities_of_people(lines, self._settings)
        least, most = math.floor(float(self._least.min())), math.ceil(float(self._most.max()))
        self._beside = max(most, -least) + 1
        across = np.arange(0, lines.shape[1], STEP) + self._beside
        row = np.arange(len(self._least)) * (lines.shape[1] + 2 * self._beside)
        self._partner = (row[:, None] + across).ravel()
        self._least_parts = np.ceil(self._least * _PARTS_OF_PX).astype(np.int16)
        self._most_parts = np.floor(self._most * _PARTS_OF_PX).astype(np.int16)
        self._reach_px = self._settings.window_px // 2 + _FILTER_PX
        least_disparities = 16 + max(0, math.floor(float(self._least.min())))
        self._margin_px = (2 * self._reach_px, 2 * self._reach_px + least_disparities)
        self._lines = lines
        self._scene = np.full_like(self._least, np.nan)
        self._scene_slack = np.zeros_like(self._least)
        self._sharpness = EvenSharpness()
        self._levelling = Levelling()
        self._till_look = 0
        self._matcher = cv2.StereoBM.create(16, self._settings.window_px | 1)
        self._matcher.setTextureThreshold(5)
        self._matcher.setUniquenessRatio(10)
        self._matcher.setDisp12MaxDiff(1)
        self._matcher.setPreFilterCap(31)

    @property
    def scene(self) -> Disparity:
        """(rows, columns) px of the empty scene on the pixels [::STEP, ::STEP]; NaN: unknown."""
        return self._scene

    def learn_scene(self, left: Grey, right: Grey) -> None:
        """Range the empty scene, so that light that changes on it is not taken for people.

        A change whose range is that of the background itself is a shadow or a fleck of light, on
        the floor or on anything else. The tolerance is a fixed length, but never more than
        a fraction of a pixel: far away, where range cannot tell people from a wall close behind
        them, nothing is dropped.

        Args:
            left, right: (height, width) rectified grey pictures of the backgrounds.
        """
        look = self._till_look == 0
        if look:
            self._sharpness.learn(left, right)
        scene = self._ranged_scene(left, right)
        if look:
            before = self._levelling.off
            # A scene that tells nothing is no reason to wait for long: the next one may.
            told = self._levelling.learn(left, right, scene, STEP)
            self._till_look = _SCENES_PER_LEVELLING if told else 1
            if self._levelling.off is not before:
                scene = self._ranged_scene(left, right)
        self._till_look -= 1
        self._take_scene(scene)

    def suppose_scene(self, left: Grey, right: Grey) -> None:
        """Range a scene as `learn_scene` does, learning nothing of the cameras from it.

        Args:
            left, right: (height, width) rectified grey pictures of the scene.
        """
        self._take_scene(self._ranged_scene(left, right))

    def _take_scene(self, scene: Disparity) -> None:
        """What is as far away as this is no person from now on."""
        self._scene = scene
        self._scene_slack = slack_of(scene, self._lines)

    def _ranged_scene(self, left: Grey, right: Grey) -> Disparity:
        """(rows, columns) px of the empty scene, NaN where nothing matched."""
        left, right = self._alike(left, right)
        rows, columns = self._least.shape
        whole = (slice(0, rows), slice(0, columns))
        low, high = math.floor(float(self._least.min())), math.ceil(float(self._most.max()))
        found = self._search(_rows_halved(left), _rows_halved(right), whole, low, high)
        scene = found[:, ::STEP].astype(np.float32) / np.float32(_PARTS_OF_PX)
        return np.where(scene >= low, scene, np.nan).astype(np.float32)

    def _alike(self, left: Grey, right: Grey) -> tuple[Grey, Grey]:
        """Both cameras as if they stood level and were equally sharp."""
        return self._sharpness.even(left, self._levelling.level(right))

    def match(self, left: Grey, right: Grey, left_mask: Mask, right_mask: Mask) -> Disparity:
        """Disparity of the left camera's foreground, on every second pixel.

        Rows are halved before matching and columns are not: range needs full resolution across
        only, and the window becomes as upright as people are. Each part of the foreground is
        matched on its own, among the disparities that people can have there.

        Args:
            left, right: (height, width) rectified grey pictures.
            left_mask, right_mask: uint8, non-zero in the foreground.

        Returns:
            (rows, columns) float32 px for the pixels [::STEP, ::STEP]; NaN outside the foreground
            and where nothing matched.
        """
        here, there = left_mask[::STEP], self._levelling.level_mask(right_mask)[::STEP]
        disparity = np.full(self._least.size, np.nan, np.float32)
        if cv2.hasNonZero(there):
            left, right = self._alike(left, right)
            sought = np.ascontiguousarray(here[:, ::STEP])
            parts = self._matched(_rows_halved(left), _rows_halved(right), here, sought)
            good = (parts >= self._least_parts) & (parts <= self._most_parts)
            place = np.flatnonzero(good & sought.view(np.bool_))
            d = parts.ravel().take(place).astype(np.float32) / np.float32(_PARTS_OF_PX)
            kept = self._foreground_there(there, place, d)
            kept &= ~(np.abs(d - self._scene.take(place)) < self._scene_slack.take(place))
            rows = np.flatnonzero(kept)
            disparity[place.take(rows)] = d.take(rows)
        return disparity.reshape(self._least.shape)

    def _matched(self, left: Grey, right: Grey, here: Mask, sought: Mask) -> Parts:
        """(rows, columns) disparities on the grid, in parts of a pixel.

        What is not near foreground is 0, and what did not match is below any disparity.

        Args:
            left, right: rows halved. here: the foreground. sought: of it, on the grid.
        """
        found = np.zeros(self._least.shape, np.int16)
        for rows, columns in areas(here, self._margin_px):
            box = rows, slice(columns.start // STEP, -(-columns.stop // STEP))
            own = sought[box]
            if not cv2.hasNonZero(own):
                continue
            low = math.floor(cv2.minMaxLoc(self._least[box], own)[0])
            high = math.ceil(cv2.minMaxLoc(self._most[box], own)[1])
            found[box] = self._search(left, right, box, low, high)[:, ::STEP]
        return found

    def _foreground_there(
        self, mask: Mask, place: NDArray[np.intp], disparity: Disparity
    ) -> NDArray[np.bool_]:
        """Whether the right camera, too, sees foreground at the matched place.

        Args:
            mask: of every second row. place: (n,) on the grid.
        """
        # With nobody beside the picture, no partner lies outside.
        beside = (0, 0, self._beside, self._beside)
        padded = np.asarray(cv2.copyMakeBorder(mask, *beside, cv2.BORDER_CONSTANT, value=(0.0,)))
        partner = self._partner.take(place) - np.rint(disparity).astype(np.intp)
        return np.asarray(padded.ravel().take(partner) != 0, np.bool_)

    def _search(
        self, left: Grey, right: Grey, box: tuple[slice, slice], lowest: int, highest: int
    ) -> Parts:
        """Block matching inside a box of the grid; all its pixels' disparities, in parts of one."""
        count = -(-(highest - lowest + 1) // 16) * 16
        self._matcher.setMinDisparity(lowest)
        self._matcher.setNumDisparities(count)
        rows, columns = box[0], slice(box[1].start * STEP, box[1].stop * STEP)
        margin = self._reach_px
        before = max(0, count + lowest) + margin
        top, bottom = self._rows_matched(rows, left.shape[0])
        first, last = columns.start - before, columns.stop + margin
        cut = np.s_[top:bottom, max(0, first) : last]
        images = [image[cut] for image in (left, right)]
        if first < 0 or last > left.shape[1]:
            pad = (max(0, -first), max(0, last - left.shape[1]))
            images = [_beside(image, pad) for image in images]
        found = self._matcher.compute(*images)
        inner = found[rows.start - top :, before:]
        return np.asarray(inner[: rows.stop - rows.start, : columns.stop - columns.start], np.int16)

    def _rows_matched(self, rows: slice, height: int) -> tuple[int, int]:
        """The first, and past the last, row that is matched for the sake of a box's.

        At the picture's upper or lower edge a low box and its margin are fewer than a window has.
        """
        fewest = self._matcher.getBlockSize() + 1
        top = max(0, min(rows.start - self._reach_px, height - fewest))
        return top, min(height, max(rows.stop + self._reach_px, fewest))


def disparities_of_people(
    lines: SightLines, settings: StereoSettings
) -> tuple[Disparity, Disparity]:
    """The least and the largest disparity that people have, (rows, columns) on the grid each."""
    near, far = settings.nearest_m, settings.farthest_m
    floor, head = (
        lines.disparity_at_height(height_m, near, far)[::STEP, ::STEP]
        for height_m in (0.0, settings.max_height_m)
    )
    return floor - _SLACK_PX, head + _SLACK_PX


def slack_of(scene: Disparity, lines: SightLines) -> Disparity:
    """How far from the scene's disparity (rows, columns) what is on it may be."""
    per_m = (scene - np.float32(lines.offset)) ** 2 / np.float32(lines.focal_baseline)
    slack = np.minimum(per_m * _SAME_PLACE_M, np.float32(_SAME_PLACE_PX))
    return np.asarray(slack, np.float32)


def least_side_px(window_px: int) -> int:
    """The side of the smallest pictures, at the working scale, in which a window is matched."""
    return STEP * (window_px | 1) + 1


def _rows_halved(image: Grey) -> Grey:
    """Each row the mean of two; a last odd one stays."""
    if image.shape[0] % STEP:
        image = np.concatenate((image, image[-1:]))
    return np.asarray(cv2.addWeighted(image[::STEP], 0.5, image[1::STEP], 0.5, 0.0), np.uint8)


def _beside(image: Grey, pad: tuple[int, int]) -> Grey:
    """The picture with its sides drawn out."""
    return np.asarray(cv2.copyMakeBorder(image, 0, 0, *pad, cv2.BORDER_REPLICATE), np.uint8)


def areas(mask: Mask, margin: tuple[int, int]) -> list[Box]:
    """Boxes, rows and columns, that hold all of a mask and little else.

    Args:
        mask: (height, width) uint8, non-zero where it counts.
        margin: rows and columns that a box costs beside its own.

    Returns:
        Boxes of tiles, cut at the picture's sides; the one box round all of it where several would
        cost more. None without anything.
    """
    count, _, stats, _ = cv2.connectedComponentsWithStats(_tiles(mask), connectivity=8)
    if count <= 1:
        return []
    (down, across), (height, width) = _TILE, mask.shape
    # A handful of boxes: plain numbers are quicker than arrays.
    boxes = [
        (
            slice(top * down, min((top + rows) * down, height)),
            slice(left * across, min((left + columns) * across, width)),
        )
        for left, top, columns, rows, _ in np.asarray(stats)[1:].tolist()
    ]
    whole = _round(boxes)
    return boxes if _cost(boxes, margin) <= _cost([whole], margin) else [whole]


def _tiles(mask: Mask) -> Mask:
    """(rows, columns) of tiles, 1 where there is anything in one."""
    below, beside = (-length % tile for length, tile in zip(mask.shape, _TILE, strict=True))
    if below or beside:
        mask = np.asarray(
            cv2.copyMakeBorder(mask, 0, below, 0, beside, cv2.BORDER_CONSTANT, value=(0.0,)),
            np.uint8,
        )
    rows = mask[0 :: _TILE[0]].copy()
    for row in range(1, _TILE[0]):
        rows |= mask[row :: _TILE[0]]
    return np.asarray(rows.view(np.uint64) != 0).view(np.uint8)


def _round(boxes: list[Box]) -> Box:
    """The box round all of them."""
    rows, columns = zip(*boxes, strict=True)
    return (
        slice(min(side.start for side in rows), max(side.stop for side in rows)),
        slice(min(side.start for side in columns), max(side.stop for side in columns)),
    )


def _cost(boxes: list[Box], margin: tuple[int, int]) -> int:
    """Pixels of boxes with their margins, and what each costs beside."""
    return sum(
        (rows.stop - rows.start + margin[0]) * (columns.stop - columns.start + margin[1]) + _EACH_PX
        for rows, columns in boxes
    )

"""Check: a camera that was knocked out of its place midway."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from tracking.arrays import Floats, Picture
from tracking.doctor.drawings import draw_moves
from tracking.doctor.evidence import Samples
from tracking.doctor.findings import Finding
from tracking.doctor.floor_cost import DISTANCE_M
from tracking.doctor.matches import Matches, match_points
from tracking.translation import N_, msg

CODE = "camera-moved"
_CELLS = (8, 6)
_FEWEST_IN_CELL = 4
_FEATURES = 1500
"""Of an image: enough for every part of it."""
_FEWEST_CELLS = 8
_LEAST_SIGMA_PX = 0.06
"""By which a part of the image seems moved where light or an encoder changed it."""
_LEAST_PX = 0.35
"""Movement that costs nothing: wind, warmth."""
_SURE = 5.5
"""Standard deviations."""


@dataclass(frozen=True, slots=True, eq=False)
class Moved:
    """How a camera's picture moved between two frames.

    Attributes:
        shift_px: (2,) of most of the image. sigma_px: of each number of it.
        matches: points of the scene in both frames, without those that moved otherwise.
    """

    shift_px: Floats
    sigma_px: float
    matches: Matches

    @property
    def is_sure(self) -> bool:
        """Whether the camera moved beyond what matching is off by, and by what matters."""
        length = float(np.hypot(*self.shift_px))
        return length > max(_LEAST_PX, _SURE * self.sigma_px)


def movement_of(before: Picture, after: Picture) -> Moved | None:
    """How the camera moved; None where too little is seen in both.

    People walk; the scene moves as one. The median over parts of the image is the scene's.
    """
    matches = match_points(before, after, _FEATURES)
    shift = matches.second - matches.first
    size = (before.shape[1], before.shape[0])
    place = (matches.first / size * _CELLS).astype(int)
    cell = place[:, 1] * _CELLS[0] + place[:, 0]
    parts = np.array(
        [
            np.median(shift[cell == number], axis=0)
            for number in np.unique(cell)
            if (cell == number).sum() >= _FEWEST_IN_CELL
        ]
    ).reshape(-1, 2)
    if len(parts) < _FEWEST_CELLS:
        return None
    middle = np.median(parts, axis=0)
    # A camera that rolls moves no middle: what most parts moved by counts as well.
    most = float(np.median(np.hypot(*parts.T)))
    if most > np.hypot(*middle):
        middle = np.array((most, 0.0))
    spread = 1.4826 * float(np.median(np.abs(parts - np.median(parts, axis=0))))
    sigma = float(np.hypot(spread / np.sqrt(len(parts)), _LEAST_SIGMA_PX))
    return Moved(middle, sigma, matches)


def check_moved(
    samples: Samples, focal_px: float | None, baseline_m: float | None = None
) -> tuple[Finding | None, int]:
    """The finding where a camera moved, and the number of samples before it did so.

    Args:
        focal_px: of the cameras; None: taken to be as the image is wide.
        baseline_m: of a pair; None: places do not come from disparity.
    """
    lefts, rights, frames = samples.lefts, samples.rights, samples.numbers
    moved = {
        side: found
        for side, images in (("left", lefts), ("right", rights))
        if len(images) > 1
        and (found := movement_of(images[0], images[-1])) is not None
        and found.is_sure
    }
    if not moved:
        return None, len(frames)
    side = max(moved, key=lambda name: float(np.hypot(*moved[name].shift_px)))
    worst = moved[side]
    images = lefts if side == "left" else rights
    split = moment_of(images)
    shift_px = float(np.hypot(*worst.shift_px))
    names = {
        "left": N_("the left camera moved"), "right": N_("the right camera moved"),
        "both": N_("both cameras moved"),
    }  # fmt: skip
    which = "both" if len(moved) == 2 else side
    finding = Finding(
        CODE,
        msg(names[which]),
        msg("split the recording there, and set up each part; or fix the camera and record anew"),
        {
            "camera": which, "shift_px": shift_px, "sigma_px": worst.sigma_px,
            "after_frame": frames[split - 1], "before_frame": frames[split],
        },
        _cost_m(
            shift_px / (focal_px or float(images[0].shape[1])),
            None if which == "both" else baseline_m,
        ),
        picture=draw_moves(images[-1], worst.matches),
    )  # fmt: skip
    return finding, split


def moment_of(images: tuple[Picture, ...]) -> int:
    """The first of the images that shows the camera where it is in the last one; by halving."""
    low, high = 0, len(images) - 1
    while high - low > 1:
        middle = (low + high) // 2
        found = movement_of(images[0], images[middle])
        if found is not None and found.is_sure:
            high = middle
        else:
            low = middle
    return high


def _cost_m(angle_rad: float, baseline_m: float | None) -> float:
    """Of a person 5 m away: across, or along the view where one camera of a pair moved alone."""
    across = DISTANCE_M * angle_rad
    along = 0.0 if baseline_m is None else DISTANCE_M * across / baseline_m
    return min(DISTANCE_M, max(across, along))

"""Whether the right camera sees what the left one sees, and at the same instant."""

from __future__ import annotations

from collections.abc import Sequence

import cv2
import numpy as np

from tracking.arrays import Floats, Picture
from tracking.people.motion_agreement import MotionAgreement, late_by, stands_still, thinned
from tracking.recording.image_pairs import MOST_LAG
from tracking.translation import Message, count_msg, msg

_TILE = 20
"""Side of the squares, of thinned pixels, that are looked at for whether they show anything."""
_STRUCTURED, _FLAT = 4.0, 1.5
"""Deviations of brightness, grey levels: of a tile that shows something, and that shows nothing."""
_FEWEST_TILES, _LOST = 6, 0.25
"""Of at least so many tiles that show something left, this share must show nothing right."""
_FROZEN_FRAMES = 3
"""Frames on end without movement after which a camera is frozen: encoders repeat one or two."""
_EVERY_S = 0.25
"""How often a lag is looked for."""
_ONE_FAILURE_S = 1.0
"""Failures no farther apart than this are told as one."""
_MOST_TOLD = 5
"""Failures, and changes of lag, that are told one by one; the others are counted."""
_LOOKS = 2
"""So many looks on end must find the same lag, or that there is none."""
_MUCH_WORSE = msg("which is far worse: more people are lost, or take each other's ids")
"""What one camera is worth, for the user."""


class StereoWatch:
    """Follows how the two cameras agree, frame by frame.

    A camera that fails shows nothing where the other one does (it is black or flat, all of it or a
    part), or does not move while the other one does. A camera that lags shows the same movement,
    late (`MotionAgreement`). Who reads the frames pairs pictures of one instant by `lag`; what is
    left between the pictures of a pair says whether that is still right.

    Attributes:
        failing: whether the right camera is of no use in the last frame looked at.
        lag: frames by which the right camera is late; negative: the left one is; None: by so many
            that nobody knows.
        pairing: the lag by which the next frames are to be paired; while `lag` is unknown the last
            one known, or 0 where recording.toml told one that the footage does not show.
    """

    def __init__(self, fps: float) -> None:
        """`fps`: frames a second."""
        self.failing = False
        self.lag: int | None = 0
        self.pairing = 0
        self._fps = fps
        self._told: int | None = None
        self._every = max(1, round(_EVERY_S * fps))
        self._gap = max(1, round(_ONE_FAILURE_S * fps))
        self._movement = MotionAgreement(fps)
        self._last = -1
        self._paired = 0
        self._frozen = self._count = self._found = self._looks = self._unlike = 0
        self._failed: list[tuple[int, int]] = []
        self._lagged: list[Message] = []

    def begin(self, lag: int, told: int | None = None) -> None:
        """The lag is known before the first frame; told: by recording.toml, None: not told."""
        self.lag = self.pairing = lag
        self._told = told
        if told is not None:
            self._movement = MotionAgreement(self._fps, told)
        if lag and lag == told:
            self._lagged.append(
                msg("{late}, as recording.toml says: images are paired so", late=_late(lag))
            )
        elif lag != (told or 0):
            paired = msg("{late}: images of the same instant are paired", late=_late(lag))
            self._lagged.append(paired + self._unless_told(lag))

    def _unless_told(self, lag: int | None) -> Message:
        """What to do where recording.toml says otherwise."""
        if self._told is None or lag == self._told:
            return Message()
        return msg(
            "; recording.toml says {told}: leave `lag` out to have it looked for", told=self._told
        )

    def look(self, frame: int, left: Picture, right: Picture, paired: int = 0) -> None:
        """Take notice of the next frame; one that does not follow on the last tells no movement.

        Args:
            left, right: (height, width, 3) uint8, rectified.
            paired: so many frames later the right picture was recorded than the left one.
        """
        if paired != self._paired:
            self._pair_anew(paired)
        if frame != self._last + 1:
            self._movement.begin()
        self._last = frame
        images = thinned(left), thinned(right)
        moved = self._movement.add(images)
        self._frozen = self._frozen + 1 if stands_still(moved[1], moved[0]) else 0
        self.failing = self._frozen >= _FROZEN_FRAMES or _lost(*images)
        if self.failing:
            self._took_failure(frame)
            return
        self._count += 1
        if self._count % self._every == 0:
            self._look_for_lag(frame)

    def notes(self) -> tuple[Message, ...]:
        """What the user should know, a line each; nothing while both cameras are well."""
        failed = [
            msg(
                "the right camera shows nothing new in frames {first} to {last}: people "
                "are tracked with the left camera alone there, {much_worse}; look after "
                "the camera or its cable",
                first=first,
                last=last,
                much_worse=_MUCH_WORSE,
            )
            for first, last in self._failed
        ]
        return (*_first_few(failed), *_first_few(self._lagged))

    def _pair_anew(self, paired: int) -> None:
        """Other pictures make a pair from here on."""
        self._movement.begin()
        self._paired = paired
        self._looks = self._unlike = self._frozen = 0

    def _took_failure(self, frame: int) -> None:
        """Movement is not compared over a failure; short gaps are told as one."""
        self._movement.keep(0)
        if self._failed and frame - self._failed[-1][1] <= self._gap:
            self._failed[-1] = (self._failed[-1][0], frame)
        else:
            self._failed.append((frame, frame))

    def _look_for_lag(self, frame: int) -> None:
        """Where the cameras do not agree as they are paired, whether another lag explains them."""
        if self.lag == self._paired and self._movement.agrees():
            self._looks = self._unlike = 0
            return
        stretch = self._movement.stretch()
        found = None if stretch is None else late_by([stretch], self._movement.most_lag)
        if found is None:
            self._looks = 0
        else:
            self._looks = self._looks + 1 if found == self._found else 1
            self._found = found
            lag = self._paired + found
            if self._looks >= _LOOKS and lag != self.lag and abs(lag) <= MOST_LAG:
                self._take(frame, lag)
        self._unlike = self._unlike + 1 if self._movement.is_unlike() else 0
        if self._unlike >= _LOOKS and self.lag == self._paired:
            self._take(frame, None)

    def _take(self, frame: int, lag: int | None) -> None:
        """The lag is another one from a frame on."""
        self.lag = lag
        self._looks = 0
        self._lagged.append(_told_late(frame, lag) + self._unless_told(lag))
        if lag is not None:
            self.pairing = lag
            return
        self._movement.keep(self._movement.recent)
        if self._told is not None:
            self.pairing = 0


def _told_late(frame: int, lag: int | None) -> Message:
    """What is told of a lag that was found at a frame."""
    if lag is None:
        return msg(
            "from frame {frame} on the cameras do not show the same instant, and the "
            "lag is unknown: people are tracked with the left camera alone, "
            "{much_worse}",
            frame=frame,
            much_worse=_MUCH_WORSE,
        )
    if lag == 0:
        return msg("from frame {frame} on both cameras show the same instant", frame=frame)
    return msg(
        "{late}, found at frame {frame}: images of the same instant are paired from "
        "there; distances shortly before may be wrong",
        late=_late(lag),
        frame=frame,
    )


def _late(lag: int) -> Message:
    if lag == 0:
        return msg("neither camera is late")
    if lag > 0:
        return count_msg(
            lag, "the right camera is {n} frame late", "the right camera is {n} frames late"
        )
    return count_msg(
        -lag, "the left camera is {n} frame late", "the left camera is {n} frames late"
    )


def _first_few(lines: Sequence[Message]) -> Sequence[Message]:
    """Not more lines than anybody reads, and how many more there are."""
    more = len(lines) - _MOST_TOLD
    return (
        lines
        if more <= 0
        else [*lines[:_MOST_TOLD], msg("and {more} more times like this", more=more)]
    )


def shows_nothing(left: Picture, right: Picture) -> bool:
    """Whether the right camera, or a part of it, is black or flat where the left one is not.

    Args:
        left, right: (height, width, 3) uint8, rectified.
    """
    return _lost(thinned(left), thinned(right))


def _lost(left: Picture, right: Picture) -> bool:
    """Whether a part of the right picture shows nothing where the left one shows something."""
    here = _deviation(right) < _FLAT
    if not here.any():
        return False
    there = _deviation(left) > _STRUCTURED
    return bool(there.sum() >= _FEWEST_TILES and (there & here).sum() > _LOST * there.sum())


def _deviation(image: Picture) -> Floats:
    """Standard deviation of brightness in each tile."""
    rows, columns = (side // _TILE for side in image.shape)
    if rows == 0 or columns == 0:
        return np.zeros((1, 1))
    light = image[: rows * _TILE, : columns * _TILE].astype(np.float32)
    mean, squared = (
        cv2.resize(values, (columns, rows), interpolation=cv2.INTER_AREA)
        for values in (light, light * light)
    )
    return np.sqrt(np.maximum(np.asarray(squared - mean * mean, np.float64), 0))

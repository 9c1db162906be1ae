"""Whether a camera still stands as it did: marks of the scene looked for again."""

from __future__ import annotations

import cv2
import numpy as np

from tracking.arrays import Picture
from tracking.foreground.marks import Marks, Points
from tracking.translation import Message, msg

_EVERY_S = 1.0
_WIDE_PX = 320
"""Width of the pictures compared; narrower ones stay as they are."""
_EVENED_PX, _FAINT = 9, 2.0
"""Side of the squares in which contrast is evened out, and what is noise there, grey levels."""
_MARKS = Marks(most=80, faintest=0.02, apart_px=12, window_px=21, levels=2)
_RETURN_PX = 0.7
"""A mark followed there and back must end so near to where it began."""
_LEFT = 0.4
"""New marks are taken when fewer of them are found: people who stay, or light, changed the rest."""
_MOVED_PX, _ALIKE_PX = 1.0, 0.75
_SHARE, _OUTWEIGH = 0.25, 2.0
"""Of all marks so many must have moved as one picture does, shifted, turned and scaled, and so many
times as many as stay where they were: people hide most of the marks, a camera leaves none."""
_CHECKS = 2
"""It must stand otherwise in so many checks on end: people walk on."""


class CameraWatch:
    """Marks of the scene, and about once a second where they are now.

    People cover some of the marks and never move most of them as one; a camera that was pushed, or
    turns slowly, does. Light that changes moves nothing.

    Attributes:
        first: the first frame looked at; None before.
        still_at: the last frame in which the camera was seen to stand as it did.
        moved_at: the frame in which the camera was found to stand otherwise; None while it does
            not.
    """

    def __init__(self, fps: float) -> None:
        """`fps`: frames a second."""
        self.first: int | None = None
        self.still_at = 0
        self.moved_at: int | None = None
        self._every = max(1, round(_EVERY_S * fps))
        self._count = 0
        self._seen_moved: list[int] = []
        self._before: Picture | None = None
        self._marks: Points = np.zeros((0, 2), np.float32)

    def look(self, frame: int, picture: Picture) -> None:
        """Take notice of the next frame; only one in some is looked at closely.

        Args:
            picture: (height, width) or (height, width, 3) uint8.
        """
        if self.first is None:
            self.first = frame
        self._count += 1
        if self._before is None:
            self.still_at = frame
            self._take(_equalise(picture))
            return
        if self.moved_at is not None or self._count % self._every:
            return
        now = _equalise(picture)
        found, stayed, moved = self._counts(self._before, now)
        if moved >= _SHARE * _MARKS.most and moved > _OUTWEIGH * stayed:
            self._seen_moved.append(frame)
            if len(self._seen_moved) == _CHECKS:
                self.moved_at = self._seen_moved[0]
            return
        self._seen_moved.clear()
        self.still_at = frame
        if found < _LEFT * len(self._marks):
            self._take(now)

    def notes(self, tracker: str) -> tuple[Message, ...]:
        """Notes for the user of a tracker, a line; nothing while the camera stands still."""
        if self.moved_at is None or self.first is None:
            return ()
        return (
            msg(
                "the camera moved between frames {still_at} and {moved_at}: {tracker} "
                "needs a fixed one, do not rely on what it says from there; track the "
                "frames before with --frames {first}:{still_at2}",
                still_at=self.still_at,
                moved_at=self.moved_at,
                tracker=tracker,
                first=self.first,
                still_at2=self.still_at + 1,
            ),
        )

    def _take(self, now: Picture) -> None:
        """Take new marks."""
        self._before = now
        self._marks = _MARKS.of(now)

    def _counts(self, before: Picture, now: Picture) -> tuple[int, int, int]:
        """How many marks are found near by, are where they were, and moved as one picture does.

        Marks are looked for near by, and where the picture would be if it was shifted only: over
        a plain floor small windows are lost sooner.
        """
        if len(self._marks) == 0:
            return 0, 0, 0
        still = np.zeros(2, np.float32)
        starts, ends = _match_marks(before, now, self._marks, still)
        stayed = int((np.hypot(*(ends - starts).T) < _ALIKE_PX).sum())
        moved = _moves_as_one(starts, ends)
        shift = _shift_of_most(before, now)
        if np.hypot(*shift) > _MOVED_PX:
            moved = max(moved, _moves_as_one(*_match_marks(before, now, self._marks, shift)))
        return len(starts), stayed, moved


def _equalise(picture: Picture) -> Picture:
    """A small grey picture in which contrast is the same everywhere, and light says nothing."""
    light = picture if picture.ndim == 2 else cv2.extractChannel(picture, 1)
    shrink = min(1.0, _WIDE_PX / light.shape[1])
    size = (round(light.shape[1] * shrink), max(2, round(light.shape[0] * shrink)))
    small = cv2.resize(light, size, interpolation=cv2.INTER_AREA).astype(np.float32)
    square = (_EVENED_PX, _EVENED_PX)
    detail = small - cv2.blur(small, square)
    strength = np.sqrt(cv2.blur(detail * detail, square)) + np.float32(_FAINT)
    return np.asarray(np.clip(128 + 45 * detail / strength, 0, 255), np.uint8)


def _shift_of_most(before: Picture, now: Picture) -> Points:
    """(2,) px by which most of a picture is shifted, if it is."""
    window = cv2.createHanningWindow((now.shape[1], now.shape[0]), cv2.CV_32F)
    one, other = (np.asarray(each, np.float32) - 128 for each in (before, now))
    return np.array(cv2.phaseCorrelate(one, other, window)[0], np.float32)


def _match_marks(
    before: Picture, now: Picture, marks: Points, shift: Points
) -> tuple[Points, Points]:
    """Where marks that are found again were and are, (k, 2) px each.

    Args:
        shift: (2,) px by which they are thought to have moved.
    """
    there, found = _MARKS.followed(before, now, marks, marks + shift)
    back, again = _MARKS.followed(now, before, there, there - shift)
    good = found & again & (np.hypot(*(back - marks).T) < _RETURN_PX)
    return marks[good], there[good]


def _moves_as_one(start: Points, end: Points) -> int:
    """How many marks agree that the picture as a whole is elsewhere."""
    if len(start) < 3:
        return 0
    _, alike = cv2.estimateAffinePartial2D(
        start, end, method=cv2.RANSAC, ransacReprojThreshold=_ALIKE_PX
    )
    of_one = alike.ravel() > 0
    if not of_one.any():
        return 0
    shift = np.hypot(*(end - start)[of_one].T)
    return int(of_one.sum()) if np.median(shift) > _MOVED_PX else 0

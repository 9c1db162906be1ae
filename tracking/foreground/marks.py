"""Marks of a scene, and where they are in another picture of it."""

from __future__ import annotations

from dataclasses import dataclass

import cv2
import numpy as np
from numpy.typing import NDArray

from tracking.arrays import Flags, Picture

Points = NDArray[np.float32]


@dataclass(frozen=True, slots=True)
class Marks:
    """How corners of a scene are chosen, and followed to another picture.

    Marks are [ShiTomasi1994] corners, followed as by [LucasKanade1981], coarsely first
    [Bouguet2000].

    Attributes:
        most: of them.
        faintest: strength of the faintest corner, as a share of the strongest one's.
        apart_px: how far from each other they are at least.
        window_px: side of what is compared around each.
        levels: how many times the pictures are halved before marks are followed.
    """

    most: int
    faintest: float
    apart_px: int
    window_px: int
    levels: int

    def of(self, picture: Picture) -> Points:
        """(n, 2) px of the marks in a grey picture, the strongest first; none in a plain one."""
        found = cv2.goodFeaturesToTrack(picture, self.most, self.faintest, self.apart_px)
        none = np.zeros((0, 2), np.float32)
        return none if found is None else np.asarray(found, np.float32)[:, 0]

    def followed(
        self, before: Picture, now: Picture, marks: Points, guess: Points
    ) -> tuple[Points, Flags]:
        """Where marks are in another picture.

        Args:
            before, now: (height, width) grey pictures.
            marks: (n, 2) px in `before`.
            guess: (n, 2) px where they are thought to be in `now`.

        Returns:
            there: (n, 2) px in `now`.
            found: (n,) whether they could be followed.
        """
        if not len(marks):
            return marks, np.zeros(0, np.bool_)
        there, state, _ = cv2.calcOpticalFlowPyrLK(
            before,
            now,
            marks[:, None],
            guess[:, None].astype(np.float32),
            winSize=(self.window_px, self.window_px),
            maxLevel=self.levels,
            flags=cv2.OPTFLOW_USE_INITIAL_FLOW,
        )
        return np.asarray(there, np.float32)[:, 0], np.asarray(state)[:, 0] > 0

"""Detectors of plug-ins: whatever goes wrong in them names them."""

from __future__ import annotations

from dataclasses import replace
from typing import Any

import numpy as np

from tracking.arrays import Picture
from tracking.detections.box_collector import BoxCollector
from tracking.detections.box_format import BoxFormat
from tracking.detections.detector import Detector, DetectorSpec
from tracking.detections.frame_numbers import Footage
from tracking.people.detection_source import FrameDetections
from tracking.plugins import Offer, blaming
from tracking.plugins.blame import accused

_MOST_PX = 1e6


def guard_detector(spec: BoxFormat | DetectorSpec, offer: Offer) -> BoxFormat | DetectorSpec:
    """The same, whose mistakes name the plug-in."""
    return _guarded_format(spec, offer) if isinstance(spec, BoxFormat) else _guarded(spec, offer)


def _guarded_format(spec: BoxFormat, offer: Offer) -> BoxFormat:
    def read(boxes: BoxCollector, footage: Footage) -> None:
        with blaming(offer):
            spec.read(boxes, footage)

    def recognises(head: bytes) -> bool:
        with blaming(offer):
            return bool(spec.recognises(head))

    return replace(spec, read=read, recognises=recognises)


def _guarded(spec: DetectorSpec, offer: Offer) -> DetectorSpec:
    def opened() -> Detector:
        with blaming(offer):
            return GuardedDetector(spec.open(), offer)

    return replace(spec, open=opened)


class GuardedDetector:
    """A detector of a plug-in: a `Detector`."""

    def __init__(self, inner: Detector, offer: Offer) -> None:
        self._inner, self._offer = inner, offer

    def find(self, picture: Picture) -> FrameDetections:
        """See `Detector`; what it gives is checked."""
        with blaming(self._offer):
            found: Any = self._inner.find(picture.copy())
            box, score = np.asarray(found.box, np.float64), np.asarray(found.score, np.float64)
        if box.ndim != 2 or box.shape[1] != 4 or score.shape != (len(box),):
            raise accused(
                self._offer,
                "it gave boxes of shape {box} and scores of shape {score}; (n, 4) and (n,) are "
                "needed",
                box=box.shape,
                score=score.shape,
            )
        if not bool(np.all(np.abs(box) < _MOST_PX)) or not bool(np.isfinite(score).all()):
            raise accused(self._offer, "it gave a box or a score that is no number")
        if bool((box[:, 2:] < 0).any()):
            raise accused(self._offer, "it gave a box with a negative width or height")
        return FrameDetections(box, score)

    def close(self) -> None:
        """See `Detector`."""
        with blaming(self._offer):
            self._inner.close()

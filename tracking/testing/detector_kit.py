"""What every detector, and every format of boxes, must do."""

from __future__ import annotations

from pathlib import Path

import numpy as np

from tracking.arrays import Picture
from tracking.detections import Footage, read_detections
from tracking.detections.box_format import BoxFormat
from tracking.detections.catalogue import DETECTORS
from tracking.detections.detector import DetectorSpec
from tracking.testing.rules import (
    at_the_door,
    hostile_heads,
    leaving_nothing_open,
    never_raises,
    obeying,
    raises_ours_alone,
    require,
)


def check_detector(spec: DetectorSpec, picture: Picture | None = None) -> None:
    """Check what a detector gives for pictures of all kinds.

    Args:
        spec: the detector's entry. picture: one with people, who must be found.

    Raises BrokenRule for the first rule that it breaks.
    """
    with at_the_door(DETECTORS, spec), obeying():
        known = DETECTORS[spec.name]
        assert isinstance(known, DetectorSpec)
        require(known.title[:1].isupper(), "its title must begin with a capital")
        with leaving_nothing_open("the detector"):
            _check_pictures(known, picture)


def _check_pictures(spec: DetectorSpec, picture: Picture | None) -> None:
    detector = spec.open()
    for one in _pictures():
        first, again = detector.find(one), detector.find(one)
        same = np.array_equal(first.box, again.box) and np.array_equal(first.score, again.score)
        require(same, "the same picture gave other boxes the second time")
    if picture is not None:
        require(len(detector.find(picture)) > 0, "nobody was found in the picture with people")
    detector.close()
    never_raises(detector.close, "close, the second time,")


def _pictures() -> list[Picture]:
    noise = np.random.default_rng(3)
    return [
        np.zeros((120, 160, 3), np.uint8),
        np.full((240, 320, 3), 255, np.uint8),
        noise.integers(0, 256, (97, 131, 3), np.uint8),
        noise.integers(0, 256, (64, 48), np.uint8),
    ]


def check_box_format(spec: BoxFormat, folder: Path, sample: Path, frames: int) -> None:
    """Check a format of boxes of another program.

    Args:
        spec: the format's entry. folder: to write in, empty. sample: a file of it, of a recording
            of so many frames of 640 x 480 px.

    Raises BrokenRule for the first rule that it breaks.
    """
    footage = Footage(frames, (640, 480))
    with at_the_door(DETECTORS, spec), obeying():
        known = DETECTORS[spec.name]
        assert isinstance(known, BoxFormat)
        for head in hostile_heads():
            never_raises(lambda: known.recognises(head), "recognises")  # noqa: B023 - called here
        require(not known.recognises(b""), "it takes an empty file for its own")
        read = read_detections(sample, footage)
        require(read.format == spec.name, "its sample was taken for {found}", found=read.format)
        require(len(read.table) > 0, "no box of its sample was read")
        whole = sample.read_bytes()
        for part in range(8):
            file = folder / f"damaged{sample.suffix}"
            file.write_bytes(whole[: len(whole) * part // 8])
            raises_ours_alone(lambda: read_detections(file, footage), "read")  # noqa: B023

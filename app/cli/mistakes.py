"""Pictures of what a detector is wrong about, for the report on its training."""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from contextlib import closing

import cv2
import numpy as np
from numpy.typing import NDArray

from app.cli.output import say
from app.cli.taught import How, Taught, footage_of
from tracking.errors import TrackwrightError
from tracking.failure import Mistake, TrainingReport
from tracking.recording import Recording
from tracking.session import Session
from tracking.tracks import PartLabel

_SIDE_PX = 200
_AROUND = 2.5
"""How far the picture reaches round the rectangle, in its own heights, at least."""
_COLOURS = {True: (80, 200, 80), False: (60, 60, 230)}
"""BGR of a rectangle on its part and off it."""


def pictures_of(report: TrainingReport, taught: Sequence[Taught], how: How) -> dict[int, bytes]:
    """JPEG images of the mistakes whose recordings can be opened, by the row of the sample."""
    mistakes = [one for question in report.questions for one in question.mistakes]
    pictures: dict[int, bytes] = {}
    for one in taught:
        wanted = [mistake for mistake in mistakes if mistake.recording == one.name and one.labels]
        if wanted:
            try:
                pictures |= _of_recording(one, wanted, how)
            except TrackwrightError as error:
                say(f"no pictures of {one.name}: {error}")
    return pictures


def _of_recording(taught: Taught, mistakes: Iterable[Mistake], how: How) -> dict[int, bytes]:
    with (
        closing(Session.open(taught.path)) as session,
        footage_of(session, how) as recording,
    ):
        return {
            mistake.sample: picture
            for mistake in sorted(mistakes, key=lambda one: one.frame)
            for picture in _picture(recording, taught.labels, mistake)
        }


def _picture(
    recording: Recording, labels: Mapping[tuple[int, int, int], PartLabel], mistake: Mistake
) -> Iterable[bytes]:
    """The person round the rectangle, which is green where it was labelled on its part."""
    label = labels.get((mistake.frame, mistake.track, mistake.part))
    if label is None or not 0 <= mistake.frame < recording.frame_count:
        return
    image = recording.read(mistake.frame).left.copy()
    left, top, width, height = label.box
    corners = np.array([[left, top], [left + width, top + height]]).round().astype(int)
    colour = _COLOURS[label.on_part is True]
    cv2.rectangle(image, corners[0].tolist(), corners[1].tolist(), colour, 2)
    cut = _cut(image, (left + width / 2, top + height / 2), _AROUND * max(width, height))
    size = (_SIDE_PX, _SIDE_PX)
    done, packed = cv2.imencode(".jpg", cv2.resize(cut, size, interpolation=cv2.INTER_AREA))
    if done:
        yield packed.tobytes()


def _cut(image: NDArray[np.uint8], centre: tuple[float, float], reach: float) -> NDArray[np.uint8]:
    """The square of the picture round a place, moved as far as it must be to lie in it."""
    half = max(1, min(round(reach), min(image.shape[:2]) // 2))
    rows, columns = (
        slice(first, first + 2 * half)
        for middle, length in zip((centre[1], centre[0]), image.shape[:2], strict=True)
        for first in [min(max(round(middle) - half, 0), length - 2 * half)]
    )
    return image[rows, columns]

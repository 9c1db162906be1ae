"""Pictures of what a detector is wrong about, for the report on its training."""

from __future__ import annotations

import cv2
import numpy as np

from app.cli.output import say
from app.cli.training_set import with_advice
from app.features.parts.mistake_pictures import Cut, Search, crop_surroundings
from app.features.parts.training_result import TrainingResult
from app.features.parts.training_set import Source, TrainingSet
from tracking.errors import TrackwrightError
from tracking.failure import Trained
from tracking.translation import msg

_SIDE_PX = 200
_COLOURS = {True: (80, 200, 80), False: (60, 60, 230)}
"""BGR of a rectangle labelled on its part and off it."""


def pictures_of(
    trained: Trained, training_set: TrainingSet, *, allow_outside: bool
) -> dict[int, bytes]:
    """JPEG images of the mistakes whose recordings can be opened, by the row of the sample."""

    def missed(source: Source, error: TrackwrightError) -> None:
        say(
            msg(
                "no images of {title}: {why}",
                title=source.title,
                why=with_advice(error, allow_outside),
            )
        )

    search = Search(allow_outside=allow_outside, missed=missed)
    items = TrainingResult(trained, training_set).scene().mistakes
    cuts = crop_surroundings(None, search, items, lambda *_: None)
    return {
        one.mistake.sample: _packed(cut, on=one.mistake.failed)
        for one, cut in cuts.items()
        if cut is not None
    }


def _packed(cut: Cut, *, on: bool) -> bytes:
    """A JPEG image with the rectangle, which is green where it was labelled on its part."""
    piece, (left, top, width, height) = cut
    scale = _SIDE_PX / max(piece.shape[:2])
    way = cv2.INTER_AREA if scale < 1 else cv2.INTER_LINEAR
    image = cv2.resize(piece, None, fx=scale, fy=scale, interpolation=way)
    corners = np.array([[left, top], [left + width, top + height]])
    first, last = (scale * corners).round().astype(int).tolist()
    cv2.rectangle(image, first, last, _COLOURS[on], 2)
    return cv2.imencode(".jpg", image)[1].tobytes()

"""The ramp image: how far each pixel differs from the background, as colours over the picture."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from app.core.colours.colour_scales import INFERNO
from app.core.i18n import tr
from app.core.scenes import LegendEntry
from app.core.tracks.frame_state import Kinds
from app.core.tracks.made_by import MadeBy, overlay_of
from tracking.errors import CalibrationError
from tracking.pipeline import background_samples
from tracking.recording import Recording, StereoFrame

Rgba = NDArray[np.uint8]

_OPACITY = 215


class RampPainter:
    """Paints the ramp image of single frames in any order, with a background of its own.

    Its background is learnt once, from frames spread over the recording.

    Args:
        recording: calibrated, with a floor.
        run: whose settings are taken, where its tracker works with a ramp.

    Raises:
        CalibrationError: the recording has no calibration or no floor.
    """

    def __init__(self, recording: Recording, run: MadeBy | None = None) -> None:
        if recording.view is None:
            raise CalibrationError(
                "{name}: the ramp image needs a calibrated camera and the floor; add "
                "[calibration] and [ground] to recording.toml",
                name=recording.name,
            )
        build, settings = overlay_of(run, lambda overlays: overlays.ramp)
        self._recording = recording
        self._source = build(recording.fps, recording.view, settings)
        self._learnt = False

    def paint(self, frame: StereoFrame, kinds: Kinds) -> Rgba:  # noqa: ARG002 - as all painters
        """(height, width, 4) uint8 RGBA over the left picture as recorded.

        The first call learns the background, which takes a second or two.

        Raises:
            RecordingError: a frame cannot be read.
        """
        if not self._learnt:
            self._source.learn(*background_samples(self._recording))
            self._learnt = True
        grey = self._source.ramp_picture(frame)
        painted = np.empty((*grey.shape, 4), np.uint8)
        painted[..., :3] = INFERNO.table[grey]
        painted[..., 3] = _OPACITY
        return painted

    def legend(self, kinds: Kinds) -> tuple[LegendEntry, ...]:  # noqa: ARG002
        """What the colours mean."""
        said = ((1.0, tr("foreground")), (0.5, tr("doubtful")), (0.0, tr("background")))
        return tuple(LegendEntry(INFERNO.colour(share), text) for share, text in said)

"""Boxes of a network as perception asks for them, made as frames are tracked."""

from __future__ import annotations

import numpy as np

from tracking.arrays import Mask
from tracking.detections import DetectionSettings, place_of
from tracking.detections.settings import ONLY
from tracking.detections.table import are_in_region, suppress_overlaps
from tracking.errors import FormatError
from tracking.networks.model_file import Model, read_model
from tracking.networks.network_process import NetworkProcess
from tracking.people.detection_source import FrameDetections
from tracking.recording import Recording, StereoFrame
from tracking.tracks import NETWORK_BOX_COLUMNS, Columns, DetectionsInput, empty
from tracking.tracks.columns import box_columns
from tracking.translation import Message, count_msg, msg

NETWORK = "network"
"""The format of such detections, as sessions and reports have it."""


class NetworkDetections:
    """Gives the boxes of a network for the frame that was looked at last.

    Args:
        model: the network. settings: which of its boxes are used.
        both: whether the right camera is looked at, too.
        looked_at: the region of interest in the left picture, see `Recording`; None: everywhere.

    Raises FormatError where it cannot be run; what it holds is to be closed.
    """

    def __init__(
        self,
        model: Model,
        settings: DetectionSettings,
        *,
        both: bool,
        looked_at: Mask | None = None,
    ) -> None:
        self._model, self._settings, self._both = model, settings, both
        self._process = NetworkProcess(model, settings.max_overlap, 2 if both else 1)
        self._looked_at = looked_at
        self._left: dict[int, FrameDetections] = {}
        self._right: dict[int, FrameDetections] = {}
        self._pictures = self._count = 0

    def look(self, frame: StereoFrame) -> None:
        """Find the people in a frame, before it is asked about.

        Raises FormatError where the network fails.
        """
        right = frame.right if self._both and frame.right_lag is not None else None
        pictures = [frame.left] if right is None else [frame.left, right]
        found = self._process.find(pictures, self._least_score)
        chosen = [suppress_overlaps(boxes, self._settings.max_overlap) for boxes in found]
        if self._looked_at is not None:
            left = are_in_region(chosen[0].box, self._looked_at)
            chosen[0] = FrameDetections(chosen[0].box[left], chosen[0].score[left])
        self._left = {frame.number: chosen[0]}
        self._right = {} if right is None else {frame.number + (frame.right_lag or 0): chosen[1]}
        self._pictures += len(chosen)
        self._count += sum(map(len, chosen))

    @property
    def appearance(self) -> Model | None:
        """The appearance network that its TOML describes beside it."""
        return self._model.appearance

    def close(self) -> None:
        """End the program that runs the network."""
        self._process.close()

    @property
    def _least_score(self) -> float:
        asked = self._settings.least_score
        return self._model.spec.min_score if asked is None else asked

    @property
    def detections_only(self) -> bool:
        """Whether no people are looked for in the foreground beside them."""
        return self._settings.use == ONLY

    def of(self, frame: int) -> FrameDetections:
        """The boxes of the left camera; raises KeyError for a frame not looked at just now."""
        return self._left[frame]

    def of_right(self, frame: int) -> FrameDetections | None:
        """Those of the right camera; None where it was not looked at."""
        return self._right.get(frame)

    @property
    def boxes(self) -> Columns:
        """`NETWORK_BOX_COLUMNS` of the frame that was looked at last, as a run keeps them."""
        parts = [
            {
                **box_columns(found.box),
                "camera": np.full(len(found), camera, np.uint8),
                "score": found.score,
            }
            for camera, frames in enumerate((self._left, self._right))
            for found in frames.values()
        ]
        none = empty(NETWORK_BOX_COLUMNS)
        return {
            name: np.concatenate([column, *(part[name] for part in parts)], dtype=column.dtype)
            for name, column in none.items()
        }

    @property
    def inputs(self) -> tuple[DetectionsInput, ...]:
        """Which network it is, as a run keeps it; the number of boxes so far."""
        model = self._model
        return (
            DetectionsInput(
                camera="",
                file=model.path.name,
                format=NETWORK,
                fingerprint=model.fingerprint,
                count=self._count,
                network=model.name,
                decoder=model.spec.decoder,
                licence=model.licence,
            ),
        )

    @property
    def notes(self) -> tuple[Message, ...]:
        """What the user should know of it, a line each."""
        model = self._model
        if self._pictures and not self._count:
            return (
                msg(
                    "warning: {file} (network {name}) found nobody in {pictures} with a "
                    "score from {least:.3g} on; lower detections.min_score, or check its TOML",
                    file=model.path.name,
                    name=model.name,
                    pictures=count_msg(self._pictures, "{n} picture", "{n} pictures"),
                    least=self._least_score,
                ),
            )
        return (
            msg(
                "{file} (network {name}, {licence}): {boxes} in {pictures}, with "
                "a score from {least:.3g} on",
                file=model.path.name,
                name=model.name,
                licence=model.licence,
                boxes=count_msg(self._count, "{n} box", "{n} boxes"),
                pictures=count_msg(self._pictures, "{n} picture", "{n} pictures"),
                least=self._least_score,
            ),
        )


def require_finder(model: Model) -> None:
    """Refuse, with FormatError, a network that describes people and finds none."""
    if model.is_appearance:
        raise FormatError(
            "{path}: it is an appearance network, which finds nobody; give it in "
            "detections.appearance",
            path=model.path,
        )


def network_detections(
    recording: Recording, settings: DetectionSettings, *, stereo: bool
) -> NetworkDetections | None:
    """The boxes of the network that settings name; None where they name none.

    Args:
        stereo: whether the tracker looks at both cameras.

    Raises FormatError where it cannot be read or run.
    """
    if not settings.model:
        return None
    model = read_model(place_of(recording, settings.model))
    require_finder(model)
    return NetworkDetections(
        model, settings, both=stereo and recording.is_stereo, looked_at=recording.looked_at
    )

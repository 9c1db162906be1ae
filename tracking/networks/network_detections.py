"""Boxes of a network as perception asks for them, made as frames are tracked."""

from __future__ import annotations

from tracking.arrays import Mask
from tracking.detections import DetectionSettings, place_of
from tracking.detections.catalogue import picture_detector
from tracking.detections.detector import DetectorSpec
from tracking.detections.looked_at import LookedAt
from tracking.detections.picture_detections import PictureDetections
from tracking.errors import FormatError
from tracking.networks.model_file import Model, read_model
from tracking.networks.network_process import NetworkProcess
from tracking.recording import Recording, StereoFrame
from tracking.tracks import DetectionsInput
from tracking.translation import Message, count_msg, msg

NETWORK = "network"
"""The format of such detections, as sessions and reports have it."""


class NetworkDetections(LookedAt):
    """Gives the boxes of a network for the frame that was looked at last.

    Args:
        model: the network. settings, both, looked_at: see `LookedAt`.

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
        super().__init__(settings, both=both, looked_at=looked_at)
        self._model = model
        self._process = NetworkProcess(model, settings.max_overlap, 2 if both else 1)

    def look(self, frame: StereoFrame) -> None:
        """Find the people in a frame, before it is asked about.

        Raises FormatError where the network fails.
        """
        self.keep(frame, self._process.find(self.pictures_of(frame), self._least_score))

    @property
    def appearance(self) -> Model | None:
        """The appearance network that its TOML describes beside it."""
        return self._model.appearance

    def close(self) -> None:
        """End the program that runs the network."""
        self._process.close()

    @property
    def _least_score(self) -> float:
        asked = self.settings.least_score
        return self._model.spec.min_score if asked is None else asked

    @property
    def inputs(self) -> tuple[DetectionsInput, ...]:
        """Which network it is, as a run keeps it; the number of boxes so far."""
        return (self._model.as_input(NETWORK, self.count),)

    @property
    def notes(self) -> tuple[Message, ...]:
        """What the user should know of it, a line each."""
        model = self._model
        if self.pictures and not self.count:
            return (
                msg(
                    "warning: {file} (network {name}) found nobody in {pictures} with a "
                    "score from {least:.3g} on; lower detections.min_score, or check its TOML",
                    file=model.path.name,
                    name=model.name,
                    pictures=count_msg(self.pictures, "{n} picture", "{n} pictures"),
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
                boxes=count_msg(self.count, "{n} box", "{n} boxes"),
                pictures=count_msg(self.pictures, "{n} picture", "{n} pictures"),
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
) -> NetworkDetections | PictureDetections | None:
    """The boxes of the network, or of the plug-in's detector, that settings name; None: no one.

    Args:
        stereo: whether the tracker looks at both cameras.

    Raises FormatError where a network cannot be read or run, PluginError where a plug-in does not
    work.
    """
    if not settings.model:
        return None
    both = stereo and recording.is_stereo
    detector = named_detector(recording, settings.model)
    if detector is not None:
        return PictureDetections(detector, settings, both=both, looked_at=recording.looked_at)
    model = read_model(place_of(recording, settings.model))
    require_finder(model)
    return NetworkDetections(model, settings, both=both, looked_at=recording.looked_at)


def named_detector(recording: Recording, named: str) -> DetectorSpec | None:
    """The plug-in's detector of that name; None where a file has it, or none is installed.

    Raises PluginError where it does not work.
    """
    try:
        if (recording.folder / named).exists():
            return None
    except OSError:  # no file can be called that
        return None
    return picture_detector(named)

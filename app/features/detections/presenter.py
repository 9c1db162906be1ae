"""Which boxes of another program's detector the tracks that are shown were made with."""

from __future__ import annotations

from dataclasses import dataclass

from app.core.i18n import tr
from app.core.scenes import LegendEntry, Side
from app.core.scenes.detections import DETECTION, NO_DETECTIONS, PicturedDetections
from app.core.tracks.frame_state import FrameState
from app.core.tracks.made_by import AtWork, MadeBy
from tracking.arrays import Floats
from tracking.detections import DetectionSettings, RecordingDetections, load_detections, outside
from tracking.errors import FormatError
from tracking.networks.network_detections import NETWORK
from tracking.recording import Recording
from tracking.settings import settings_from
from tracking.tracks import DetectionsInput, Run
from tracking.tracks.columns import boxes_of as boxes_of_rows

_STAGE = "detections."
_CAMERAS = (Side.LEFT, Side.RIGHT)
"""In the order of `NETWORK_BOX_COLUMNS`."""


@dataclass(frozen=True, slots=True)
class UsedDetections:
    """The detections that a tracker used.

    Attributes:
        settings: which, and what of them is used.
        inputs: the files as they were then; none where it is at work still.
        outside: the file among them that only a session, not the user, names outside of the
            recording's folder, which is not read then; "": none.
    """

    settings: DetectionSettings
    inputs: tuple[DetectionsInput, ...] = ()
    outside: str = ""

    @classmethod
    def of(cls, run: MadeBy | None) -> UsedDetections | None:
        """Those of what made some tracks; None: it was given no file.

        Raises SettingsError where settings of another version say what this one does not know.
        """
        values = {} if run is None else dict(run.settings)
        if not values.get(f"{_STAGE}file"):
            return None
        own = {k.removeprefix(_STAGE): v for k, v in values.items() if k.startswith(_STAGE)}
        settings: DetectionSettings = settings_from(DetectionSettings, own)
        inputs = run.detections_input if isinstance(run, Run) else ()
        return cls(settings, inputs, "" if isinstance(run, AtWork) else outside(values))


def boxes_of(recording: Recording, given: UsedDetections) -> RecordingDetections | None:
    """Reads the boxes, on any thread.

    Raises FormatError where they cannot be read, are not those that the tracker was given, or lie
    where only the session says.
    """
    if given.outside:
        raise FormatError(
            "{file}: these detections, which the tracks were made with, are not in the folder of "
            "the recording; their boxes are not drawn",
            file=given.outside,
        )
    boxes = load_detections(recording, given.settings)
    if boxes is not None and given.inputs:
        for one in boxes.inputs:
            if not one.is_among(given.inputs):
                raise FormatError(
                    "{file} has changed since the tracks were made with it; its boxes are not "
                    "drawn",
                    file=one.file,
                )
    return boxes


def picture(boxes: RecordingDetections, side: Side, frame: int) -> PicturedDetections:
    """The boxes of a camera in a frame."""
    left = side is Side.LEFT
    found = boxes.of(frame) if left else boxes.of_right(frame)
    if found is None or not len(found):
        return NO_DETECTIONS
    return _pictured(found.box, boxes.inputs[0 if left else 1].file)


def network_of(run: MadeBy | None) -> str:
    """The name of the network that found people for some tracks; "": none did."""
    if run is None or not run.settings.get(f"{_STAGE}model"):
        return ""
    given = run.detections_input if isinstance(run, Run) else ()
    named = (one.network for one in given if one.format == NETWORK)
    return next(named, str(run.settings[f"{_STAGE}model"]))


def network_picture(state: FrameState, network: str, side: Side) -> PicturedDetections:
    """What a network found in the image of a camera that was tracked as this frame.

    The run has its boxes: neither the network nor its file is needed to draw them.
    """
    rows = state.tracks.network_boxes(state.frame)
    mine = rows["camera"] == _CAMERAS.index(side)
    return _pictured(boxes_of_rows(rows, mine), network) if mine.any() else NO_DETECTIONS


def _pictured(boxes: Floats, source: str) -> PicturedDetections:
    entry = LegendEntry(DETECTION, tr("boxes of {file}", file=source), dashed=True)
    rows = ((float(x), float(y), float(w), float(h)) for x, y, w, h in boxes.tolist())
    return PicturedDetections(tuple(rows), (entry,))

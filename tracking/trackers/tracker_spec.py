"""What the catalogue says of a tracker; plug-ins offer one, too."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass, field
from typing import Any, Final, Protocol

from tracking.people.detection_source import DetectionSource
from tracking.recording import Recording
from tracking.trackers.linking import Finisher
from tracking.trackers.shared.overlays import TrackerOverlays
from tracking.trackers.shared.protocol import Perception, Tracker

STEP_LIMIT_S: Final = 120.0
"""Networks on a slow processor take seconds a frame, and half a minute to begin."""


class Build(Protocol):
    """Makes a tracker."""

    def __call__(
        self,
        recording: Recording,
        settings: Any,
        seed: int,
        boxes: DetectionSource | None = None,
        /,
    ) -> tuple[Perception, Tracker]:
        """Perception and tracker at their start; see `TrackerSpec`."""


def _no_detector(settings: Mapping[str, Any]) -> str:  # noqa: ARG001 - of trackers that use one
    return ""


@dataclass(frozen=True, slots=True)
class TrackerSpec:
    """A tracker as the catalogue lists it.

    Attributes:
        name: on the command line and in sessions.
        title: for people, one line.
        paper: key of the source in the papers' list, e.g. "Kawashita2014"; "" for one of our own.
        needs_stereo, needs_calibration: of the recording.
        settings_type: a frozen dataclass; see `settings_fields`.
        build: (recording, settings, seed, boxes) -> perception and tracker, both at their start;
            boxes are those of another program that the settings name, None without any.
        detector: (settings by their dotted names) -> fingerprint of the failure detector they
            name; "" for none.
        finisher: how a run is looked over from both ends, where its settings say `smooth`.
        overlays: what a view can draw of its work.
        body_parts: its runs hold body parts, which can be labelled to train a failure detector.
        step_limit_s: of a plug-in's tracker that takes longer for a frame, or to begin, it is said
            that it hangs.
    """

    name: str
    title: str
    paper: str
    needs_stereo: bool
    needs_calibration: bool
    settings_type: type
    build: Build
    detector: Callable[[Mapping[str, Any]], str] = _no_detector
    finisher: Finisher = field(default_factory=Finisher)
    overlays: TrackerOverlays = field(default_factory=TrackerOverlays)
    body_parts: bool = False
    step_limit_s: float = STEP_LIMIT_S

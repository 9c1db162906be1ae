"""What tells where people are: formats of boxes of other programs, and detectors of plug-ins."""

from __future__ import annotations

from collections.abc import Mapping
from types import MappingProxyType

from tracking.detections.box_format import BoxFormat
from tracking.detections.detector import DetectorSpec
from tracking.detections.plugin_guard import guard_detector
from tracking.errors import PluginError
from tracking.plugins import Catalogue, PluginKind
from tracking.translation import Message, joined, msg

_HERE = "tracking.detections.box_format"
BUILT_IN: Mapping[str, str] = MappingProxyType(
    {"coco": f"{_HERE}:COCO", "mot": f"{_HERE}:MOT", "yolo": f"{_HERE}:YOLO"}
)
"""Where our own stand, in the order in which they are asked; pyproject.toml has the same."""

DETECTORS: Catalogue[BoxFormat | DetectorSpec] = Catalogue(
    PluginKind.DETECTOR, BUILT_IN, lambda: (BoxFormat, DetectorSpec), guard_detector
)
"""Formats of boxes, and what looks at pictures."""


def box_format_of(head: bytes) -> BoxFormat | None:
    """The format of a file by its first bytes, plug-ins last; None: nobody knows it."""
    for own in DETECTORS.of_built_in():
        if isinstance(own, BoxFormat) and own.recognises(head):
            return own
    for offer, each in DETECTORS.of_plugins():
        try:
            if isinstance(each, BoxFormat) and each.recognises(head):
                return each
        except PluginError as error:
            DETECTORS.note(offer, error)
    return None


def told_of_plugins() -> Message:
    """What did not work as plug-ins were asked, for a file that nobody knows; "": nothing."""
    return joined("; ", (msg("{error}", error=fault.error) for fault in DETECTORS.faults))


def picture_detectors() -> list[DetectorSpec]:
    """The detectors of plug-ins that look at pictures and work, by name."""
    return [each for _, each in DETECTORS.of_plugins() if isinstance(each, DetectorSpec)]


def picture_detector(name: str) -> DetectorSpec | None:
    """The detector of that name that looks at pictures; None: there is none.

    Raises PluginError where it does not work.
    """
    if name in BUILT_IN or name not in DETECTORS.names:
        return None
    found = DETECTORS[name]
    return found if isinstance(found, DetectorSpec) else None

"""Which failure detector the settings of a tracker name."""

from __future__ import annotations

from collections.abc import Mapping
from pathlib import Path
from typing import Any

from tracking.errors import FormatError
from tracking.failure import Detector, built_in_detector, load_detector
from tracking.translation import msg

NO_DETECTOR = msg(
    "no part-failure detector: lost parts are neither found nor put back; "
    "name one with --detector or the setting detector"
)


def chosen_detector(path: str) -> Detector | None:
    """The detector of a file, or the built-in one where none is named; None: there is none.

    Raises `FormatError` for a file that is named and cannot be read.
    """
    if path:
        return load_detector(Path(path))
    try:
        return built_in_detector()
    except FormatError:
        return None


def detector_fingerprint(settings: Mapping[str, Any]) -> str:
    """Which detector a run with these settings used; "" for none."""
    detector = chosen_detector(str(settings.get("detector", "")))
    return detector.fingerprint if detector is not None else ""

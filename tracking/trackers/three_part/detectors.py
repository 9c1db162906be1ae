"""Which failure detector the settings of a tracker name."""

from __future__ import annotations

from collections.abc import Mapping
from pathlib import Path
from typing import Any

from tracking.errors import FormatError
from tracking.failure import Detector, built_in_detector, load_detector
from tracking.translation import msg

BUILT_IN_DETECTORS = ("paper", "evidence")
"""Names of built-in detectors: by the features of [ZhaoLee2009] alone, and with evidence. Parts
are right about as often with either on footage of others, so the paper's is used unless told."""
NO_DETECTOR = msg(
    "no part-failure detector: lost parts are neither found nor put back; "
    "name one with --detector or the setting detector"
)


def chosen_detector(name: str) -> Detector | None:
    """The detector of a file, or a built-in one; None: there is none.

    Args:
        name: the file, or one of `BUILT_IN_DETECTORS`; "": the first of those.

    Raises `FormatError` for a file that is named and cannot be read.
    """
    if name and name not in BUILT_IN_DETECTORS:
        return load_detector(Path(name))
    try:
        return built_in_detector(paper=name != "evidence")
    except FormatError:
        return None


def detector_fingerprint(settings: Mapping[str, Any]) -> str:
    """Which detector a run with these settings used; "" for none."""
    detector = chosen_detector(str(settings.get("detector", "")))
    return detector.fingerprint if detector is not None else ""

"""Detectors that were trained here, kept so that trackers can use them."""

from __future__ import annotations

from app.core.document import document_loader
from app.core.document.detector_choice import DetectorChoice
from tracking.failure import Detector, save_detector


def keep_detector(detector: Detector) -> DetectorChoice:
    """A detector kept in the program's own folder; the choice that uses it.

    Raises OutputError, or OSError, where it cannot be written.
    """
    folder = document_loader.own_folder() / "detectors"
    folder.mkdir(parents=True, exist_ok=True)
    path = folder / detector_file_name(detector)
    save_detector(path, detector)
    return DetectorChoice(str(path))


def detector_file_name(detector: Detector) -> str:
    """Its file name there."""
    return f"trained-{detector.fingerprint}.h5"

"""What a path that is opened holds: a document, or what is no recording yet or several."""

from __future__ import annotations

from enum import Enum, auto
from pathlib import Path

from app.core.document.document_loader import OpenedDocument
from app.features.files import left_behind
from tracking.progress import Progress
from tracking.recording import OpenOptions
from tracking.setup.files import needs_setup


class Instead(Enum):
    """What is done with a folder that is no recording."""

    SETUP = auto()
    PROJECT = auto()


def read_path(
    path: Path, recording: Path | None, options: OpenOptions | None, report: Progress
) -> OpenedDocument | Instead:
    """What a path holds: a document, cameras to be set up first, or several recordings.

    Raises:
        TrackwrightError: it cannot be opened.
    """
    if options is None or options.left is None:
        if needs_setup(path):
            return Instead.SETUP
        if path.is_dir() and _holds_several(path):
            return Instead.PROJECT
    return left_behind.open_with_unsaved(path, recording, options, report)


def _holds_several(folder: Path) -> bool:
    from tracking.project.folder_scan import holds_several  # takes long to import

    return holds_several(folder)

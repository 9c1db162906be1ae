"""All kinds of recordings of other programs; to add one is a module and an entry here."""

from __future__ import annotations

from pathlib import Path

from tracking.recording.kinds.bag import BAG
from tracking.recording.kinds.euroc import EUROC
from tracking.recording.kinds.kind import FoundSources, RecordingKind
from tracking.recording.kinds.kitti import KITTI
from tracking.recording.kinds.oak import OAK
from tracking.recording.kinds.zed import ZED

KINDS: tuple[RecordingKind, ...] = (BAG, EUROC, KITTI, OAK, ZED)
"""In the order they are asked."""


def find_sources(path: Path) -> FoundSources | None:
    """What the first kind that knows a path finds there; None where none does.

    Raises:
        RecordingError: it is of a kind, and cannot be opened.
    """
    return next((found for kind in KINDS if (found := kind.find(path)) is not None), None)

"""Kinds of recordings of plug-ins: whatever goes wrong in them names them."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path
from typing import Any

from tracking.plugins import Offer, blaming
from tracking.plugins.blame import accused
from tracking.recording.kinds.kind import FoundSources, RecordingKind


def guard_kind(kind: RecordingKind, offer: Offer) -> RecordingKind:
    """The same kind, whose mistakes name the plug-in."""

    def find(path: Path) -> FoundSources | None:
        with blaming(offer):
            found: Any = kind.find(path)
        if found is None:
            return None
        if not isinstance(found, FoundSources):
            raise accused(
                offer, "find gave {found}, and should give FoundSources", found=type(found).__name__
            )
        files = (found.left, found.right, found.depth, *found.calibration)
        if not all(isinstance(one, Path) for one in files if one is not None):
            raise accused(offer, "its sources must be paths")
        return found

    return replace(kind, find=find)

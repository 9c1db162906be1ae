"""All kinds of recordings of other programs; to add one is a module and an entry here."""

from __future__ import annotations

from collections.abc import Mapping
from pathlib import Path
from types import MappingProxyType

from tracking.errors import PluginError
from tracking.plugins import Catalogue, PluginKind
from tracking.recording.kinds.kind import FoundSources, RecordingKind
from tracking.recording.kinds.plugin_guard import guard_kind
from tracking.translation import Message, joined, msg

_HERE = "tracking.recording.kinds"
BUILT_IN: Mapping[str, str] = MappingProxyType(
    {
        "bag": f"{_HERE}.bag:BAG",
        "euroc": f"{_HERE}.euroc:EUROC",
        "kitti": f"{_HERE}.kitti:KITTI",
        "oak": f"{_HERE}.oak:OAK",
        "zed": f"{_HERE}.zed:ZED",
    }
)
"""Where our own kinds stand, in the order they are asked; pyproject.toml has the same."""

KINDS: Catalogue[RecordingKind] = Catalogue(
    PluginKind.RECORDING, BUILT_IN, lambda: (RecordingKind,), guard_kind
)
"""Kinds of recordings of other programs: to add one is a module and an entry above."""


def find_sources(path: Path) -> FoundSources | None:
    """What the first kind that knows a path finds there, plug-ins last; None where none does.

    Raises:
        RecordingError: it is of a kind, and cannot be opened.
    """
    for own in KINDS.of_built_in():
        if (found := own.find(path)) is not None:
            return found
    for offer, kind in KINDS.of_plugins():
        try:
            if (found := kind.find(path)) is not None:
                return found
        except PluginError as error:
            KINDS.note(offer, error)
    return None


def told_of_plugins() -> Message:
    """What did not work as plug-ins were asked, for who finds nothing otherwise; "": nothing."""
    return joined("; ", (msg("{error}", error=fault.error) for fault in KINDS.faults))

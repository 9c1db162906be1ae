"""The kinds of plug-ins."""

from __future__ import annotations

from enum import StrEnum
from typing import Final

from tracking.translation import N_


class PluginKind(StrEnum):
    """What a plug-in adds; the value is the word that commands take."""

    TRACKER = "tracker"
    FORMAT = "format"
    RECORDING = "recording"
    DETECTOR = "detector"

    @property
    def group(self) -> str:
        """The group of entry points."""
        return f"trackwright.{self.value}s"

    @property
    def named(self) -> str:
        """A template: the kind and the {name} of one of it, for people."""
        return _NAMED[self]


_NAMED: Final = {
    PluginKind.TRACKER: N_("tracker {name}"),
    PluginKind.FORMAT: N_("format {name}"),
    PluginKind.RECORDING: N_("recording kind {name}"),
    PluginKind.DETECTOR: N_("detector {name}"),
}

"""By what tracker, with what settings, what is drawn was made."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any, Protocol, TypeVar

from tracking.errors import SettingsError
from tracking.trackers import settings_from, settings_values, tracker_named

Settings = TypeVar("Settings")


class MadeBy(Protocol):
    """What made the tracks that are shown: a run that is done, or a tracker at work."""

    @property
    def tracker(self) -> str:
        """Its name in the catalogue."""

    @property
    def settings(self) -> Mapping[str, Any]:
        """Those in force, by their dotted names."""


@dataclass(frozen=True, slots=True)
class AtWork:
    """A tracker at work with the settings it was given, by their dotted names."""

    tracker: str
    settings: Mapping[str, Any]

    @classmethod
    def of(cls, tracker: str, settings: Any = None) -> AtWork:
        """`settings`: an object of the tracker's kind; None: the usual ones.

        Raises:
            SettingsError: there is no such tracker.
        """
        usual = tracker_named(tracker).settings_type
        return cls(tracker, settings_values(usual() if settings is None else settings))


def settings_of(run: MadeBy | None, tracker: str, kind: type[Settings]) -> Settings:
    """Those of a run of the tracker; the usual ones of any other run, or where there is none."""
    if run is None or run.tracker != tracker:
        return kind()
    try:
        found = settings_from(kind, run.settings)
    except SettingsError:
        return kind()  # made by another version, whose settings were others
    assert isinstance(found, kind)
    return found

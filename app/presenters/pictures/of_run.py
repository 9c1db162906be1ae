"""The settings with which a run was made, for what is drawn of it."""

from __future__ import annotations

from typing import TypeVar

from tracking.errors import SettingsError
from tracking.trackers import settings_from
from tracking.tracks import Run

Settings = TypeVar("Settings")


def settings_of(run: Run | None, tracker: str, kind: type[Settings]) -> Settings:
    """Those of a run of the tracker; the usual ones of any other run, or where there is none."""
    if run is None or run.tracker != tracker:
        return kind()
    try:
        found = settings_from(kind, run.settings)
    except SettingsError:
        return kind()  # made by another version, whose settings were others
    assert isinstance(found, kind)
    return found

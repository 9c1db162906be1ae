"""By what tracker, with what settings, what is drawn was made."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass
from typing import Any, Protocol, TypeVar

from tracking.errors import SettingsError
from tracking.trackers import (
    TrackerOverlays,
    TrackerSpec,
    settings_from,
    settings_values,
    tracker_named,
    tracker_with,
)

Overlay = TypeVar("Overlay")


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


def overlay_of(
    run: MadeBy | None, kind: Callable[[TrackerOverlays], Overlay | None]
) -> tuple[Overlay, Any]:
    """What draws a kind of overlay, and the settings it is drawn with.

    Those of the run, where its tracker has such an overlay; else of the best tracker that has one,
    with its usual settings.
    """
    spec = tracker_with(lambda one: kind(one.overlays), run.tracker if run is not None else "")
    overlay = kind(spec.overlays)
    assert overlay is not None
    return overlay, settings_of(run, spec)


def settings_of(run: MadeBy | None, spec: TrackerSpec) -> Any:
    """Those of a run of the tracker; the usual ones of any other run, or where there is none."""
    usual = spec.settings_type()
    if run is None or run.tracker != spec.name:
        return usual
    try:
        return settings_from(spec.settings_type, run.settings)
    except SettingsError:
        return usual  # made by another version, whose settings were others

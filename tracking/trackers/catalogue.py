"""The catalogue: every tracker that is built in or plugged in, by the name it has everywhere."""

from __future__ import annotations

import difflib
from collections.abc import Callable, Mapping
from types import MappingProxyType
from typing import Any

from tracking.errors import CalibrationError, RecordingError, SettingsError
from tracking.plugins import Catalogue, PluginKind
from tracking.recording import Recording
from tracking.settings import (
    former_names,
    settings_fields,
    settings_from_text,
    settings_values,
    with_present_names,
)
from tracking.trackers.plugin_guard import guard_tracker
from tracking.trackers.tracker_spec import TrackerSpec
from tracking.translation import count_msg, joined, msg

_HERE = "tracking.trackers.built_in"
BUILT_IN: Mapping[str, str] = MappingProxyType(
    {
        "stereo-joint": f"{_HERE}.stereo_joint:STEREO_JOINT",
        "stereo-direction": f"{_HERE}.stereo:STEREO_DIRECTION",
        "stereo-colour": f"{_HERE}.stereo:STEREO_COLOUR",
        "spheroid": f"{_HERE}.spheroid:SPHEROID",
        "three-part": f"{_HERE}.three_part:THREE_PART",
        "three-part-joint": f"{_HERE}.three_part:THREE_PART_JOINT",
        "whole-body": f"{_HERE}.three_part:WHOLE_BODY",
        "flow": f"{_HERE}.flow:FLOW",
    }
)
"""Where our own trackers stand, the best first; pyproject.toml has the same as entry points."""

TRACKERS: Catalogue[TrackerSpec] = Catalogue(
    PluginKind.TRACKER, BUILT_IN, lambda: (TrackerSpec,), guard_tracker
)
"""The trackers that can be run, the best first, then those of plug-ins."""

_NOTHING = ("", "[]")
_WITHOUT = " (without, three-part tracks people in pixels)"


def tracker_named(name: str) -> TrackerSpec:
    """The tracker of that name.

    Raises `SettingsError` that says what there is, `PluginError` where a plug-in does not work.
    """
    if name in TRACKERS.names:
        return TRACKERS[name]
    near = difflib.get_close_matches(name, TRACKERS.names, n=1)
    raise SettingsError(
        "tracker {name} is unknown: did you mean {near}? Available are {trackers}"
        if near
        else "tracker {name} is unknown: available are {trackers}",
        name=name,
        near="".join(near),
        trackers=joined(", ", TRACKERS.names),
    )


def best_tracker(recording: Recording) -> str:
    """The name of the best tracker: two cameras over a known floor, one over it, or neither."""
    measured = recording.rectification is not None and recording.ground is not None
    if measured:
        return "stereo-joint"
    return "three-part" if recording.view is None else "spheroid"


def tracker_with(able: Callable[[TrackerSpec], object], preferred: str = "") -> TrackerSpec:
    """The preferred tracker where it is able to do something, else the best one that is.

    Raises LookupError where none is.
    """
    for name in (preferred, *TRACKERS.names):
        spec = TRACKERS.get(name)
        if spec is not None and able(spec):
            return spec
    raise LookupError("no tracker of the catalogue can do this")


def body_part_tracker() -> str:
    """The name of the best tracker that follows body parts."""
    return tracker_with(lambda spec: spec.body_parts).name


def detector_of(name: str, settings: Mapping[str, Any]) -> str:
    """Fingerprint of the failure detector a run of that tracker used; "" for none."""
    spec = TRACKERS.get(name)
    return spec.detector(settings) if spec is not None else ""


_GONE = frozenset({"foreground.learn_s"})
"""Settings of earlier versions that did nothing in any tracker."""


def present_settings(name: str, settings: Mapping[str, Any]) -> dict[str, Any]:
    """A kept run's settings by their present names, whatever version of the tracker made it.

    Those that never did anything are left out. Those of a tracker that is not in the catalogue stay
    as they are.
    """
    spec = TRACKERS.get(name)
    if spec is None:
        return dict(settings)
    settings = {key: value for key, value in settings.items() if key not in _GONE}
    return with_present_names(spec.settings_type, settings)


def changed_settings(name: str, settings: Mapping[str, Any]) -> dict[str, Any]:
    """Of a run's settings, by their dotted names, those that are not that tracker's defaults.

    Of a tracker that is not in the catalogue all of them. Nothing, written as no text or as an
    empty list, is no change from nothing.
    """
    spec = TRACKERS.get(name)
    defaults = {} if spec is None else settings_values(spec.settings_type())
    return {
        key: value
        for key, value in settings.items()
        if key not in defaults or not _is_same(defaults[key], value)
    }


def _is_same(default: Any, value: Any) -> bool:
    return bool(default == value) or (default in _NOTHING and value in _NOTHING)


def require(spec: TrackerSpec, recording: Recording) -> None:
    """Check that the tracker can work on the recording.

    Raises `RecordingError` for a missing camera, `CalibrationError` for a missing calibration or
    floor.
    """
    if spec.needs_stereo and not (recording.is_stereo or recording.has_depth):
        raise RecordingError(
            "recording {name} has one camera: {tracker} needs two; choose {better}",
            name=recording.name,
            tracker=spec.name,
            better=best_tracker(recording),
        )
    if spec.needs_calibration and recording.calibration is None:
        raise CalibrationError(
            "recording {name} has no calibration: {tracker} needs one{to_do}",
            "name it under [calibration] in recording.toml",
            option="--calibration",
            name=recording.name,
            tracker=spec.name,
            to_do=_WITHOUT,
        )
    if spec.needs_calibration and recording.ground is None:
        raise CalibrationError(
            "recording {name} does not say where the floor is, as {tracker} needs it{to_do}",
            "write height and tilt under [ground] in recording.toml",
            option="--height and --tilt",
            name=recording.name,
            tracker=spec.name,
            to_do=_WITHOUT,
        )


def parse_settings(spec: TrackerSpec, texts: Mapping[str, str]) -> Any:
    """The tracker's settings with some values given as text, e.g. {"particles": "700"}.

    Raises `SettingsError`: unknown name, with the trackers that have such a setting if any has;
    no value of its type; or out of range.
    """
    known = _setting_names(spec) | former_names(spec.settings_type).keys()
    for name in sorted(texts.keys() - known):
        present = _present_name(name)
        if theirs := [
            other.name for other in TRACKERS.values() if present in _setting_names(other)
        ]:
            now = msg(", whose name is {present} now", present=present)
            raise SettingsError(
                "{tracker} has no setting {name}{now} ({who}): choose such a tracker with "
                "--tracker, or leave the setting out",
                tracker=spec.name,
                name=name,
                now="" if present == name else now,
                who=count_msg(
                    len(theirs),
                    "{trackers} has it",
                    "{trackers} have it",
                    trackers=joined(", ", theirs),
                ),
            )
    return settings_from_text(spec.settings_type, texts)


def _present_name(name: str) -> str:
    """The name that a setting of any tracker has now; other names as they are."""
    former = (former_names(spec.settings_type) for spec in TRACKERS.values())
    return next((present[name] for present in former if name in present), name)


def _setting_names(spec: TrackerSpec) -> frozenset[str]:
    """The dotted names of a tracker's settings."""
    return frozenset(field.name for field in settings_fields(spec.settings_type))

"""The catalogue: every tracker that is built, by the name it has everywhere."""

from __future__ import annotations

import difflib
from collections.abc import Callable, Mapping
from dataclasses import dataclass, field
from types import MappingProxyType
from typing import Any, Protocol

from tracking.errors import CalibrationError, RecordingError, SettingsError
from tracking.people.detection_source import DetectionSource
from tracking.recording import Recording
from tracking.settings import (
    former_names,
    settings_fields,
    settings_from_text,
    settings_values,
    with_present_names,
)
from tracking.trackers.flow import (
    FLOW_OVERLAYS,
    FlowSettings,
    build_flow,
    extend_trajectories,
    link_walkers,
)
from tracking.trackers.joint import JointSettings, build_joint
from tracking.trackers.linking import (
    Finisher,
    Published,
    extend_ends_in_pixels,
    link_tracks,
)
from tracking.trackers.shared.overlays import TrackerOverlays
from tracking.trackers.shared.protocol import Perception, Tracker
from tracking.trackers.spheroid import SPHEROID_OVERLAYS, SpheroidSettings, build_spheroid
from tracking.trackers.stereo import colour as stereo_colour
from tracking.trackers.stereo import direction as stereo_direction
from tracking.trackers.three_part import (
    ThreePartSettings,
    WholeBodySettings,
    build_three_part,
    build_three_part_joint,
    build_whole_body,
    detector_fingerprint,
    link_refined,
)
from tracking.translation import count_msg, joined, msg


class Build(Protocol):
    """Makes a tracker."""

    def __call__(
        self,
        recording: Recording,
        settings: Any,
        seed: int,
        boxes: DetectionSource | None = None,
        /,
    ) -> tuple[Perception, Tracker]:
        """Perception and tracker at their start; see `TrackerSpec`."""


def _no_detector(settings: Mapping[str, Any]) -> str:  # noqa: ARG001 - of trackers that use one
    return ""


@dataclass(frozen=True, slots=True)
class TrackerSpec:
    """A tracker as the catalogue lists it.

    Attributes:
        name: on the command line and in sessions.
        title: for people, one line.
        paper: key of the source in the papers' list, e.g. "Kawashita2014"; "" for one of our own.
        needs_stereo, needs_calibration: of the recording.
        settings_type: a frozen dataclass; see `settings_fields`.
        build: (recording, settings, seed, boxes) -> perception and tracker, both at their start;
            boxes are those of another program that the settings name, None without any.
        detector: (settings by their dotted names) -> fingerprint of the failure detector they
            name; "" for none.
        finisher: how a run is looked over from both ends, where its settings say `smooth`.
        overlays: what a view can draw of its work.
        body_parts: its runs hold body parts, which can be labelled to train a failure detector.
    """

    name: str
    title: str
    paper: str
    needs_stereo: bool
    needs_calibration: bool
    settings_type: type
    build: Build
    detector: Callable[[Mapping[str, Any]], str] = _no_detector
    finisher: Finisher = field(default_factory=Finisher)
    overlays: TrackerOverlays = field(default_factory=TrackerOverlays)
    body_parts: bool = False


_TWO_CAMERAS = TrackerOverlays(subtraction=True)

_FLOW_PATH_MEMORY_S = 0.25
"""Places seen by one camera err for longer than those of two do: more of them make a path."""
_LIVE_IF_PAPER = Finisher(published=Published((("paper", True),), smoothed=False))
_THREE_PART = Finisher(
    relabel=link_refined,
    extend_in_pixels=extend_ends_in_pixels,
    published=Published((("adjust", False), ("reidentify", False)), smoothed=False),
)

_BUILT = (
    TrackerSpec(
        name="stereo-joint",
        title="Two cameras: joint assignment of all tracks by position, appearance and direction",
        paper="",
        needs_stereo=True,
        needs_calibration=True,
        settings_type=JointSettings,
        build=build_joint,
        finisher=Finisher(relabel=link_tracks),
        overlays=_TWO_CAMERAS,
    ),
    TrackerSpec(
        name="stereo-direction",
        title="Two cameras: particle filter with distance, colour and walking direction",
        paper="Kawashita2014",
        needs_stereo=True,
        needs_calibration=True,
        settings_type=stereo_direction.StereoDirectionSettings,
        build=stereo_direction.build,
        finisher=_LIVE_IF_PAPER,
        overlays=_TWO_CAMERAS,
    ),
    TrackerSpec(
        name="stereo-colour",
        title="Two cameras: particle filter with distance and colour",
        paper="Kawashita2012",
        needs_stereo=True,
        needs_calibration=True,
        settings_type=stereo_colour.StereoColourSettings,
        build=stereo_colour.build,
        finisher=_LIVE_IF_PAPER,
        overlays=_TWO_CAMERAS,
    ),
    TrackerSpec(
        name="spheroid",
        title="One calibrated camera: particle filter on the floor, weighted by silhouettes",
        paper="Waechter2013",
        needs_stereo=False,
        needs_calibration=True,
        settings_type=SpheroidSettings,
        build=build_spheroid,
        finisher=Finisher(relabel=link_tracks, published=Published((("paper", True),))),
        overlays=SPHEROID_OVERLAYS,
    ),
    TrackerSpec(
        name="three-part",
        title="One camera: one particle filter each for head, torso and hip-leg, with adjustment",
        paper="ZhaoLee2009",
        needs_stereo=False,
        needs_calibration=False,
        settings_type=ThreePartSettings,
        build=build_three_part,
        detector=detector_fingerprint,
        finisher=_THREE_PART,
        body_parts=True,
    ),
    TrackerSpec(
        name="three-part-joint",
        title="One camera: one particle filter for head, torso and hip-leg together",
        paper="ZhaoLee2009",
        needs_stereo=False,
        needs_calibration=False,
        settings_type=ThreePartSettings,
        build=build_three_part_joint,
        detector=detector_fingerprint,
        finisher=_THREE_PART,
        body_parts=True,
    ),
    TrackerSpec(
        name="whole-body",
        title="One camera: particle filter for the whole body, for comparison",
        paper="ZhaoLee2009",
        needs_stereo=False,
        needs_calibration=False,
        settings_type=WholeBodySettings,
        build=build_whole_body,
    ),
    TrackerSpec(
        name="flow",
        title="One calibrated camera: tracklets clustered into people, for counting",
        paper="Yoneji2013",
        needs_stereo=False,
        needs_calibration=True,
        settings_type=FlowSettings,
        build=build_flow,
        finisher=Finisher(
            relabel=link_walkers,
            path_memory_s=_FLOW_PATH_MEMORY_S,
            extend=extend_trajectories,
            published=Published((("persistent_points", False),)),
        ),
        overlays=FLOW_OVERLAYS,
    ),
)

TRACKERS: Mapping[str, TrackerSpec] = MappingProxyType({spec.name: spec for spec in _BUILT})
"""The trackers that can be run, the best first."""

_NOTHING = ("", "[]")
_WITHOUT = " (without, three-part tracks people in pixels)"


def tracker_named(name: str) -> TrackerSpec:
    """The tracker of that name; raises `SettingsError` that says what there is."""
    if name in TRACKERS:
        return TRACKERS[name]
    near = difflib.get_close_matches(name, TRACKERS, n=1)
    raise SettingsError(
        "tracker {name} is unknown: did you mean {near}? Available are {trackers}"
        if near
        else "tracker {name} is unknown: available are {trackers}",
        name=name,
        near="".join(near),
        trackers=joined(", ", TRACKERS),
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
    for name in (preferred, *TRACKERS):
        if name in TRACKERS and able(TRACKERS[name]):
            return TRACKERS[name]
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
        if theirs := [other.name for other in _BUILT if present in _setting_names(other)]:
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
    former = (former_names(spec.settings_type) for spec in _BUILT)
    return next((present[name] for present in former if name in present), name)


def _setting_names(spec: TrackerSpec) -> frozenset[str]:
    """The dotted names of a tracker's settings."""
    return frozenset(field.name for field in settings_fields(spec.settings_type))

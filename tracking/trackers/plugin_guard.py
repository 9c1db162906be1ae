"""Trackers of plug-ins: what they raise and what they give is checked, and they are named."""

from __future__ import annotations

import dataclasses
import re
from collections.abc import Callable, Iterable, Mapping, Sequence
from functools import wraps
from typing import Any, ParamSpec, TypeVar

import numpy as np

from tracking.people.observation import Observation
from tracking.people.stereo_watch import StereoWatch
from tracking.plugins import Offer, blaming
from tracking.plugins.blame import accused, guarded, guarded_drawing
from tracking.plugins.time_limit import in_time
from tracking.recording.frame import StereoFrame
from tracking.settings import settings_fields
from tracking.trackers.linking import Finisher
from tracking.trackers.shared.overlays import (
    EvaluationOverlay,
    RampSource,
    RegionOfEvaluation,
    TrackerOverlays,
)
from tracking.trackers.shared.protocol import Perception, StepResult, Tracker
from tracking.trackers.shared.resumption import Resume
from tracking.trackers.step_check import checked_observation, checked_step
from tracking.trackers.tracker_spec import Build, TrackerSpec
from tracking.translation import Message

P = ParamSpec("P")
R = TypeVar("R")
_NAME = re.compile(r"[a-z][a-z0-9]*(-[a-z0-9]+)*")


def guard_tracker(spec: TrackerSpec, offer: Offer) -> TrackerSpec:
    """The same tracker, whose mistakes name the plug-in. Raises PluginError for a wrong entry."""
    _check_entry(spec, offer)
    return dataclasses.replace(
        spec,
        build=_guarded_build(spec.build, offer),
        detector=guarded(spec.detector, offer),
        finisher=_guarded_finisher(spec, offer),
        overlays=_guarded_overlays(spec.overlays, offer),
    )


def _check_entry(spec: TrackerSpec, offer: Offer) -> None:
    if _NAME.fullmatch(spec.name) is None:
        raise accused(
            offer, "its name must be of small letters and digits, with single hyphens between"
        )
    if not dataclasses.is_dataclass(spec.settings_type):
        raise accused(offer, "its settings_type is no dataclass")
    with blaming(offer):
        fields = settings_fields(spec.settings_type)
    for field in fields:
        if field.type not in (bool, int, float, str):
            raise accused(
                offer, "its setting {name} is no number, text or true and false", name=field.name
            )


def _guarded_finisher(spec: TrackerSpec, offer: Offer) -> Finisher:
    """The same finisher, in its time: a window waits for it."""
    finisher = spec.finisher

    def limited(call: Callable[P, R] | None) -> Callable[P, R] | None:
        if call is None:
            return None

        @wraps(call)
        def within(*given: P.args, **named: P.kwargs) -> R:
            return in_time(lambda: call(*given, **named), offer, spec.step_limit_s)

        return within

    return dataclasses.replace(
        finisher,
        relabel=limited(finisher.relabel),
        extend=limited(finisher.extend),
        extend_in_pixels=limited(finisher.extend_in_pixels),
    )


def _guarded_overlays(overlays: TrackerOverlays, offer: Offer) -> TrackerOverlays:
    """The same overlays, without which a view goes on where they fail."""
    kernel, outlines = overlays.kernel, overlays.outlines
    evaluation, ramp = overlays.evaluation, overlays.ramp
    if kernel is not None:
        kernel = guarded_drawing(
            kernel,
            offer,
            lambda drawn: _is_shape(drawn, 4),
            lambda _view, _settings, xy: np.full((len(xy), 4, 2), np.nan),
        )
    if outlines is not None:
        outlines = guarded_drawing(
            outlines,
            offer,
            lambda drawn: _is_shape(drawn),
            lambda _view, _settings, bodies, points: np.full((len(bodies.xy), points, 2), np.nan),
        )
    if evaluation is not None:
        draw = guarded_drawing(
            evaluation.draw,
            offer,
            _is_region,
            lambda *_: RegionOfEvaluation(_NO_OUTLINE, _NO_MASKS),
        )
        evaluation = EvaluationOverlay(evaluation.setting, draw)
    return dataclasses.replace(
        overlays,
        kernel=kernel,
        outlines=outlines,
        evaluation=evaluation,
        ramp=None if ramp is None else _guarded_ramp(ramp, offer),
    )


_NO_OUTLINE, _NO_MASKS = np.zeros((3, 2)), np.zeros((0, 3, 2))


def _is_shape(drawn: Any, points: int = 0) -> bool:
    """Whether it is (n, points, 2) numbers."""
    if not isinstance(drawn, np.ndarray) or drawn.dtype.kind != "f" or drawn.ndim != 3:
        return False
    _, corners, axes = drawn.shape
    return axes == 2 and points in (0, corners)


def _is_region(drawn: Any) -> bool:
    return (
        isinstance(drawn, RegionOfEvaluation)
        and _is_shape(drawn.outline[None])
        and _is_shape(drawn.masked)
    )


def _guarded_ramp(build: Callable[..., RampSource], offer: Offer) -> Callable[..., RampSource]:
    class Guarded:
        """Ramp images of a plug-in."""

        def __init__(self, *given: Any) -> None:
            with blaming(offer):
                self._inner = build(*given)

        def learn(self, frames: Sequence[StereoFrame], later: Sequence[StereoFrame] = ()) -> None:
            with blaming(offer):
                self._inner.learn(frames, later)

        def ramp_picture(self, frame: StereoFrame) -> Any:
            with blaming(offer):
                return self._inner.ramp_picture(frame)

    return Guarded


def _guarded_build(build: Build, offer: Offer) -> Build:
    def guarded(*given: Any) -> tuple[Perception, Tracker]:
        with blaming(offer):
            perception, tracker = build(*given)
        return GuardedPerception(perception, offer), GuardedTracker(tracker, offer)

    return guarded


class GuardedPerception:
    """Perception of a plug-in: a `Perception`."""

    def __init__(self, inner: Perception, offer: Offer) -> None:
        self._inner, self._offer = inner, offer

    @property
    def stereo_watch(self) -> StereoWatch | None:
        """See `Perception`."""
        with blaming(self._offer):
            return self._inner.stereo_watch

    @property
    def notes(self) -> tuple[Message, ...]:
        """See `Perception`."""
        with blaming(self._offer):
            return _checked_notes(self._inner.notes)

    def learn(self, frames: Sequence[StereoFrame], later: Sequence[StereoFrame] = ()) -> None:
        """See `Perception`."""
        with blaming(self._offer):
            self._inner.learn(frames, later)

    def observe(self, frame: StereoFrame) -> Observation:
        """See `Perception`; what it gives is checked."""
        with blaming(self._offer):
            observed = self._inner.observe(frame)
        return checked_observation(observed, frame.number, self._offer)


class GuardedTracker:
    """A tracker of a plug-in: a `Tracker`."""

    def __init__(self, inner: Tracker, offer: Offer) -> None:
        self._inner, self._offer = inner, offer

    @property
    def stage_s(self) -> Mapping[str, float]:
        """Seconds by stage, where it tells them."""
        found = getattr(self._inner, "stage_s", {})
        return found if isinstance(found, Mapping) else {}

    @property
    def settings(self) -> Any:
        """See `Tracker`."""
        with blaming(self._offer):
            return self._inner.settings

    @property
    def notes(self) -> tuple[Message, ...]:
        """See `Tracker`."""
        with blaming(self._offer):
            return _checked_notes(self._inner.notes)

    def resume(self, resume: Resume, observations: Iterable[Observation]) -> None:
        """See `Tracker`."""
        with blaming(self._offer):
            self._inner.resume(resume, observations)

    def step(self, observation: Observation) -> StepResult:
        """See `Tracker`; what it gives is checked."""
        with blaming(self._offer):
            result = self._inner.step(observation)
        return checked_step(result, observation.frame, self._offer)


def _checked_notes(notes: Iterable[object]) -> tuple[Message, ...]:
    """Notes as messages, however a plug-in wrote them."""
    return tuple(
        one if isinstance(one, Message) else Message("{said}", said=str(one)) for one in notes
    )

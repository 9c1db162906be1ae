"""A tracker over a recording, frame by frame: decode, rectify, see, follow, keep."""

from __future__ import annotations

from collections.abc import Generator, Iterator, Mapping, Sequence
from functools import partial
from types import TracebackType
from typing import Any

import numpy as np
from numpy.typing import NDArray

import tracking
from tracking.errors import SettingsError
from tracking.people import RangedShare
from tracking.recording import Recording, StereoFrame
from tracking.trackers import (
    ASSOCIATION_COLUMNS,
    Observation,
    Perception,
    Resume,
    StepResult,
    Tracker,
    TrackerSpec,
    best_tracker,
    detector_of,
    require,
    settings_values,
    tracker_named,
)
from tracking.trackers.stages import Stages
from tracking.tracks.columns import (
    DETECTION_COLUMNS,
    PART_COLUMNS,
    PART_PARTICLE_COLUMNS,
    PARTICLE_COLUMNS,
    SIGNAL_COLUMNS,
    TRACK_COLUMNS,
    TRACKLET_COLUMNS,
    Columns,
    empty,
)
from tracking.tracks.run import Particles, Run

BACKGROUND_SAMPLES = 15
"""Frames spread over the recording that the background is learnt from before the first step."""

_TIED_S = 1.0
"""Of corrected tracks before the first frame, which smoothed tracks begin at."""


def track(
    recording: Recording,
    tracker: str | None = None,
    settings: Any = None,
    seed: int = 0,
    frames: tuple[int, int] | None = None,
    resume: Resume | None = None,
) -> Tracking:
    """Start a tracker on a recording; nothing is read until the first step is asked for.

    Args:
        recording: where the frames come from; stays open until the tracking is closed.
        tracker: name in the catalogue; None takes the best one for the recording.
        settings: of the tracker's `settings_type`; None takes the defaults.
        seed: of all random numbers; the same seed gives the same arrays, byte for byte.
        frames: half-open range to track; None takes the whole recording, from where to resume.
        resume: tracks again from a frame of corrected tracks on, with their people: ids go on.

    Raises `SettingsError` for an unknown tracker, an empty range or one that does not begin where
    to resume, `RecordingError` or `CalibrationError` where the tracker cannot work on the
    recording.
    """
    spec = tracker_named(tracker or best_tracker(recording))
    require(spec, recording)
    first = resume.frame if resume is not None else 0
    start, stop = frames or (first, recording.frame_count)
    if not 0 <= start < stop <= recording.frame_count:
        raise SettingsError(
            f"frames {start}:{stop} are not in the recording: "
            f"choose a range within 0:{recording.frame_count}"
        )
    if resume is not None and start != first:
        raise SettingsError(
            f"frames {start}:{stop} do not begin at frame {first}, where to go on: "
            f"choose {first}:{stop}"
        )
    settings = settings or spec.settings_type()
    return Tracking(recording, spec, settings, seed, (start, stop), resume)


class Tracking:
    """A tracker at work: iterate for a `StepResult` a frame, close to cancel.

    The background is learnt first, from frames spread over the whole recording, so that a range
    that starts late and a scene that starts with people are seen like any other. All calls belong
    to one thread.

    Attributes:
        frames: half-open range being tracked. done: frames of it tracked so far.
        observation: what was seen in the last frame, with its overlays; None before the first.
    """

    def __init__(
        self,
        recording: Recording,
        spec: TrackerSpec,
        settings: Any,
        seed: int,
        frames: tuple[int, int],
        resume: Resume | None = None,
    ) -> None:
        """See `track`."""
        self.frames = frames
        self.done = 0
        self.observation: Observation | None = None
        self._stages = Stages("learn", "decode", "perception", "tracker")
        self._recording = recording
        self._spec = spec
        self._settings = settings
        self._seed = seed
        self._resume = resume
        self._tracker: Tracker | None = None
        self._results: list[StepResult] = []
        self._ranged = RangedShare()
        self._steps = self._work()

    def __iter__(self) -> Iterator[StepResult]:
        return self

    def __next__(self) -> StepResult:
        return next(self._steps)

    def __enter__(self) -> Tracking:
        return self

    def __exit__(
        self,
        kind: type[BaseException] | None,
        error: BaseException | None,
        trace: TracebackType | None,
    ) -> None:
        self.close()

    def close(self) -> None:
        """Stop; what was tracked so far stays available from `run`."""
        self._steps.close()

    def run(self) -> Run:
        """Everything tracked so far as one immutable run."""
        return run_of_steps(
            self._results,
            self._spec.name,
            settings_values(self._settings),
            self._seed,
            self.frames[0],
            self._recording,
            self._resume,
        )

    @property
    def stage_s(self) -> dict[str, float]:
        """Seconds spent so far in "learn", "decode", "perception" and "tracker".

        Of a tracker that tells its own stages those, too: "tracker_filters" and so on.
        """
        inner: Mapping[str, float] = getattr(self._tracker, "stage_s", {})
        return {**self._stages.spent_s, **{f"tracker_{name}": s for name, s in inner.items()}}

    @property
    def notes(self) -> tuple[str, ...]:
        """What the user should be told of the frames tracked so far, a line each."""
        told = self._tracker.notes if self._tracker is not None else ()
        followed = any(len(result.tracks["track"]) for result in self._results)
        if followed or not self._spec.needs_stereo or not self._ranged.is_too_small:
            return told
        swapped = f"{self._recording.name}: no distance for what moves: are the eyes swapped?"
        return (*told, swapped)

    def _work(self) -> Generator[StepResult]:
        timed = self._stages.timed
        perception, tracker = self._spec.build(self._recording, self._settings, self._seed)
        self._tracker = tracker
        timed("learn", _learn, perception, self._recording)
        if self._resume is not None:
            seen = (perception.observe(self._recording.read(n)) for n in self._resume.looks)
            timed("learn", tracker.resume, self._resume, seen)
        pictures = self._recording.frames(*self.frames)
        while (frame := timed("decode", next, pictures, None)) is not None:
            self.observation = timed("perception", perception.observe, frame)
            self._ranged.add(self.observation.overlays)
            result = timed("tracker", tracker.step, self.observation)
            self._results.append(result)
            self.done += 1
            yield result


def background_samples(recording: Recording) -> list[StereoFrame]:
    """Frames spread evenly over the recording; raises `RecordingError` where one is unreadable."""
    count = min(BACKGROUND_SAMPLES, recording.frame_count)
    numbers = np.linspace(0, recording.frame_count - 1, count).astype(int)
    return [recording.read(int(number)) for number in numbers]


def run_of_steps(
    steps: Sequence[StepResult],
    tracker: str,
    settings: Mapping[str, Any],
    seed: int,
    start: int,
    recording: Recording,
    resume: Resume | None = None,
) -> Run:
    """The steps of a tracker, in order from frame `start` on, as one immutable run.

    `settings` are plain values by their dotted names. With `smooth` among them, the tracks take
    into account what came later (see `TrackerSpec.finish`); the steps stay as they were. A paper's
    own method, with `paper`, ends with its steps.
    `resume`: what the tracker went on from, if it did; the smoothed tracks begin there.
    """
    offsets = partial(_offsets, [step.frame for step in steps], recording.frame_count)
    particles = [step.particles for step in steps]
    part_particles = [step.part_particles for step in steps]
    tracklets = [step.tracklets for step in steps]
    run = Run(
        tracker=tracker,
        settings=settings,
        seed=seed,
        frames=(start, start + len(steps)),
        tracks=_joined([step.tracks for step in steps], TRACK_COLUMNS),
        detections=_joined([step.detections for step in steps], DETECTION_COLUMNS),
        particles=Particles(offsets(particles), _joined(particles, PARTICLE_COLUMNS)),
        associations=_joined([step.associations for step in steps], ASSOCIATION_COLUMNS),
        signals=_joined([step.signals for step in steps], SIGNAL_COLUMNS),
        parts=_joined([step.parts for step in steps], PART_COLUMNS),
        part_particles=Particles(
            offsets(part_particles), _joined(part_particles, PART_PARTICLE_COLUMNS)
        ),
        tracklets=Particles(offsets(tracklets), _joined(tracklets, TRACKLET_COLUMNS)),
        software=f"trackwright {tracking.__version__}",
        detector=detector_of(tracker, settings),
        known_tracks=resume.highest_track if resume is not None else 0,
    )
    plain = settings.get("paper") or not settings.get("smooth")
    if plain or recording.view is None:
        return run
    given = resume.last(_TIED_S) if resume is not None else None
    return tracker_named(tracker).finish(run, recording.view, recording.fps, given)


def _learn(perception: Perception, recording: Recording) -> None:
    perception.learn(background_samples(recording))


def _joined(parts: Sequence[Columns], columns: Mapping[str, np.dtype[Any]]) -> Columns:
    """The parts one below the other."""
    if not parts:
        return empty(columns)
    return {name: np.concatenate([part[name] for part in parts]) for name in columns}


def _offsets(
    frames: Sequence[int], frame_count: int, parts: Sequence[Columns]
) -> NDArray[np.int64]:
    """(frame_count + 1,) where the rows of each frame of the recording begin, parts joined.

    Args:
        frames: of each part.
    """
    counts = np.zeros(frame_count + 1, np.int64)
    for frame, part in zip(frames, parts, strict=True):
        counts[frame + 1] = len(part["track"])
    return np.cumsum(counts)

"""A tracker over a recording, frame by frame: decode, rectify, see, follow, keep."""

from __future__ import annotations

from collections.abc import Generator, Iterator, Mapping
from dataclasses import replace
from functools import partial
from pathlib import Path
from typing import Any

import numpy as np

from tracking.detections import (
    RecordingDetections,
    detections_stage,
    load_detections,
    with_relative_paths,
)
from tracking.detections.picture_detections import PictureDetections
from tracking.errors import SettingsError
from tracking.networks.appearance_network import AppearanceNetwork, appearance_network
from tracking.networks.network_detections import NetworkDetections, network_detections
from tracking.people import RangedShare, StereoWatch, first_lag
from tracking.pipeline.run_buffer import KeptSteps
from tracking.pipeline.set_up import changed_matching, doubt_of, require_sense
from tracking.pipeline.track_embeddings import TrackEmbeddings
from tracking.progress import Progress, no_progress
from tracking.recording import Instants, Recording, StereoFrame
from tracking.trackers import (
    Observation,
    Perception,
    Resume,
    StepResult,
    Tracker,
    TrackerSpec,
    best_tracker,
    require,
    settings_values,
    tracker_named,
)
from tracking.trackers.shared.stages import Stages
from tracking.tracks import DetectionsInput, Run
from tracking.translation import Message, msg

BACKGROUND_SAMPLES = 15
"""Frames spread over the recording that the background is learnt from before the first step."""
_MOMENT_S = 0.4
"""Somebody who lingers moves within it."""


def track(
    recording: Recording,
    tracker: str | None = None,
    settings: Any = None,
    seed: int = 0,
    frames: tuple[int, int] | None = None,
    resume: Resume | None = None,
    *,
    spool: Path | None = None,
    keep: bool = True,
) -> Tracking:
    """Start a tracker on a recording; nothing is read until the first step is asked for.

    Args:
        recording: where the frames come from; stays open until the tracking is closed.
        tracker: name in the catalogue; None takes the best one for the recording.
        settings: of the tracker's `settings_type`; None takes the defaults.
        seed: of all random numbers; the same seed gives the same arrays, byte for byte.
        frames: half-open range to track; None takes the whole recording, from where to resume.
        resume: tracks again from a frame of corrected tracks on, with their people: ids go on.
        spool: the folder for particles that are too many for the memory, see `KeptSteps`.
        keep: False: only the steps are asked for; the run has no frames then.

    Raises `SettingsError` for an unknown tracker, settings that exclude each other, an empty range
    or one that does not begin where to resume, `RecordingError` or `CalibrationError` where the
    tracker cannot work on the recording.
    """
    spec = tracker_named(tracker or best_tracker(recording))
    require(spec, recording)
    asked = _asked_frames(recording, frames, resume)
    settings = with_relative_paths(recording, settings or spec.settings_type())
    require_sense(settings_values(settings))
    kept = KeptSteps(spool, asked[0]) if keep else None
    return Tracking(recording, spec, settings, seed, asked, resume, kept)


def _asked_frames(
    recording: Recording, frames: tuple[int, int] | None, resume: Resume | None
) -> tuple[int, int]:
    """The half-open range to track; see `track`."""
    first = resume.frame if resume is not None else 0
    start, stop = frames or (first, recording.frame_count)
    if not 0 <= start < stop <= recording.frame_count:
        raise SettingsError(
            "frames {start}:{stop} are not in the recording: choose a range within 0:{frame_count}",
            start=start,
            stop=stop,
            frame_count=recording.frame_count,
        )
    if resume is not None and start != first:
        raise SettingsError(
            "frames {start}:{stop} do not begin at frame {first}, where to go on: choose "
            "{first}:{stop}",
            start=start,
            stop=stop,
            first=first,
        )
    return start, stop


class Tracking:
    """A tracker at work: iterate for a `StepResult` a frame, close to cancel.

    The background is learnt first, from frames spread over the whole recording, so that a range
    that starts late and a scene that starts with people are seen like any other. Where a camera is
    late, which is looked for first and all along, each frame is the left camera's, with the right
    picture of its instant. All calls belong to one thread.

    Attributes:
        frames: half-open range being tracked. done: frames of it tracked so far.
        observation: what was seen in the last frame, with its overlays; None before the first.
        learning: told how much of the background is read; to be set before the first step.
        doubt: what cannot be right of two cameras, height and tilt, known from the first step on
            and one of the notes; "": nothing.
    """

    def __init__(
        self,
        recording: Recording,
        spec: TrackerSpec,
        settings: Any,
        seed: int,
        frames: tuple[int, int],
        resume: Resume | None = None,
        kept: KeptSteps | None = None,
    ) -> None:
        """See `track`; kept: where to keep the steps, None: nowhere."""
        self.frames = frames
        self.done = 0
        self.observation: Observation | None = None
        self._stages = Stages(
            "learn", "decode", "network", "perception", "tracker", "appearance", "keep"
        )
        self._recording = recording
        self._spec = spec
        self._settings = settings
        self._seed = seed
        self._resume = resume
        self._tracker: Tracker | None = None
        self._perception: Perception | None = None
        self._from_file: RecordingDetections | None = None
        self._network: NetworkDetections | PictureDetections | None = None
        self._appearance: AppearanceNetwork | None = None
        self._embeddings: TrackEmbeddings | None = None
        self._kept = kept
        self._followed = False
        self.doubt = Message()
        self.learning: Progress = no_progress
        self._ranged = RangedShare()
        self._steps = self._work()

    def __iter__(self) -> Iterator[StepResult]:
        return self

    def __next__(self) -> StepResult:
        return next(self._steps)

    def __enter__(self) -> Tracking:
        return self

    def __exit__(self, *_: object) -> None:
        self.close()

    def close(self) -> None:
        """Stop; what was tracked so far stays available from `run`."""
        self._steps.close()

    def run(self) -> Run:
        """Everything tracked so far as one immutable run."""
        kept = self._kept or KeptSteps(first=self.frames[0])
        return replace(kept.run(*self._asked()), detections_input=self.detections_input)

    def run_so_far(self) -> Run | None:
        """The same of a tracker that could not go on; None: nothing can be kept of it."""
        run = None if self._kept is None else self._kept.run_so_far(*self._asked())
        return None if run is None else replace(run, detections_input=self.detections_input)

    def _asked(self) -> tuple[str, dict[str, Any], int, Recording, Resume | None]:
        """What was asked for, as a run has it."""
        settings = settings_values(self._settings)
        return self._spec.name, settings, self._seed, self._recording, self._resume

    @property
    def tracker(self) -> str:
        """The tracker's name."""
        return self._spec.name

    @property
    def detections_input(self) -> tuple[DetectionsInput, ...]:
        """The files of detections that were read, or the network; known from the first step."""
        source = self._source
        given = source.inputs if source is not None else ()
        return given if self._appearance is None else (*given, *self._appearance.inputs)

    @property
    def stage_s(self) -> dict[str, float]:
        """Seconds spent so far in each of the stages, "learn", "decode" and so on.

        Of a tracker that tells its own stages those, too: "tracker_filters" and so on.
        """
        inner: Mapping[str, float] = getattr(self._tracker, "stage_s", {})
        return {**self._stages.spent_s, **{f"tracker_{name}": s for name, s in inner.items()}}

    @property
    def notes(self) -> tuple[Message, ...]:
        """What the user should be told of the frames tracked so far, a line each."""
        told = self._tracker.notes if self._tracker is not None else ()
        source = self._source
        told = (*(source.notes if source is not None else ()), *told)
        told = (*(self._appearance.notes if self._appearance is not None else ()), *told)
        told = (*told, *(self._perception.notes if self._perception is not None else ()))
        doubt = self.doubt or self._without_distances()
        return (*told, doubt) if doubt else told

    def _without_distances(self) -> Message:
        """What is told where hardly anything that moves has a distance; "": it has one."""
        if self._followed or not self._spec.needs_stereo or not self._ranged.is_too_small:
            return Message()
        cameras = (
            msg("is the scale of [depth] right, and is it aligned to the left image?")
            if self._recording.has_depth
            else msg("are the cameras swapped, or is the calibration of other cameras?")
        )
        changed = changed_matching(self._spec.name, self._settings)
        asked = (
            msg("{changed}, is that right? If so, {cameras}", changed=changed, cameras=cameras)
            if changed
            else cameras
        )
        return msg(
            "{name}: no distance for what moves: {asked}", name=self._recording.name, asked=asked
        )

    @property
    def _source(self) -> RecordingDetections | NetworkDetections | PictureDetections | None:
        """What gives boxes of people; None: nothing but the foreground."""
        return self._from_file or self._network

    def _work(self) -> Generator[StepResult]:
        try:
            yield from self._tracked()
        finally:
            for network in (self._network, self._appearance):
                if network is not None:
                    network.close()

    def _open_detections(self) -> None:
        """Read the detections, or start the network, that settings name."""
        timed, stage = self._stages.timed, detections_stage(self._settings)
        self._from_file = timed("learn", load_detections, self._recording, stage)
        opened = partial(network_detections, stereo=self._spec.needs_stereo)
        self._network = timed("learn", opened, self._recording, stage)
        beside = None if self._network is None else self._network.appearance
        self._appearance = timed("learn", appearance_network, self._recording, stage, beside)
        if self._appearance is not None:
            self._embeddings = TrackEmbeddings(self._appearance.embed)

    def _observed(self, perception: Perception, frame: StereoFrame) -> Observation:
        """What is seen in a frame; a network looks at it first."""
        if self._network is not None:
            self._stages.timed("network", self._network.look, frame)
        observed = self._stages.timed("perception", perception.observe, frame)
        if self._appearance is None:
            return observed
        self._appearance.look(frame.left)
        return replace(observed, embed=self._appearance.embed)

    def _tracked(self) -> Generator[StepResult]:
        timed = self._stages.timed
        self._open_detections()
        if self._resume is not None:
            self._resume.require_same(self.detections_input)
        asked = (self._recording, self._settings, self._seed, self._source)
        perception, tracker = self._spec.build(*asked)
        self._perception, self._tracker = perception, tracker
        timed("learn", self._learn, perception)
        watch, instants = perception.stereo_watch, Instants(self._recording)
        if watch is not None:
            timed("learn", begin_pairing, watch, instants, self.frames[0])
        if self._resume is not None:
            frames = self._resume.colour_frames
            seen = (self._observed(perception, instants.read(n)) for n in frames)
            timed("learn", tracker.resume, self._resume, seen)
        pictures = instants.frames(*self.frames)
        while (frame := timed("decode", next, pictures, None)) is not None:
            self.observation = self._observed(perception, frame)
            if watch is not None:
                instants.lag = watch.pairing
            self._ranged.add(self.observation.overlays)
            result = timed("tracker", tracker.step, self.observation)
            result = timed("appearance", self._with_networks, result, frame.time_s)
            self._followed |= bool(len(result.tracks["track"]))
            if self._kept is not None:
                timed("keep", self._kept.add, (result,))
            self.done += 1
            yield result

    def _with_networks(self, result: StepResult, time_s: float) -> StepResult:
        """The step with what networks said: boxes, which may not be had again, and embeddings."""
        if self._network is not None:
            result = replace(result, network_boxes=self._network.boxes)
        if self._embeddings is not None:
            result = replace(result, embeddings=self._embeddings.rows(result, time_s))
        return result

    def _learn(self, perception: Perception) -> None:
        """The background; two cameras are looked at for whether they can be as told."""
        samples, later = background_samples(self._recording, self.learning)
        if self._spec.needs_stereo:
            self.doubt = doubt_of(self._recording, samples)
        perception.learn(samples, later)


def background_samples(
    recording: Recording, progress: Progress = no_progress
) -> tuple[list[StereoFrame], list[StereoFrame]]:
    """Frames spread evenly over the recording, and of each the one a moment later.

    Raises:
        RecordingError: one is unreadable.
    """
    count = min(BACKGROUND_SAMPLES, recording.frame_count)
    moment = min(max(1, round(_MOMENT_S * recording.fps)), recording.frame_count // 4)
    numbers = np.unique(np.linspace(0, recording.frame_count - 1 - moment, count).astype(int))
    pairs: list[tuple[StereoFrame, StereoFrame]] = []
    for one in numbers.tolist():
        progress(len(pairs), len(numbers))
        pairs.append((recording.read(one), recording.read(one + moment)))
    return [frame for frame, _ in pairs], [frame for _, frame in pairs]


def begin_pairing(watch: StereoWatch, instants: Instants, start: int) -> None:
    """Begin with the lag that the footage shows from a frame on, or recording.toml tells.

    Whoever reads on takes `watch.pairing` over to `instants.lag` after each frame looked at.
    """
    recording = instants.recording
    watch.begin(first_lag(recording, start) or 0, recording.right_lag)
    instants.lag = watch.pairing

"""Trackers as they are compared, and their runs over clips: all of one clip see the same people."""

from __future__ import annotations

import sys
import time
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from functools import cache
from pathlib import Path
from typing import Any

import numpy as np

from tests.benchmarks.kept_results import LIBRARIES, keep, path_of, sources_of, tables_in
from tracking.pipeline import KeptSteps, background_samples, begin_pairing
from tracking.recording import Instants, Recording, open_recording
from tracking.settings import settings_from, settings_values
from tracking.trackers import tracker_named
from tracking.trackers.protocol import Perception, Tracker
from tracking.tracks import Columns
from tracking.tracks.run import Run

SEED = 0
_SEEN_BY = ("foreground", "stereo", "people")
"""The rooms whose settings decide what is seen."""

_TABLES = ("tracks", "detections", "times")

_ROOMS = (
    *("errors.py", "filtering/**/*.py", "foreground/**/*.py", "geometry/**/*.py"),
    *("people/*.py", "pipeline/**/*.py", "recording/**/*.py", "setting*.py"),
    *("stereo/**/*.py", "trackers/*.py", "trackers/joint/**/*.py"),
    *("trackers/linking/**/*.py", "tracks/**/*.py"),
)


@dataclass(frozen=True, slots=True)
class Variant:
    """A tracker as it is compared.

    Attributes:
        tracker: in the catalogue.
        settings: other than the defaults, by their dotted names.
    """

    tracker: str
    settings: tuple[tuple[str, Any], ...] = ()

    def chosen(self) -> Any:
        """All its settings."""
        return settings_from(tracker_named(self.tracker).settings_type, dict(self.settings))


@dataclass(frozen=True, slots=True, eq=False)
class Seen:
    """Of a run: what was followed, and what was seen in each frame alone.

    Attributes:
        times: processor time in one row: `frames`, `seeing_s` (people found in all of them; shared
            by trackers that perceive alike) and `following_s` (steps, and finishing the run).
    """

    tracks: Columns
    detections: Columns
    times: Columns


class _Stopwatch:
    """Processor time of a with statement, summed over all times it is entered."""

    def __init__(self) -> None:
        self.total_s = 0.0

    def __enter__(self) -> None:
        self._began_s = time.process_time()

    def __exit__(self, *_: object) -> None:
        self.total_s += time.process_time() - self._began_s


def runs_over(
    folder: Path, variants: Sequence[Variant], kept: Path | None = None
) -> dict[Variant, Seen]:
    """What each tracker makes of a recording; runs are kept, beside it if nowhere else.

    Trackers with the same settings of perception share one, so that each frame is looked at once.
    """
    places = {variant: _place(folder, variant) for variant in variants}
    if kept is not None:
        places = {variant: kept / place.name for variant, place in places.items()}
    missing = [variant for variant, place in places.items() if not place.is_file()]
    for variant, run, times in _fresh_runs(folder, missing):
        tables = (run.tracks, run.detections, times)
        keep(places[variant], dict(zip(_TABLES, tables, strict=True)))
    return {variant: Seen(**tables_in(place, _TABLES)) for variant, place in places.items()}


def _place(folder: Path, variant: Variant) -> Path:
    values = settings_values(variant.chosen())
    said = repr((variant.tracker, values, SEED, _TABLES))
    return path_of(folder, sources(), LIBRARIES, said)


@cache
def sources() -> str:
    """A hash over all that runs are made with."""
    return sources_of(_ROOMS)


def _fresh_runs(
    folder: Path, variants: Sequence[Variant]
) -> Iterator[tuple[Variant, Run, Columns]]:
    for together in _seeing_alike(variants):
        began = time.perf_counter()
        with open_recording(folder) as recording:
            yield from _tracked(recording, together)
        took_s = time.perf_counter() - began
        names = ", ".join(variant.tracker for variant in together)
        print(f"{folder.name} by {names} in {took_s:.0f} s", file=sys.stderr, flush=True)


def _seeing_alike(variants: Sequence[Variant]) -> Iterator[list[Variant]]:
    """The trackers in groups that perceive alike."""
    groups: dict[tuple[Any, ...], list[Variant]] = {}
    for variant in variants:
        chosen = variant.chosen()
        # The papers' own methods see colours in their own way.
        paper = getattr(chosen, "paper", False) and variant.tracker
        seen_by = (paper, *(getattr(chosen, name) for name in _SEEN_BY))
        groups.setdefault(seen_by, []).append(variant)
    yield from groups.values()


def _tracked(
    recording: Recording, variants: list[Variant]
) -> Iterator[tuple[Variant, Run, Columns]]:
    built = [_build(recording, variant) for variant in variants]
    perception = built[0][0]
    perception.learn(background_samples(recording))
    steps = [KeptSteps() for _ in variants]
    seeing, following = _Stopwatch(), [_Stopwatch() for _ in variants]
    pairing, instants = perception.stereo_watch, Instants(recording)
    if pairing is not None:
        begin_pairing(pairing, instants, 0)
    for frame in instants.frames(0, recording.frame_count):
        with seeing:
            seen = perception.observe(frame)
        if pairing is not None:
            instants.lag = pairing.pairing
        for (_, tracker), own, watch in zip(built, steps, following, strict=True):
            with watch:
                step = tracker.step(seen)
            own.add([step])
    for variant, own, watch in zip(variants, steps, following, strict=True):
        values = settings_values(variant.chosen())
        with watch:
            run = own.run(variant.tracker, values, SEED, recording)
        yield variant, run, _times(recording, seeing, watch)


def _times(recording: Recording, seeing: _Stopwatch, following: _Stopwatch) -> Columns:
    values = (recording.frame_count, seeing.total_s, following.total_s)
    names = ("frames", "seeing_s", "following_s")
    return {name: np.array([value], float) for name, value in zip(names, values, strict=True)}


def _build(recording: Recording, variant: Variant) -> tuple[Perception, Tracker]:
    return tracker_named(variant.tracker).build(recording, variant.chosen(), SEED)

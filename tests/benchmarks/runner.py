"""Trackers over recordings; runs are kept for as long as nothing they were made with has changed.

A run is found again by what its recording holds, the sources of every package it goes through, the
libraries, the tracker and its settings: so no figure on a page is of an older state than the
others, and none is measured twice.
"""

from __future__ import annotations

import hashlib
import io
import os
import sys
import time
from collections.abc import Iterable, Iterator, Sequence
from contextlib import contextmanager, nullcontext
from dataclasses import dataclass, replace
from functools import cache
from importlib import import_module
from pathlib import Path
from typing import Any

import numpy as np

from tests.benchmarks.clips import LIBRARIES, clips_cache, hash_of_files, sources_of
from tests.benchmarks.command import tell
from tests.benchmarks.timing import Stopwatch
from tracking.detections import load_detections
from tracking.failure import built_in_detector
from tracking.people import Observation
from tracking.pipeline import KeptSteps, background_samples, begin_pairing
from tracking.recording import Instants, Recording, open_recording
from tracking.settings import settings_from, settings_values
from tracking.trackers import tracker_named
from tracking.trackers.shared.protocol import Perception, Tracker
from tracking.tracks import PARTICLE_COLUMNS, Columns, Particles
from tracking.tracks.run import Run

SEED = 0
_SEEN_BY = ("foreground", "stereo", "people", "detections")
"""Settings that decide what a tracker for two cameras sees."""
_TABLES = ("tracks", "detections", "associations", "signals", "parts")
_PACKAGES = (
    *(
        "detections/*",
        "errors.py",
        "failure/*",
        "filtering/**/*",
        "foreground/**/*",
        "geometry/**/*",
    ),
    *("people/**/*", "pipeline/**/*", "recording/**/*", "setting*.py"),
    *("stereo/**/*", "trackers/**/*", "tracks/**/*"),
)


@dataclass(frozen=True, slots=True)
class Case:
    """A tracker as it is measured.

    Attributes:
        tracker: in the catalogue.
        settings: other than the defaults, by their dotted names.
        name: in tables and pictures; the tracker's if left out.
        seed: of its randomness.
        frames: how many it is measured on, from the first; 0: all.
        replaced: module-level values of the library, by their dotted names, and what stands in
            their place while this case is tracked: a value, or the dotted name of another one.
    """

    tracker: str
    settings: tuple[tuple[str, Any], ...] = ()
    name: str = ""
    seed: int = SEED
    frames: int = 0
    replaced: tuple[tuple[str, Any], ...] = ()

    def chosen(self) -> Any:
        """All its settings."""
        return settings_from(tracker_named(self.tracker).settings_type, dict(self.settings))

    def __str__(self) -> str:
        return self.name or self.tracker


@dataclass(frozen=True, slots=True, eq=False)
class KeptRun:
    """A run and the time it took.

    Attributes:
        run: without its particles where it was kept, with all it has where it was tracked now.
        times: processor time in one row: `frames`, `seeing_s` (people found in all of them; shared
            by trackers that perceive alike) and `following_s` (steps, and finishing the run).
    """

    run: Run
    times: Columns

    @property
    def tracks(self) -> Columns:
        """The run's."""
        return self.run.tracks


def run_of(folder: Path, case: Case) -> KeptRun:
    """One case's run over a recording; see `runs_over`."""
    return runs_over(folder, [case])[case]


def runs_over(folder: Path, cases: Sequence[Case]) -> dict[Case, KeptRun]:
    """What each tracker makes of a recording; runs are kept in the user's cache.

    Trackers for two cameras with the same settings of perception share one, so that each frame is
    looked at once.
    """
    contents = hash_of_files(folder, (path for path in folder.rglob("*") if path.is_file()))
    paths = {case: clips_cache() / "runs" / _file_name(folder, contents, case) for case in cases}
    missing = [case for case, path in paths.items() if not path.is_file()]
    for case, fresh in fresh_runs(folder, missing):
        _keep(paths[case], fresh)
    return {case: _read(path, case) for case, path in paths.items()}


def _file_name(folder: Path, contents: str, case: Case) -> str:
    chosen = case.chosen()
    detector = built_in_detector().fingerprint if getattr(chosen, "adjust", False) else ""
    more = (case.seed, case.frames, case.replaced)
    own = repr((case.tracker, settings_values(chosen), *more, _TABLES, detector))
    said = "\0".join((contents, sources(), LIBRARIES, own))
    return f"{folder.name}-{hashlib.sha256(said.encode()).hexdigest()[:16]}.npz"


@cache
def sources() -> str:
    """A hash over all that runs are made with."""
    return sources_of(_PACKAGES)


def _keep(path: Path, fresh: KeptRun) -> None:
    """Keep the tables of a run; the file appears whole."""
    tables = {"times": fresh.times, **{name: getattr(fresh.run, name) for name in _TABLES}}
    columns = {f"{t}/{name}": column for t, its in tables.items() for name, column in its.items()}
    columns |= {"frames": np.array(fresh.run.frames), "notes": np.array(fresh.run.notes, str)}
    image = io.BytesIO()
    np.savez_compressed(image, **columns)  # type: ignore[arg-type]  # names are not its options
    path.parent.mkdir(parents=True, exist_ok=True)
    part = path.with_suffix(f".{os.getpid()}.part")
    part.write_bytes(image.getvalue())
    part.replace(path)


def _read(path: Path, case: Case) -> KeptRun:
    tables: dict[str, dict[str, Any]] = {name: {} for name in (*_TABLES, "times")}
    with np.load(path) as held:
        for name in held.files:
            table, _, column = name.partition("/")
            if column:
                tables[table][column] = held[name]
        frames, notes = tuple(held["frames"].tolist()), tuple(held["notes"].tolist())
    times, settings = tables.pop("times"), settings_values(case.chosen())
    particles = Particles.none(PARTICLE_COLUMNS)
    known = {"seed": case.seed, "frames": frames, "particles": particles, "notes": notes}
    return KeptRun(Run(tracker=case.tracker, settings=settings, **known, **tables), times)


def fresh_runs(folder: Path, cases: Sequence[Case]) -> Iterator[tuple[Case, KeptRun]]:
    """Cases with their runs, tracked now."""
    for together in _seeing_alike(cases):
        began = time.perf_counter()
        with open_recording(folder) as recording, replacing(together[0].replaced):
            yield from _tracked(recording, together)
        names = ", ".join(map(str, together))
        tell(f"{folder.name} by {names} in {time.perf_counter() - began:.0f} s")


@contextmanager
def replacing(values: Iterable[tuple[str, Any]]) -> Iterator[None]:
    """Other module-level values within a with statement; see `Case.replaced`.

    A name that a module imported from the one named is replaced there, too.
    """
    before: list[tuple[Any, str, Any]] = []
    try:
        for dotted, value in values:
            module, _, name = dotted.rpartition(".")
            old = getattr(import_module(module), name)
            new = _value_named(value) if isinstance(value, str) else value
            for other in [*sys.modules.values()]:
                ours = getattr(other, "__name__", "").startswith("tracking.")
                if ours and other.__dict__.get(name) is old:
                    before.append((other, name, old))
                    setattr(other, name, new)
        yield
    finally:
        for other, name, old in reversed(before):
            setattr(other, name, old)


def _value_named(dotted: str) -> Any:
    module, _, name = dotted.rpartition(".")
    return getattr(import_module(module), name)


def _seeing_alike(cases: Sequence[Case]) -> Iterator[list[Case]]:
    """The trackers in groups that perceive alike."""
    groups: dict[Any, list[Case]] = {}
    for case in cases:
        chosen, needs_stereo = case.chosen(), tracker_named(case.tracker).needs_stereo
        # The papers' own methods see colours in their own way.
        apart = case.tracker if getattr(chosen, "paper", False) else ""
        alike = needs_stereo and not case.replaced
        seen_by = (apart, *(getattr(chosen, name) for name in _SEEN_BY)) if alike else case
        groups.setdefault((seen_by, case.frames), []).append(case)
    yield from groups.values()


def _tracked(recording: Recording, cases: list[Case]) -> Iterator[tuple[Case, KeptRun]]:
    built = [_build(recording, case) for case in cases]
    perception = built[0][0]
    steps = [KeptSteps() for _ in cases]
    seeing, following = Stopwatch(), [Stopwatch() for _ in cases]
    frames = min(cases[0].frames or recording.frame_count, recording.frame_count)
    for seen in observations(recording, perception, frames, seeing):
        for (_, tracker), own, watch in zip(built, steps, following, strict=True):
            with watch:
                step = tracker.step(seen)
            own.add([step])
    for case, (_, tracker), own, watch in zip(cases, built, steps, following, strict=True):
        with watch:
            run = own.run(case.tracker, settings_values(case.chosen()), case.seed, recording)
        times = (frames, seeing.total_s, watch.total_s)
        named = zip(("frames", "seeing_s", "following_s"), times, strict=True)
        run = replace(run, notes=(*tracker.notes, *perception.notes))
        yield case, KeptRun(run, {name: np.array([value], float) for name, value in named})


def observations(
    recording: Recording, perception: Perception, frames: int, watch: Stopwatch | None = None
) -> Iterator[Observation]:
    """What is seen in the first so many frames; `watch` adds up how long looking takes."""
    perception.learn(*background_samples(recording))
    pairing, instants = perception.stereo_watch, Instants(recording)
    if pairing is not None:
        begin_pairing(pairing, instants, 0)
    for frame in instants.frames(0, frames):
        with watch or nullcontext():
            seen = perception.observe(frame)
        if pairing is not None:
            instants.lag = pairing.pairing
        yield seen


def _build(recording: Recording, case: Case) -> tuple[Perception, Tracker]:
    settings = case.chosen()
    boxes = load_detections(recording, settings.detections)
    return tracker_named(case.tracker).build(recording, settings, case.seed, boxes)

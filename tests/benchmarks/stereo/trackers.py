"""Trackers as they are compared, and their runs over clips: all of one clip see the same people."""

from __future__ import annotations

import sys
import time
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from tracking.pipeline import background_samples, run_of_steps
from tracking.recording import Recording, open_recording
from tracking.settings import settings_from, settings_values
from tracking.trackers import StepResult, tracker_named
from tracking.trackers.protocol import Perception, Tracker
from tracking.tracks.run import Run

SEED = 0
_SEEN_BY = ("foreground", "stereo", "people")
"""The rooms whose settings decide what is seen."""


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


def runs_over(folder: Path, variants: Sequence[Variant]) -> dict[Variant, Run]:
    """What each tracker makes of a recording.

    Trackers with the same settings of perception share one, so that each frame is looked at once.
    """
    began = time.perf_counter()
    found: dict[Variant, Run] = {}
    with open_recording(folder) as recording:
        for together in _seeing_alike(variants):
            found.update(_tracked(recording, together))
    took_s = time.perf_counter() - began
    print(f"{len(variants)} trackers: {folder.name} in {took_s:.0f} s", file=sys.stderr, flush=True)
    return found


def _seeing_alike(variants: Sequence[Variant]) -> Iterator[list[Variant]]:
    """The trackers in groups that perceive alike."""
    groups: dict[tuple[Any, ...], list[Variant]] = {}
    for variant in variants:
        chosen = variant.chosen()
        seen_by = tuple(getattr(chosen, name) for name in _SEEN_BY)
        groups.setdefault(seen_by, []).append(variant)
    yield from groups.values()


def _tracked(recording: Recording, variants: list[Variant]) -> dict[Variant, Run]:
    built = [_build(recording, variant) for variant in variants]
    perception = built[0][0]
    perception.learn(background_samples(recording))
    steps: list[list[StepResult]] = [[] for _ in variants]
    for frame in recording.frames(0, recording.frame_count):
        seen = perception.observe(frame)
        for (_, tracker), own in zip(built, steps, strict=True):
            own.append(tracker.step(seen))
    return {
        variant: run_of_steps(
            own, variant.tracker, settings_values(variant.chosen()), SEED, 0, recording
        )
        for variant, own in zip(variants, steps, strict=True)
    }


def _build(recording: Recording, variant: Variant) -> tuple[Perception, Tracker]:
    return tracker_named(variant.tracker).build(recording, variant.chosen(), SEED)

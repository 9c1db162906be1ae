"""The sections of the report as plain figures, each measured on its own."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from importlib import import_module
from pathlib import Path
from typing import Any

import numpy as np

from tests.benchmarks.parts.clips import Clip
from tests.benchmarks.parts.label_effort import machine_curves, samples_of_clips
from tests.benchmarks.parts.postures import STANDS_AGAIN_S, Stoop, stoops_in
from tests.benchmarks.parts.real import measure as real_footage
from tests.benchmarks.parts.tracker_runs import (
    ADJUSTED,
    JOINT,
    PLAIN,
    VARIANTS,
    Variant,
    judged_clip,
)
from tracking.failure import Curve, Detector, built_in_detector
from tracking.failure.training.questions import NAMES
from tracking.scoring.parts import Judged, rates_of

Figures = dict[str, Any]

_SHARES = (0.01, 0.02, 0.05)
_GRID = np.linspace(0.0, 0.2, 81)


def rates(
    clips: Sequence[Clip], kept: Path | None = None, variants: Sequence[Variant] = VARIANTS
) -> Figures:
    """Curves of each variant over all people of the clips."""
    return {
        "clips": [f"{clip.scene} {clip.seed}" for clip in clips],
        "variants": {
            variant.name: _curves([judged_clip(clip, variant, kept) for clip in clips])
            for variant in variants
        },
    }


def rates_one_by_one(
    clips: Sequence[Clip], kept: Path | None = None, variants: Sequence[Variant] = VARIANTS
) -> Iterator[Figures]:
    """The same as far as it has come, after each variant: they take minutes."""
    found: Figures = {}
    for variant in variants:
        found |= rates(clips, kept, [variant])["variants"]
        yield {"clips": [f"{clip.scene} {clip.seed}" for clip in clips], "variants": dict(found)}


def _curves(judged: Sequence[Sequence[Judged]]) -> Figures:
    people = [one for clip in judged for one in clip]
    curves = rates_of(people)
    return {
        "judged": len(people),
        "never_tracked": curves.untracked,
        "people": curves.people.tolist(),
        "right": curves.right.round(5).tolist(),
        "unbroken": curves.unbroken.round(5).tolist(),
        "foreign": [round(float(share), 4) for share in curves.foreign],
    }


def crouching(clips: Sequence[Clip], kept: Path | None = None) -> Figures:
    """People who go down and stand up again, with the trackers of parts."""
    figures = {}
    for variant in (ADJUSTED, PLAIN, JOINT):
        stoops = [
            stoop for clip in clips for stoop in stoops_in(clip, judged_clip(clip, variant, kept))
        ]
        figures[variant.name] = _stoops(stoops)
    return {"clips": [f"{clip.scene} {clip.seed}" for clip in clips], "variants": figures}


def _stoops(stoops: Sequence[Stoop]) -> Figures:
    recovered = np.array([stoop.recovered_s for stoop in stoops])
    finite = recovered[np.isfinite(recovered)]
    return {
        "stoops": len(stoops),
        "bent": sum(stoop.bent for stoop in stoops),
        "kept": sum(stoop.kept for stoop in stoops),
        "recovered": int((recovered <= STANDS_AGAIN_S).sum()),
        "median_s": round(float(np.median(finite)), 2) if len(finite) else None,
        "longest_s": round(float(finite.max()), 2) if len(finite) else None,
        "not_recovered": int(len(recovered) - len(finite)),
    }


def detector(clips: Sequence[Clip], kept: Path | None = None) -> Figures:
    """The built-in detector: people held out in training, and scenes never trained on."""
    shipped = built_in_detector()
    new = samples_of_clips(clips, PLAIN, kept)
    held = machine_curves(shipped, new)
    origin = shipped.origin
    machines = {
        name: _machine(curve, held.get(name), threshold)
        for name, curve, threshold in zip(NAMES, shipped.curves, _thresholds(shipped), strict=False)
    }
    return {
        "fingerprint": shipped.fingerprint,
        "recordings": len(origin.recordings),
        "people": origin.people,
        "new_samples": len(new),
        "new_clips": len(clips),
        "grid": _GRID.round(5).tolist(),
        "machines": machines,
    }


def _thresholds(detector: Detector) -> list[float]:
    return [*detector.thresholds.tolist(), detector.several_threshold]


def _machine(curve: Curve, new: Curve | None, threshold: float) -> Figures:
    """A machine's figures; `new` are its scores on scenes it never saw."""
    return {
        "on": len(curve.on),
        "off": len(curve.off),
        "area": round(curve.area(), 5),
        "found": {f"{s:g}": round(curve.found(curve.threshold_for(s)), 5) for s in _SHARES},
        "curve": [round(curve.found(curve.threshold_for(share)), 5) for share in _GRID],
        "new": None
        if new is None
        else {
            "on": len(new.on),
            "off": len(new.off),
            "area": round(new.area(), 5),
            "false_alarms": round(new.false_alarms(threshold), 5),
            "found": round(new.found(threshold), 5),
            "curve": [round(new.found(new.threshold_for(share)), 5) for share in _GRID],
        },
    }


def equalisation() -> Figures:
    """False alarms of the histograms with and without equalisation."""
    return dict(import_module("tests.benchmarks.parts.equalisation").measure())


def speed() -> Figures:
    """Frames a second with five people, and what each stage costs."""
    return dict(import_module("tests.benchmarks.parts.speed").measure())


def real(data: Path | None) -> Figures:
    """Who keeps their parts in real footage; empty where the recordings are not there."""
    return real_footage(data)

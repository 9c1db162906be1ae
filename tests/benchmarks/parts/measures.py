"""How well body parts are tracked, as plain figures: rates, crouching people, the detector."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np

from tests.benchmarks.clips import Clip
from tests.benchmarks.parts.cases import ADJUSTED, CASES, JOINT, PLAIN, judged_clip
from tests.benchmarks.parts.clips import title_of
from tests.benchmarks.parts.detector import samples_of_clips
from tracking.failure import Curve, Detector, Samples, built_in_detector
from tracking.failure.training.questions import NAMES, all_questions
from tracking.scoring.parts import Judged, rates_of
from tracking.synthesis.cast import Cast
from tracking.synthesis.rig import Rig

Figures = dict[str, Any]

STANDS_AGAIN_S = 1.0
"""How long after standing up the parts may take to be right again."""
_STOOPS = 0.05
_SETTLED_FRAMES = 10  # how long a person must be followed before going down
_SHARES = (0.01, 0.02, 0.05)
_GRID = np.linspace(0.0, 0.2, 81)


def rates(clips: Sequence[Clip]) -> Figures:
    """Curves of each case over all people of the clips."""
    curves = {
        case.name: _curves([one for clip in clips for one in judged_clip(clip, case)])
        for case in CASES
    }
    return {"clips": [title_of(clip) for clip in clips], "variants": curves}


def _curves(people: Sequence[Judged]) -> Figures:
    curves = rates_of(people)
    return {
        "judged": len(people),
        "never_tracked": curves.untracked,
        "people": curves.people.tolist(),
        "right": curves.right.round(5).tolist(),
        "unbroken": curves.unbroken.round(5).tolist(),
        "foreign": [round(float(share), 4) for share in curves.foreign],
    }


@dataclass(frozen=True, slots=True)
class Stoop:
    """One time that somebody who was tracked went down.

    Attributes:
        person: true id.
        bent: bent over; else crouched.
        kept: the same track stands on the person a second after standing up.
        recovered_s: from standing up until all three parts were right; inf where they were not
            within the time the person stayed in view.
    """

    person: int
    bent: bool
    kept: bool
    recovered_s: float


def crouching(clips: Sequence[Clip]) -> Figures:
    """People who go down and stand up again, with the trackers of parts."""
    stoops = {
        case.name: [one for clip in clips for one in stoops_in(clip, judged_clip(clip, case))]
        for case in (ADJUSTED, PLAIN, JOINT)
    }
    told = {name: _stoops(several) for name, several in stoops.items()}
    return {"clips": [title_of(clip) for clip in clips], "variants": told}


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


def cast_of(clip: Clip) -> Cast:
    """The people of a clip, as they were rendered."""
    spec, fps = clip.spec, clip.fps
    rig = Rig.of_scene(spec, spec.size_px)
    return Cast.of_scene(spec, rig, spec.people, round(spec.seconds * fps), fps, clip.seed)


def stoops_in(clip: Clip, judged: Sequence[Judged]) -> list[Stoop]:
    """All stoops of a clip that began and ended while the person was judged."""
    cast = cast_of(clip)
    found = []
    for one in judged:
        walk, stoops = cast.walks[one.person - 1], cast.stoops[one.person - 1]
        if walk is None or stoops is None:
            continue
        for bent, depth in ((False, stoops.crouch), (True, stoops.bend)):
            for start, end in _spans(depth > _STOOPS):
                rows = walk.first_frame + start, walk.first_frame + end
                found += _followed(one, bent, *rows, clip.fps)
    return found


def _followed(one: Judged, bent: bool, down: int, up: int, fps: float) -> Iterable[Stoop]:
    """The stoop from frame `down` to `up`, if the person was judged before and after it."""
    first, last = down - one.first_frame, up - one.first_frame
    later = last + round(STANDS_AGAIN_S * fps)
    if first < _SETTLED_FRAMES or later >= len(one.parts):
        return
    again = np.flatnonzero(one.parts[last:].all(axis=1))
    recovered = float(again[0]) / fps if len(again) else np.inf
    yield Stoop(one.person, bent, bool(one.person_right[later]), recovered)


def _spans(there: np.ndarray) -> list[tuple[int, int]]:
    edges = np.flatnonzero(np.diff(np.concatenate(([0], there.astype(int), [0]))))
    return list(zip(edges[::2].tolist(), edges[1::2].tolist(), strict=True))


def detector(clips: Sequence[Clip]) -> Figures:
    """The built-in detector: people held out in training, and scenes never trained on."""
    shipped = built_in_detector()
    new = samples_of_clips(clips)
    unseen = machine_curves(shipped, new)
    thresholds = [*shipped.thresholds.tolist(), shipped.several_threshold]
    machines = {
        name: {**_machine(curve), "new": _unseen(unseen.get(name), threshold)}
        for name, curve, threshold in zip(NAMES, shipped.curves, thresholds, strict=False)
    }
    return {
        "fingerprint": shipped.fingerprint,
        "recordings": len(shipped.origin.recordings),
        "people": shipped.origin.people,
        "new_samples": len(new),
        "new_clips": len(clips),
        "grid": _GRID.round(5).tolist(),
        "machines": machines,
    }


def machine_curves(detector: Detector, samples: Samples) -> dict[str, Curve]:
    """What each machine of a detector says of samples it has not seen, by question.

    Those of which it lacks evidence are left out: nobody asks it about them.
    """
    if not detector.preparation.paper:
        samples = samples[samples.has_evidence]
    curves = {}
    for question in all_questions(samples):
        value = detector.machines.decide(detector.preparation.of(question.features))
        if question.number < value.shape[1]:
            score = value[:, question.number]
            off, on = np.sort(score[~question.yes]), np.sort(score[question.yes])
            curves[NAMES[question.number]] = Curve(off, on)
    return curves


def _machine(curve: Curve) -> Figures:
    """A machine's figures on people held out."""
    return {
        "on": len(curve.on),
        "off": len(curve.off),
        "area": round(curve.area(), 5),
        "found": {f"{s:g}": round(curve.found(curve.threshold_for(s)), 5) for s in _SHARES},
        "curve": [round(curve.found(curve.threshold_for(share)), 5) for share in _GRID],
    }


def _unseen(curve: Curve | None, threshold: float) -> Figures | None:
    """The same on scenes it never saw, at its own threshold; None where nothing was asked."""
    if curve is None:
        return None
    at_threshold = {
        "false_alarms": round(curve.false_alarms(threshold), 5),
        "found": round(curve.found(threshold), 5),
    }
    return {**_machine(curve), **at_threshold}

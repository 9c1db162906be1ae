"""The failure detector taught on one camera: `python -m tests.benchmarks.parts.loop RECORDING`.

What somebody with a new camera does: track, label the parts of five people, train, track again with
the detector that came of it. Truth beside the recording answers instead of a person; where it has
boxes of people alone, parts are fixed shares of them. The five are those of whom the detector is
least sure: whom the program asks about first. Everything about "others" is of all other people.
"""

from __future__ import annotations

from collections.abc import Collection, Sequence
from dataclasses import dataclass, replace
from pathlib import Path
from typing import Any

import numpy as np

from tests.benchmarks.clips import clips_cache
from tests.benchmarks.command import one_core, parser_of, real_data, tell
from tests.benchmarks.parts.cases import ADJUSTED
from tests.benchmarks.parts.measures import machine_curves
from tests.benchmarks.runner import run_of
from tracking.failure import (
    Detector,
    Samples,
    TrainingPlan,
    built_in_detector,
    labels_from_truth,
    people_followed,
    samples_of,
    save_detector,
    suggest,
    train,
)
from tracking.formats import read_mot
from tracking.recording import open_recording
from tracking.scoring.parts import PartTruth, by_person, judge, rates_of, tracked_parts
from tracking.tracks import PART_NAMES, PARTS, Run
from tracking.tracks.boxes import corners_of_boxes
from tracking.truth import TRUE_PARTS, TrueParts, read_true_parts

Figures = dict[str, Any]

RECORDINGS = ("rendered-pillars", "rendered-lobby", "towncentre-real")
FIVE = 5
EVERY_S = 0.25
"""Between labels of one person: somebody who labels steps through the recording."""
SEED = 0
_SHARES = ((0.0, 0.17, 0.41), (0.155, 0.585, 0.85), (0.43, 1.0, 0.77))
"""Top and bottom of head, torso and hip-leg in heights of a box, and how wide in its widths: the
medians of people rendered from truth_parts.csv."""
_SEEN = 100
"""Pixels of a part that a box calls seen."""


@dataclass(frozen=True, slots=True, eq=False)
class Footage:
    """A recording with the truth of its parts."""

    folder: Path
    fps: float
    size_px: tuple[int, int]
    truth: TrueParts

    def scored(self, people: Collection[int]) -> PartTruth:
        """The truth of some people, as it is scored."""
        own = np.isin(self.truth.person, list(people))
        truth = self.truth
        columns = (truth.frame, truth.person, truth.part, corners_of_boxes(truth.box))
        frame, person, parts = by_person(*(column[own] for column in columns))
        place = np.column_stack((truth.frame, truth.person))[truth.seen > 0]
        seen = {tuple(one) for one in place.tolist()}
        share = np.array([float(one in seen) for one in zip(frame, person, strict=True)])
        return PartTruth(frame, person, parts, share, self.size_px)


def footage_at(folder: Path) -> Footage:
    """The recording of a folder and where the parts of its people are."""
    with open_recording(folder) as recording:
        fps, size_px = recording.fps, recording.size
    exact = folder / TRUE_PARTS
    truth = read_true_parts(exact) if exact.is_file() else parts_of_boxes(folder / "truth.txt")
    return Footage(folder, fps, size_px, truth)


def parts_of_boxes(path: Path) -> TrueParts:
    """The parts of people of whom boxes alone are known."""
    rows = read_mot(path)
    left, top, width, height = (rows[name] for name in ("left", "top", "width", "height"))
    frame, person = (np.tile(rows[name].astype(np.int64), PARTS) for name in ("frame", "track"))
    boxes = [
        np.column_stack(
            (
                left + width * (1 - wide) / 2,
                top + height * first,
                width * wide,
                height * (last - first),
            )
        )
        for first, last, wide in _SHARES
    ]
    part = np.repeat(np.arange(PARTS), len(left))
    seen = np.tile(np.where(rows["confidence"] > 0, _SEEN, 0), PARTS)
    order = np.lexsort((part, person, frame))
    return TrueParts(
        *(column[order] for column in (frame, person, part, np.concatenate(boxes), seen))
    )


def loop(footage: Footage, people: int = FIVE, seed: int = SEED) -> Figures:
    """What labels of so many people do for the detector, and the detector for the tracks."""
    before = run_of(footage.folder, ADJUSTED).run
    samples = samples_from(footage, before)
    labelled = asked_first(footage, before, samples, people)
    own = np.isin(samples.columns["person"], labelled)
    random = np.random.default_rng(seed)
    made = train(samples[own], TrainingPlan(adapt=built_in_detector), random=random)
    taught = made.detector
    path = clips_cache() / "detectors" / f"{taught.fingerprint}.h5"
    path.parent.mkdir(parents=True, exist_ok=True)
    save_detector(path, taught)
    after = run_of(footage.folder, replace(ADJUSTED, settings=(("detector", str(path)),))).run
    others = set(footage.truth.person.tolist()) - set(labelled)
    built_in = built_in_detector()
    return {
        "recording": footage.folder.name,
        "people": sorted(labelled),
        "labels": samples[own].counts().tolist(),
        "chosen": [str(one.candidate) for one in made.report.questions[:PARTS]],
        "five": {
            "paper": _areas(built_in_detector(paper=True), samples[own]),
            "built in": _areas(built_in, samples[own]),
            "taught": [round(one.curve.area(), 3) for one in made.report.questions[:PARTS]],
        },
        "others": {
            "labels": samples[~own].counts().tolist(),
            "paper": _areas(built_in_detector(paper=True), samples[~own]),
            "built in": _areas(built_in, samples[~own]),
            "taught": _areas(taught, samples[~own]),
        },
        "rates": {
            "judged": len(others),
            "before": _rates(footage, before, others),
            "after": _rates(footage, after, others),
        },
    }


def samples_from(footage: Footage, run: Run) -> Samples:
    """What truth says of a run's parts, as a person would who labels everybody."""
    labels = labels_from_truth(footage.truth, run.parts, footage.fps, EVERY_S)
    known = people_followed(footage.truth, run.parts, footage.fps)
    return samples_of(labels, run.parts, footage.fps, footage.folder.name, known)


def asked_first(footage: Footage, run: Run, samples: Samples, people: int) -> list[int]:
    """The people whom the program's suggestions to label ask about first."""
    known = people_followed(footage.truth, run.parts, footage.fps)
    answered = set(samples.columns["person"].tolist())
    chosen: list[int] = []
    for one in suggest(run.parts, footage.fps, built_in_detector(), (), most=10_000):
        person = known.get(one.track, 0)
        if person in answered and person not in chosen:
            chosen.append(person)
    return chosen[:people]


def _areas(detector: Detector, samples: Samples) -> list[float | None]:
    """The area under the curve of each part; None where all samples say the same."""
    curves = machine_curves(detector, samples)
    areas = [curves[name].area() for name in PART_NAMES]
    return [None if np.isnan(area) else round(area, 3) for area in areas]


def _rates(footage: Footage, run: Run, people: Collection[int]) -> list[float]:
    """Share of all frames in which head, torso, hip-leg and the person's box are right."""
    judged = judge(footage.scored(people), tracked_parts(run.parts), footage.fps)
    return [round(float(share), 4) for share in rates_of(judged).overall]


def loops(report: bool) -> Figures:
    """The loop on each recording there is; `report` does not matter: none is chosen by it."""
    del report
    folders = [real_data() / name for name in RECORDINGS]
    found = [folder for folder in folders if folder.is_dir()]
    return {"recordings": [loop(footage_at(folder)) for folder in found]}


def print_loop(found: Figures) -> None:
    """A recording's figures as lines."""
    off = ", ".join(
        f"{name} {labels[0]} off {labels[1]} on"
        for name, labels in zip(PART_NAMES, found["labels"], strict=True)
    )
    print(f"{found['recording']}: labels of {len(found['people'])} people: {off}")
    print(f"  chosen: {'; '.join(found['chosen'])}")
    for who in ("five", "others"):
        for name in ("paper", "built in", "taught"):
            told = "  ".join("   - " if one is None else f"{one:.3f}" for one in found[who][name])
            print(f"  area, {who:<6} {name:<8} {told}")
    for when in ("before", "after"):
        told = "  ".join(f"{100 * share:5.1f}" for share in found["rates"][when])
        print(f"  right, others, % {when:<6} {told}", flush=True)


def main(arguments: Sequence[str] | None = None) -> None:
    """Read the command line, go round the loop, print."""
    one_core()
    parser = parser_of("parts.loop", __doc__)
    parser.add_argument("recordings", nargs="+", metavar="RECORDING", help="a name or a folder")
    parser.add_argument("--people", type=int, default=FIVE, help="how many are labelled")
    parser.add_argument("--seed", type=int, default=SEED, help="of the folds")
    asked = parser.parse_args(arguments)
    for name in asked.recordings:
        folder = Path(name) if Path(name).is_dir() else real_data() / name
        tell(f"{folder.name}: tracking, labelling, training, tracking again ...")
        print_loop(loop(footage_at(folder), asked.people, asked.seed))


if __name__ == "__main__":
    main()

"""The failure detector taught on one camera: `python -m tests.benchmarks.parts.loop RECORDING`.

What somebody with a new camera does: track, label the parts of five people, train, track again with
the detector that came of it. Truth beside the recording answers instead of a person; where it has
boxes of people alone, parts are fixed shares of them. Labels are of the tracks as they come, and of
those without adjustment, as in the paper, where more parts are lost. The five whose detector tracks
again are those of whom the detector is least sure: whom the program asks about first.
"""

from __future__ import annotations

from collections.abc import Collection, Mapping, Sequence
from dataclasses import dataclass, replace
from pathlib import Path
from typing import Any

import numpy as np

from tests.benchmarks.clips import clips_cache
from tests.benchmarks.command import one_core, parser_of, real_data, tell
from tests.benchmarks.parts.cases import ADJUSTED, PLAIN
from tests.benchmarks.parts.loop_areas import areas_held_out
from tests.benchmarks.runner import run_of
from tracking.arrays import Floats
from tracking.failure import (
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
from tracking.failure.training import Trained
from tracking.formats import read_mot
from tracking.recording import open_recording
from tracking.scoring.parts import PartTruth, by_person, judge, tracked_parts
from tracking.tracks import PART_NAMES, PARTS, Run
from tracking.tracks.boxes import corners_of_boxes
from tracking.truth import TRUE_PARTS, TrueParts, read_true_parts

Figures = dict[str, Any]

RECORDINGS = ("rendered-pillars", "towncentre-real")
FIVE = 5
EVERY_S = 0.25
"""Between labels of one person: somebody who labels steps through the recording."""
SEED = 0
AS_TRACKED = "as tracked"
LABELLED = {AS_TRACKED: ADJUSTED, "without adjustment": PLAIN}
"""On whose tracks people are labelled."""
BEFORE, BUILT_IN = "before", "built in, with evidence"
_BOOTSTRAPS = 2_000
_SHARES = ((0.0, 0.17, 1.0), (0.155, 0.585, 0.85), (0.43, 1.0, 0.77))
"""Top and bottom of head, torso and hip-leg in heights of a box, and how wide in its widths: the
medians of people rendered from truth_parts.csv. But a stride widens the box, and the head of who
walks to the side is anywhere in it: with its own width, 331 of 947 heads were called lost that were
not by the parts rendered; with all of the box's, none of 1,074."""
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
    runs = {name: run_of(footage.folder, case).run for name, case in LABELLED.items()}
    samples = {name: samples_from(footage, run) for name, run in runs.items()}
    labelled = asked_first(footage, runs[AS_TRACKED], samples[AS_TRACKED], people)
    taught = {name: _taught(samples[name], labelled, seed) for name in LABELLED}
    others = set(footage.truth.person.tolist()) - set(labelled)
    return {
        "recording": footage.folder.name,
        "people": sorted(labelled),
        "labels": {
            name: {
                "five": _of(samples[name], labelled).counts().tolist(),
                "all": samples[name].counts().tolist(),
                "chosen": [str(one.candidate) for one in made.report.questions[:PARTS]],
                "five areas": [_known(one.curve.area()) for one in made.report.questions[:PARTS]],
                "areas": areas_held_out(samples[name], people, seed),
            }
            for name, made in taught.items()
        },
        "judged": len(others),
        "rates": _rates_of_detectors(footage, runs[AS_TRACKED], taught, others),
    }


def _of(samples: Samples, people: Collection[int]) -> Samples:
    return samples[np.isin(samples.columns["person"], list(people))]


def _taught(samples: Samples, people: Collection[int], seed: int) -> Trained:
    """What the labels of some people make of the built-in detector."""
    plan = TrainingPlan(adapt=built_in_detector)
    return train(_of(samples, people), plan, random=np.random.default_rng(seed))


def _rates_of_detectors(
    footage: Footage, before: Run, taught: Mapping[str, Trained], people: Collection[int]
) -> Figures:
    """How often parts of some people are right, by the detector that is used."""
    detectors = {BUILT_IN: "evidence"}
    for name, made in taught.items():
        path = clips_cache() / "detectors" / f"{made.detector.fingerprint}.h5"
        path.parent.mkdir(parents=True, exist_ok=True)
        save_detector(path, made.detector)
        detectors[f"taught, labels {name}"] = str(path)
    shares = {BEFORE: right_shares(footage, before, people)}
    for name, detector in detectors.items():
        case = replace(ADJUSTED, settings=(("detector", detector),))
        shares[name] = right_shares(footage, run_of(footage.folder, case).run, people)
    return {name: right_change(own, shares[BEFORE]) for name, own in shares.items()}


def right_shares(footage: Footage, run: Run, people: Collection[int]) -> Floats:
    """(people, 5) in how many frames head, torso, hip-leg and box are right, and of how many."""
    judged = judge(footage.scored(people), tracked_parts(run.parts), footage.fps)
    return np.array(
        [(*one.parts.sum(axis=0), one.person_right.sum(), len(one.person_right)) for one in judged],
        float,
    ).reshape(-1, PARTS + 2)


def right_change(own: Floats, before: Floats) -> list[list[float]]:
    """Of each part and the box the share right, and the 95 % interval of its change."""
    random = np.random.default_rng(SEED)
    drawn = [random.integers(0, len(own), len(own)) for _ in range(_BOOTSTRAPS)]
    change = np.array([_share(own[who]) - _share(before[who]) for who in drawn])
    low, high = np.quantile(change, (0.025, 0.975), axis=0)
    return np.column_stack((_share(own), low, high)).round(4).tolist()


def _share(frames: Floats) -> Floats:
    total = frames.sum(axis=0)
    return np.asarray(total[:-1] / max(total[-1], 1.0))


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


def _known(area: float) -> float | None:
    """An area; None where all samples say the same."""
    return None if np.isnan(area) else round(area, 3)


def loops(report: bool) -> Figures:
    """The loop on each recording there is; `report` does not matter: none is chosen by it."""
    del report
    folders = [real_data() / name for name in RECORDINGS]
    found = [folder for folder in folders if folder.is_dir()]
    return {"recordings": [loop(footage_at(folder)) for folder in found]}


def print_loop(found: Figures) -> None:
    """A recording's figures as lines."""
    print(f"{found['recording']}: labels of {len(found['people'])} people")
    for name, labels in found["labels"].items():
        print(f"  labels {name}; by the five themselves {labels['five areas']}")
        for part, (off, on) in enumerate(labels["five"]):
            told = f"{off} off, {on} on: {labels['chosen'][part]}"
            print(f"    {PART_NAMES[part]:<8} {told}; held out, area:")
            for detector, area in (labels["areas"][part] or {}).items():
                print("      {:<9} {:.3f} ({:.3f} to {:.3f})".format(detector, *area))
    print(f"  right, % of the frames of {found['judged']} others (95 % interval of the change)")
    for name, shares in found["rates"].items():
        told = "  ".join(
            "{:.1f} ({:+.1f} to {:+.1f})".format(*(100 * x for x in s)) for s in shares
        )
        print(f"    {name:<38} {told}", flush=True)


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

"""What to label next: where the detector is least sure, spread over people and time."""

from __future__ import annotations

from collections.abc import Container
from dataclasses import dataclass
from itertools import islice, zip_longest

import numpy as np
from numpy.typing import NDArray

from tracking.arrays import Floats
from tracking.failure.core.detector import Detector
from tracking.failure.core.features import part_features
from tracking.failure.detector_file import built_in_detector
from tracking.failure.labelled_samples import PartStates, part_states, were_hidden
from tracking.failure.past import states_before
from tracking.progress import Progress, no_progress
from tracking.tracks import PARTS, Columns, PartKey

MOST = 200
_APART_S = 0.5
"""Between two suggestions of one part of one person: in frames that follow each other a person
says the same thing twice."""
_TAKING_TURNS = 0.1
"""What each suggestion of a person adds to how unsure their next one must be, in spreads."""
_BLOCK = 4096


@dataclass(frozen=True, slots=True)
class Suggestion:
    """A rectangle worth labelling.

    Attributes:
        frame, track, part: whose, as in the parts that were given.
        score: the detector's, as in `Judgement`.
    """

    frame: int
    track: int
    part: int
    score: float

    @property
    def key(self) -> PartKey:
        """As labels are found by."""
        return self.frame, self.track, self.part


def suggest(
    parts: Columns,
    fps: float,
    detector: Detector,
    labelled: Container[PartKey],
    most: int = MOST,
    report: Progress = no_progress,
) -> list[Suggestion]:
    """Rectangles to label, the one the detector is least sure of first.

    Least sure is the smallest distance to the operating point, measured in the spread of the
    part's scores. Head, torso and hip-leg take turns, as training needs labels of each and scores
    of two parts do not compare. No two of one part of a person are less than half a second apart,
    people take turns, and what is labelled or was occluded is left out.

    Args:
        parts: `PART_COLUMNS` of a run, tracks under the ids of the labels. fps: of the recording.
        labelled: keys of the labels there are.
        most: suggestions.
        report: told how far it is; may raise.
    """
    seen = part_states(parts, fps)
    if not detector.preparation.paper and np.isnan(seen.evidence).all():
        detector = built_in_detector(paper=True)  # the run is older than evidence
    scores = scores_of(seen, fps, detector, report)
    scores[were_hidden(seen.track, seen.frame, parts)] = np.nan
    unsure = np.abs(scores) / _spreads(detector)
    people = np.split(np.arange(len(seen.track)), np.flatnonzero(np.diff(seen.track)) + 1)
    by_part = [
        _people_in_turns(
            [_of_person(rows, part, unsure, scores, seen, fps, labelled, most) for rows in people]
        )
        for part in range(PARTS)
    ]
    turns = (one for turn in zip_longest(*by_part) for one in turn if one is not None)
    return list(islice(turns, most))


def scores_of(
    seen: PartStates, fps: float, detector: Detector, report: Progress = no_progress
) -> Floats:
    """(n, 3) the detector's scores of all states of a run."""
    everything = np.arange(len(seen.track))
    before = states_before(seen.frame / fps, seen.track, seen.states, everything)
    features = part_features(seen.states, before, seen.evidence)
    blocks = []
    for start in range(0, len(features), _BLOCK):
        report(start, len(features))
        blocks.append(detector.judge(features[start : start + _BLOCK]).score)
    return np.concatenate([np.zeros((0, PARTS)), *blocks])


def _spreads(detector: Detector) -> Floats:
    """(3,) how far the scores of each part spread among samples held out."""
    each = [np.concatenate((curve.on, curve.off)) for curve in detector.curves[:PARTS]]
    spreads = np.array([scores.std() if len(scores) else 1.0 for scores in each])
    return np.where(spreads > 0, spreads, 1.0)


def _of_person(
    rows: NDArray[np.int64],
    part: int,
    unsure: Floats,
    scores: Floats,
    seen: PartStates,
    fps: float,
    labelled: Container[PartKey],
    most: int,
) -> list[tuple[float, Suggestion]]:
    """Those of one part of one person, least sure first, with how unsure."""
    found: list[tuple[float, Suggestion]] = []
    apart = _APART_S * fps
    for row in rows[np.argsort(unsure[rows, part], kind="stable")].tolist():
        frame, track = int(seen.frame[row]), int(seen.track[row])
        if len(found) == most or np.isnan(unsure[row, part]):
            break
        near = any(abs(frame - one.frame) < apart for _, one in found)
        if near or (frame, track, part) in labelled:
            continue
        score = float(scores[row, part])
        found.append((float(unsure[row, part]), Suggestion(frame, track, part, score)))
    return found


def _people_in_turns(lists: list[list[tuple[float, Suggestion]]]) -> list[Suggestion]:
    """All of one part, by how unsure and how many of the same person come before."""
    ranked = [
        (unsure + _TAKING_TURNS * turn, one.frame, one.track, one)
        for of_one in lists
        for turn, (unsure, one) in enumerate(of_one)
    ]
    return [one for *_, one in sorted(ranked, key=lambda each: each[:3])]

"""What training measured, on people that were held out: data for a page, a file or the window."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass, replace
from typing import Any

import numpy as np
from numpy.typing import NDArray

from tracking.failure.core.detector import Detector
from tracking.failure.core.operating_points import Curve
from tracking.failure.core.samples import Samples
from tracking.failure.training.adaptation import KEPT
from tracking.failure.training.questions import NAMES, Question
from tracking.failure.training.search import Choice, Tried

MOST_MISTAKES = 24
"""Of each part."""
_OF_ONE_PERSON = 3
_APART_S = 0.75
"""Between two mistakes about one person: closer together they are one."""


@dataclass(frozen=True, slots=True)
class Mistake:
    """A sample the detector is wrong about, although its person was held out.

    Attributes:
        sample: row of the samples. part, recording, track, frame: where to look.
        failed: what the detector says; the label says the opposite.
        score: beyond the operating point, as in `Judgement`.
    """

    sample: int
    part: int
    recording: str
    track: int
    frame: int
    failed: bool
    score: float


@dataclass(frozen=True, slots=True, eq=False)
class QuestionReport:
    """How well one question is answered.

    Attributes:
        name: of the part, or "several".
        curve: operating points. threshold: the one chosen.
        confusion: (2, 2) rows: on its part, off it (one part, several); columns: found so, failed.
        tried: the grid's results, with the preparation that was chosen. candidate: chosen.
        mistakes: most informative first; none for one-or-several.
        area_before: under the curve of the machine that was adapted, on the same samples; NaN
            where none was.
    """

    name: str
    curve: Curve
    threshold: float
    confusion: NDArray[np.int64]
    tried: tuple[Tried, ...]
    candidate: str
    mistakes: tuple[Mistake, ...]
    area_before: float = math.nan

    @property
    def false_alarms(self) -> float:
        """Share of those on their part that fail."""
        return self.curve.false_alarms(self.threshold)

    @property
    def found(self) -> float:
        """Share of those off their part that fail."""
        return self.curve.found(self.threshold)


@dataclass(frozen=True, slots=True, eq=False)
class TrainingReport:
    """What training measured, a question each, and what it was made from.

    Attributes:
        by_size: whether features are measured in bodies. folds: how many.
        detector: in short what was trained; its origin says from what.
        adapted: whether a detector that there was has been adapted.
    """

    questions: tuple[QuestionReport, ...]
    by_size: bool
    folds: int
    detector: Detector
    adapted: bool = False

    @property
    def kept(self) -> tuple[QuestionReport, ...]:
        """Those whose machine is the one there was: people held out find no mixture better."""
        return tuple(one for one in self.questions if self.adapted and one.candidate == KEPT)

    def of_rows(self, rows: NDArray[np.int64]) -> TrainingReport:
        """The same where the samples were these rows of others: mistakes name rows of those."""
        questions = tuple(
            replace(
                one,
                mistakes=tuple(replace(its, sample=int(rows[its.sample])) for its in one.mistakes),
            )
            for one in self.questions
        )
        return replace(self, questions=questions)

    @property
    def by_chance(self) -> tuple[QuestionReport, ...]:
        """Those whose answers are no better than chance."""
        return tuple(one for one in self.questions if one.curve.by_chance)

    def as_json(self) -> dict[str, Any]:
        """Plain values; shares of nothing are null."""
        origin = self.detector.origin
        return {
            "detector": self.detector.fingerprint,
            "samples": {
                name: {"off": int(off), "on": int(on)}
                for name, (off, on) in zip(NAMES, origin.counts.tolist(), strict=False)
            },
            "people": origin.people,
            "recordings": list(origin.recordings),
            "folds": self.folds,
            "no_better_than_chance": [question.name for question in self.by_chance],
            "measured_in": "bodies" if self.by_size else "pixels",
            "features": "paper" if self.detector.preparation.paper else "all",
            "adapted": self.adapted,
            "kept": [question.name for question in self.kept],
            "questions": {question.name: _as_json(question) for question in self.questions},
        }


def question_report(
    question: Question,
    scores: NDArray[np.float64],
    threshold: float,
    samples: Samples,
    choice: Choice,
    tried: Sequence[Tried],
    before: NDArray[np.float64] | None = None,
) -> QuestionReport:
    """The report on a question by held-out scores (n,), `before` those before adaptation."""
    failed = scores > threshold
    confusion = np.array(
        [
            [int((failed[question.yes == yes] == said).sum()) for said in (False, True)]
            for yes in (False, True)
        ]
    )
    on, off = np.sort(scores[~question.yes]), np.sort(scores[question.yes])
    of_it = tuple(
        one for one in tried if (one.question, one.by_size) == (question.number, choice.by_size)
    )
    candidate = str(choice.candidates[question.number])
    mistakes = _mistakes(question, scores - threshold, samples) if question.number < 3 else ()
    area = math.nan
    if before is not None:
        area = Curve(np.sort(before[~question.yes]), np.sort(before[question.yes])).area()
    return QuestionReport(
        question.name, Curve(on, off), threshold, confusion, of_it, candidate, mistakes, area
    )


def _mistakes(
    question: Question, scores: NDArray[np.float64], samples: Samples
) -> tuple[Mistake, ...]:
    """Those farthest on the wrong side first; a few of one person, and no neighbours."""
    wrong = np.flatnonzero((scores > 0) != question.yes)
    taken: dict[int, list[float]] = {}
    times_s = samples.times_s()
    mistakes: list[Mistake] = []
    for row in wrong[np.argsort(-np.abs(scores[wrong]), kind="stable")].tolist():
        mistake = _mistake(int(question.rows[row]), float(scores[row]), samples)
        before = taken.setdefault(int(question.people[row]), [])
        time_s = float(times_s[mistake.sample])
        near = any(abs(earlier - time_s) < _APART_S for earlier in before)
        if not near and len(before) < _OF_ONE_PERSON and len(mistakes) < MOST_MISTAKES:
            before.append(time_s)
            mistakes.append(mistake)
    return tuple(mistakes)


def _mistake(sample: int, score: float, samples: Samples) -> Mistake:
    part, recording, track, frame = (
        samples.columns[name][sample] for name in ("part", "recording", "track", "frame")
    )
    return Mistake(sample, int(part), str(recording), int(track), int(frame), score > 0, score)


def _as_json(question: QuestionReport) -> dict[str, Any]:
    points = question.curve.points()
    points = points[np.unique(np.linspace(0, len(points) - 1, 201).round().astype(int))]
    return {
        "chosen": question.candidate,
        "threshold": question.threshold,
        "false_alarms": _known(question.false_alarms),
        "found": _known(question.found),
        "area_under_curve": _known(question.curve.area()),
        "area_before": _known(question.area_before),
        "confusion": question.confusion.tolist(),
        "curve": [{"false_alarms": fa, "found": found} for _, fa, found in points.tolist()],
        "tried": [{"what": str(one.candidate), "worth": one.worth} for one in question.tried],
        "mistakes": [
            {
                "recording": one.recording,
                "track": one.track,
                "frame": one.frame,
                "said": "failed" if one.failed else "on its part",
                "score": one.score,
            }
            for one in question.mistakes
        ],
    }


def _known(value: float) -> float | None:
    return None if math.isnan(value) else value

"""What training measured, with an operating point that can be moved."""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from app.core.i18n import joined, time_text, tr
from app.core.scenes.part_names import part_name
from app.features.parts.training_set import Source, TrainingSet
from tracking.failure import Curve, Detector, Trained
from tracking.failure.training import Mistake
from tracking.tracks import PART_NAMES, Box

Floats = NDArray[np.float64]


@dataclass(frozen=True, slots=True, eq=False)
class RocCurve:
    """One part's curve and where on it the detector works.

    Attributes:
        false_alarms, found: (p,) shares, ascending. at: false alarms and found at the point.
    """

    name: str
    false_alarms: Floats
    found: Floats
    at: tuple[float, float]


@dataclass(frozen=True, slots=True)
class PartFigures:
    """How well a part is judged at the operating point, on people that were held out.

    Attributes:
        on, off: samples on and off their part. found: of those off, how many are called failed;
            false_alarms: of those on.
        area: under the whole curve: 1 always right, 0.5 chance.
    """

    name: str
    on: int
    off: int
    false_alarms: int
    found: int
    area: float

    @property
    def said(self) -> str:
        """In words, for screen readers."""
        return tr(
            "{part}: {found} of {off} failures found, {alarms} of {on} false alarms, "
            "area under the curve {area:.2f}",
            part=self.name,
            found=self.found,
            off=self.off,
            alarms=self.false_alarms,
            on=self.on,
            area=self.area,
        )


@dataclass(frozen=True, slots=True)
class MistakeItem:
    """Something the detector is wrong about, worth a look.

    Attributes:
        source: where the label comes from. recording: its name. mistake: what is wrong and where.
        box: the rectangle that was judged; None where the source does not say.
        title: e.g. "head of 3". said: what is wrong, in words. when: e.g. "00:01.70"; "" where
            it is not known how fast the recording is.
    """

    source: Source
    recording: str
    mistake: Mistake
    box: Box | None
    title: str
    said: str
    when: str

    @property
    def frame(self) -> int:
        """Where to look."""
        return self.mistake.frame

    @property
    def track(self) -> int:
        """Whose part it is."""
        return self.mistake.track

    @property
    def part(self) -> int:
        """Which part it is."""
        return self.mistake.part


@dataclass(frozen=True, slots=True, eq=False)
class ResultScene:
    """The page of a training's result.

    Attributes:
        curves: of head, torso and hip-leg. chosen: whose point is moved; -1: of all alike.
        figures: a part each. several: of several parts lost at once; None where not learnt.
        lines: what it was made from. details: how, for who wants to know it exactly.
        mistakes: most informative first. warning: what is no better than chance, and what to do;
            "" where nothing is.
    """

    curves: tuple[RocCurve, ...]
    chosen: int
    figures: tuple[PartFigures, ...]
    lines: tuple[str, ...]
    mistakes: tuple[MistakeItem, ...] = ()
    warning: str = ""
    details: str = ""
    several: PartFigures | None = None


class TrainingResult:
    """A trained detector whose operating point can be moved.

    Attributes:
        trained: as it came from the training. training_set: from what. detector: as it stands.
        chosen: the part whose point is moved; -1: that of all.
    """

    def __init__(self, trained: Trained, training_set: TrainingSet) -> None:
        self.trained = trained
        self.training_set = training_set
        self.detector: Detector = trained.detector
        self.chosen = -1
        self._areas = [curve.area() for curve in self._curves]
        self._points = [curve.points() for curve in self._curves]

    @property
    def _curves(self) -> tuple[Curve, ...]:
        return self.detector.curves[: len(PART_NAMES)]

    def put(self, false_alarms: float) -> None:
        """Work with at most this share of false alarms: of all parts, or of the chosen one."""
        thresholds = self.detector.thresholds.tolist()
        for part in self._meant:
            thresholds[part] = self._curves[part].threshold_for(min(max(false_alarms, 0.0), 1.0))
        self.detector = self.detector.with_thresholds(thresholds)

    def step(self, way: int) -> None:
        """One sample on its part more (1) or less (-1) that is called failed."""
        for part in self._meant:
            on = self._curves[part].on
            if not len(on):
                continue
            thresholds = self.detector.thresholds.tolist()
            alarms = int((on > thresholds[part]).sum()) + way
            share = min(max(alarms, 0), len(on)) / len(on)
            thresholds[part] = self._curves[part].threshold_for(share)
            self.detector = self.detector.with_thresholds(thresholds)

    @property
    def _meant(self) -> range:
        return range(len(PART_NAMES)) if self.chosen < 0 else range(self.chosen, self.chosen + 1)

    def scene(self) -> ResultScene:
        """The page as it stands."""
        rates = self.detector.rates()
        curves = tuple(
            RocCurve(part_name(part), points[:, 1], points[:, 2], (float(alarm), float(found)))
            for part, (points, (alarm, found)) in enumerate(
                zip(self._points, rates.tolist(), strict=True)
            )
        )
        figures = tuple(self._figures(part) for part in range(len(PART_NAMES)))
        lines, mistakes, warning = self._lines(), self._mistakes(), self._warning()
        details = tr("Parameters: {chosen}", chosen=self.detector.origin.chosen)
        return ResultScene(
            curves,
            self.chosen,
            figures,
            lines,
            mistakes,
            warning,
            details,
            self._several(),
        )

    def _figures(self, part: int) -> PartFigures:
        curve, threshold = self._curves[part], float(self.detector.thresholds[part])
        alarms, found = int((curve.on > threshold).sum()), int((curve.off > threshold).sum())
        on, off, area = len(curve.on), len(curve.off), self._areas[part]
        return PartFigures(part_name(part), on, off, alarms, found, area)

    def _several(self) -> PartFigures | None:
        """Of one part lost or several: found are several told, false alarms one taken for it."""
        asked = self.trained.report.questions[len(PART_NAMES) :]
        if not asked:
            return None
        (one, alarms), (_, found) = asked[0].confusion.tolist()
        several = int(asked[0].confusion[1].sum())
        area = asked[0].curve.area()
        return PartFigures(tr("several at once"), one + alarms, several, alarms, found, area)

    def _warning(self) -> str:
        """What the detector tells no better than chance: those who use it should know."""
        questions = self.trained.report.questions
        names = [
            part_name(number) if number < len(PART_NAMES) else tr("one part or several")
            for number, one in enumerate(questions)
            if one.curve.by_chance
        ]
        if not names:
            return ""
        return tr(
            "No better than chance: {names}. Look over the labels or label more parts before "
            "people are tracked with this detector.",
            names=joined(", ", names),
        )

    def _lines(self) -> tuple[str, ...]:
        origin, report = self.detector.origin, self.trained.report
        several = (
            tr(
                "Several at once: how well the detector recognizes that more than one part is "
                "lost. A false alarm: one lost part is called several."
            )
            if len(report.questions) > len(PART_NAMES)
            else tr(
                "Too few labels show several parts lost at once: the detector learnt nothing "
                "about that."
            )
        )
        measured = (
            tr("Lengths are measured in sizes of the person.")
            if report.by_size
            else tr("Lengths are measured in pixels.")
        )
        return (
            tr(
                "{n} samples of {people} people in {recordings}",
                n=int(origin.counts.sum()),
                people=origin.people,
                recordings=joined(", ", origin.recordings),
            ),
            tr("Each figure is of people who were not in the training ({n} folds)", n=report.folds),
            *self._against_before(),
            several,
            measured,
        )

    def _against_before(self) -> tuple[str, ...]:
        """How the built-in detector judges the same people, and what is kept of it."""
        parts = self.trained.report.questions[: len(PART_NAMES)]
        told = [
            tr("{part} {area:.2f}", part=part_name(number), area=one.area_before)
            for number, one in enumerate(parts)
            if not math.isnan(one.area_before)
        ]
        kept = [
            part_name(number) for number, one in enumerate(parts) if one in self.trained.report.kept
        ]
        lines = []
        if told:
            areas = joined(", ", told)
            lines.append(tr("Area under the curve of the built-in detector: {areas}", areas=areas))
        if kept:
            names = joined(", ", kept)
            lines.append(
                tr(
                    "Kept from the built-in detector, as nothing learnt is better: {names}",
                    names=names,
                )
            )
        return tuple(lines)

    def _mistakes(self) -> tuple[MistakeItem, ...]:
        """Those that are still mistakes at the operating point, the parts by turns."""
        by_turns: list[tuple[int, int, Mistake]] = []
        for part, question in enumerate(self.trained.report.questions[: len(PART_NAMES)]):
            lift = question.threshold - float(self.detector.thresholds[part])
            wrong = [one for one in question.mistakes if (one.score + lift > 0) == one.failed]
            by_turns += [(turn, part, one) for turn, one in enumerate(wrong)]
        return tuple(self._item(one) for _, _, one in sorted(by_turns, key=lambda each: each[:2]))

    def _item(self, one: Mistake) -> MistakeItem:
        said = tr("called failed, labelled on") if one.failed else tr("missed, labelled off")
        title = tr("{part} of {track}", part=part_name(one.part), track=one.track)
        source = self.training_set.source_of(one.sample)
        when = time_text(one.frame / source.fps) if source.fps else ""
        recording = source.recording or one.recording
        box = self.training_set.box_of(one.sample)
        return MistakeItem(source, recording, one, box, title, said, when)

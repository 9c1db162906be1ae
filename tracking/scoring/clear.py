"""CLEAR MOT: misses, false positives, switches, and how long people are followed."""

from __future__ import annotations

import math
from dataclasses import dataclass

from tracking.scoring.conventions import Conventions


@dataclass(frozen=True, slots=True)
class Clear:
    """[Bernardin2008], counted as TrackEval counts; the measures follow from the counts.

    Attributes:
        matches: rows of people that were found, switches among them.
        misses, false_positives: rows of people, and of tracks, that were not matched.
        id_switches: a person is matched to another track than the last time it was matched.
        fragmentations: a person is matched again after frames without a match.
        mostly_tracked: people matched in more than 80 % of their frames.
        partly_tracked: people matched in 20 % to 80 %.
        mostly_lost: people matched in fewer than 20 %.
        frames: length of the recording.
        similarity: sum over the matches.
        one_sided: there was nothing to compare: every share is 0. False for what is combined.
        conventions: whose definitions of the shares are in force.
        unit: what a similarity of 0 means in py-motmetrics' distance: 1 for boxes, metres on the
            floor.
    """

    matches: int
    misses: int
    false_positives: int
    id_switches: int
    fragmentations: int
    mostly_tracked: int
    partly_tracked: int
    mostly_lost: int
    frames: int
    similarity: float
    one_sided: bool = False
    conventions: Conventions = Conventions.TRACKEVAL
    unit: float = 1.0

    @property
    def reported_matches(self) -> int:
        """Matches as the conventions report them; see `Conventions.reported_matches`."""
        return self.conventions.reported_matches(self.matches, self.id_switches)

    @property
    def truth_rows(self) -> int:
        """Rows of people that count."""
        return self.matches + self.misses

    @property
    def result_rows(self) -> int:
        """Rows of the result that count."""
        return self.matches + self.false_positives

    @property
    def people(self) -> int:
        """People in the truth."""
        return self.mostly_tracked + self.partly_tracked + self.mostly_lost

    @property
    def mota(self) -> float:
        """1 - (misses + false positives + switches) / truth rows."""
        right = self.matches - self.false_positives - self.id_switches
        return self._share(right, self.truth_rows)

    @property
    def moda(self) -> float:
        """The same without switches."""
        return self._share(self.matches - self.false_positives, self.truth_rows)

    @property
    def motal(self) -> float:
        """The same with the logarithm (to base 10) of the switches."""
        switches = math.log10(self.id_switches) if self.id_switches else 0.0
        return self._share(self.matches - self.false_positives - switches, self.truth_rows)

    @property
    def smota(self) -> float:
        """MOTA where every match weighs as much as it is alike."""
        right = self.similarity - self.false_positives - self.id_switches
        return self._share(right, self.truth_rows)

    @property
    def motp(self) -> float:
        """Mean similarity of the matched pairs; as py-motmetrics has it their mean distance."""
        if self.conventions is Conventions.MOTMETRICS:
            return self._share(self.unit * (self.matches - self.similarity), self.matches)
        return self._share(self.similarity, self.matches)

    @property
    def recall(self) -> float:
        """Matches / truth rows."""
        return self._share(self.matches, self.truth_rows)

    @property
    def precision(self) -> float:
        """Matches / result rows."""
        return self._share(self.matches, self.result_rows)

    @property
    def f1(self) -> float:
        """Harmonic mean of recall and precision."""
        wrong = 0.5 * self.misses + 0.5 * self.false_positives
        return self._share(self.matches, self.matches + wrong)

    @property
    def false_positives_per_frame(self) -> float:
        """False positives / frames."""
        return self._share(self.false_positives, self.frames)

    @property
    def mostly_tracked_share(self) -> float:
        """Of the people."""
        return self._share(self.mostly_tracked, self.people)

    @property
    def partly_tracked_share(self) -> float:
        """Of the people."""
        return self._share(self.partly_tracked, self.people)

    @property
    def mostly_lost_share(self) -> float:
        """Of the people; 1 where there was nothing to compare."""
        return 1.0 if self.one_sided else self._share(self.mostly_lost, self.people)

    def _share(self, part: float, whole: float) -> float:
        if self.conventions is Conventions.MOTMETRICS:
            return part / whole if whole else math.nan
        return 0.0 if self.one_sided else part / max(1.0, whole)

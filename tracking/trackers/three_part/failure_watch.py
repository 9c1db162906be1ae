"""The failure detector at work, frame by frame."""

from __future__ import annotations

import numpy as np

from tracking.failure import Detector, Judgement, PastStates, part_features
from tracking.trackers.three_part.people import Flags, PartPeople


class Watch:
    """Judges which parts were lost, by where they stand and stood, and by what speaks for it."""

    def __init__(self, detector: Detector | None) -> None:
        """Without a detector nothing is ever judged."""
        self.detector = detector
        self._past = PastStates()

    def judge(self, time_s: float, people: PartPeople, watched: Flags) -> Judgement:
        """What the detector says of the people; of those not watched nothing.

        Args:
            watched: (people,) nobody else and nothing drawn hides a part of them.
        """
        count = len(people)
        failed = np.zeros((count, 3), bool)
        score = np.full((count, 3), np.nan)
        several = np.zeros(count, bool)
        rows = np.flatnonzero(watched)
        if self.detector is not None and len(rows):
            now = people.state[rows]
            before = self._past.before(time_s, people.track[rows], now)
            said = self.detector.judge(part_features(now, before, people.evidence[rows]))
            failed[rows], score[rows], several[rows] = said.failed, said.score, said.several
        return Judgement(failed, score, several)

    def remember(self, time_s: float, people: PartPeople) -> None:
        """Keep where the parts are, after any adjustment."""
        self._past.remember(time_s, people.track, people.state)

"""The measures once more, frame by frame and slowly, to check the fast ones against."""

from __future__ import annotations

from collections import defaultdict
from typing import Any

import numpy as np
from scipy.optimize import linear_sum_assignment

from tracking.scoring import ScoringTable

EPS = float(np.finfo(float).eps)
Matrix = Any


def overlap(a: Matrix, b: Matrix) -> float:
    wide = min(a[0] + a[2], b[0] + b[2]) - max(a[0], b[0])
    high = min(a[1] + a[3], b[1] + b[3]) - max(a[1], b[1])
    shared = max(wide, 0) * max(high, 0)
    return shared / (a[2] * a[3] + b[2] * b[3] - shared)


def best(total: Matrix) -> list[tuple[int, int]]:
    rows, columns = linear_sum_assignment(-total)
    return [(r, c) for r, c in zip(rows, columns, strict=True) if total[r, c] > EPS]


class PlainScore:
    """Everything of one sequence, kept in lists and dictionaries."""

    def __init__(self, truth: ScoringTable, result: ScoringTable) -> None:
        self.frames = [self.frame(truth, result, n) for n in range(self.length(truth, result))]
        self.people = {p for people, _, _ in self.frames for p in people}
        self.truth_rows = sum(len(people) for people, _, _ in self.frames)
        self.result_rows = sum(len(tracks) for _, tracks, _ in self.frames)
        self.matches = self.match()

    @staticmethod
    def length(truth: ScoringTable, result: ScoringTable) -> int:
        return int(max([-1, *truth.frame, *result.frame])) + 1

    @staticmethod
    def frame(truth: ScoringTable, result: ScoringTable, number: int) -> Any:
        """People, tracks and their overlaps in a frame, without don't-cares."""
        rows, columns = (
            np.flatnonzero(truth.frame == number),
            np.flatnonzero(result.frame == number),
        )
        alike = np.array(
            [
                [
                    overlap(truth.box[r] + [1, 1, 0, 0], result.box[c] + [1, 1, 0, 0])
                    for c in columns
                ]
                for r in rows
            ]
        ).reshape(len(rows), len(columns))
        pairs = best(np.where(alike < 0.5 - EPS, 0, alike)) if alike.size else []
        dropped = [c for r, c in pairs if not truth.counted[rows[r]]]
        kept = truth.counted[rows]
        alike = np.delete(alike, dropped, axis=1)[kept]
        return list(truth.track[rows][kept]), list(np.delete(result.track[columns], dropped)), alike

    def match(self) -> list[list[tuple[int, int, float]]]:
        """Per frame the matched people and tracks with their overlap."""
        partners: dict[int, int] = {}
        matches = []
        for people, tracks, alike in self.frames:
            if not people or not tracks:
                matches.append([])
                continue
            loyal = [[partners.get(p) == t for t in tracks] for p in people]
            pairs = best(np.where(alike < 0.5 - EPS, 0, alike + 1000 * np.array(loyal)))
            partners = {people[r]: tracks[c] for r, c in pairs}
            matches.append([(people[r], tracks[c], alike[r, c]) for r, c in pairs])
        return matches

    def clear(self) -> dict[str, float]:
        found = [m for frame in self.matches for m in frame]
        last: dict[int, int] = {}
        switches = 0
        for person, track, _ in found:
            switches += last.get(person, track) != track
            last[person] = track
        misses, false = self.truth_rows - len(found), self.result_rows - len(found)
        return {
            "id_switches": switches,
            "misses": misses,
            "false_positives": false,
            "fragmentations": sum(self.fragments(p) for p in self.people),
            "MOTA": 1 - (misses + false + switches) / self.truth_rows,
            "MOTP": sum(m[2] for m in found) / max(1, len(found)),
        }

    def fragments(self, person: int) -> int:
        """Stretches of matches, over frames with rows on both sides, after the first."""
        both = [m for m, (p, t, _) in zip(self.matches, self.frames, strict=True) if p and t]
        seen = [any(m[0] == person for m in frame) for frame in both]
        starts = sum(now and not before for before, now in zip([False, *seen], seen, strict=False))
        return max(0, starts - 1)

    def identity(self) -> dict[str, float]:
        together: dict[tuple[int, int], int] = defaultdict(int)
        for people, tracks, alike in self.frames:
            for r, c in zip(*np.nonzero(alike >= 0.5), strict=True):
                together[people[r], tracks[c]] += 1
        people, tracks = sorted(self.people), sorted({t for _, ts, _ in self.frames for t in ts})
        total = np.array([[together[p, t] for t in tracks] for p in people])
        right = total[linear_sum_assignment(-total)].sum()
        return {
            "IDF1": 2 * right / (self.truth_rows + self.result_rows),
            "IDP": right / self.result_rows,
            "IDR": right / self.truth_rows,
        }

    def hota(self) -> dict[str, float]:
        lives: dict[Any, int] = defaultdict(int)
        fit: dict[tuple[int, int], float] = defaultdict(float)
        for people, tracks, alike in self.frames:
            for p in people:
                lives["person", p] += 1
            for t in tracks:
                lives["track", t] += 1
            for r, c in zip(*np.nonzero(alike), strict=True):
                share = alike[r, c] / (alike[r].sum() + alike[:, c].sum() - alike[r, c])
                fit[people[r], tracks[c]] += share

        def lived(p: int, t: int) -> int:
            return lives["person", p] + lives["track", t]

        matched = []
        for people, tracks, alike in self.frames:
            if alike.size:
                agree = [[fit[p, t] / (lived(p, t) - fit[p, t]) for t in tracks] for p in people]
                pairs = best(np.array(agree) * alike)
                matched += [(people[r], tracks[c], alike[r, c]) for r, c in pairs]
        rows = [self.hota_at(a, matched, lived) for a in np.arange(0.05, 0.99, 0.05)]
        return dict(zip(("HOTA", "DetA", "AssA", "LocA"), np.mean(rows, axis=0), strict=True))

    def hota_at(self, alpha: float, matched: Any, lived: Any) -> tuple[float, ...]:
        here = [m for m in matched if m[2] >= alpha - EPS]
        count: dict[tuple[int, int], int] = defaultdict(int)
        for p, t, _ in here:
            count[p, t] += 1
        deta = len(here) / (self.truth_rows + self.result_rows - len(here))
        assa = sum(n * n / (lived(*pair) - n) for pair, n in count.items()) / max(1, len(here))
        loca = sum(m[2] for m in here) / len(here) if here else 1.0
        return float(np.sqrt(deta * assa)), deta, assa, loca

    def papers(self) -> tuple[int, int]:
        found = [(n, p, t) for n, frame in enumerate(self.matches) for p, t, _ in frame]
        detected = [p for p in self.people if sum(m[1] == p for m in found) >= 10]
        return len(detected), sum(self.is_kept(p, found) for p in detected)

    def is_kept(self, person: int, found: list[tuple[int, int, int]]) -> bool:
        own = [m for m in found if m[1] == person]
        first, last, track = own[0][0], own[-1][0], own[0][2]
        stolen = any(m[2] == track and m[1] != person and m[0] <= last for m in found)
        lived = sum(person in people for people, _, _ in self.frames[first:])
        return {m[2] for m in own} == {track} and not stolen and 2 * len(own) >= lived

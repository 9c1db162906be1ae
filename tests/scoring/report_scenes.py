"""A small report that has every kind of error in it."""

from __future__ import annotations

import numpy as np
from scenes_of_rows import standing, table

from tracking.geometry import Camera, Ground, View
from tracking.recording import StereoFrame
from tracking.scoring.report import (
    Finding,
    Footage,
    ScoreReport,
    Subject,
    Yardstick,
    finding_of,
    report_of,
)

NAME = "</svg><script>told = 1</script>|[x](y)"
"""What somebody may call a recording."""

START, FRAMES = 100, 60


class Grey:
    """Pictures of nothing, each a little lighter than the one before."""

    frame_count = START + FRAMES

    def read(self, number: int) -> StereoFrame:
        """A frame."""
        return StereoFrame(number, number / 25, np.full((240, 320, 3), number, np.uint8), None)


def subject(name: str = NAME, footage: Footage | None = None) -> Subject:
    """Two people; track 1 leaves the first to 2, misses the second a while, and sees a ghost."""
    truth = [*standing(1, range(FRAMES), 1, 1), *standing(2, range(10, FRAMES), 6, 3)]
    first = [
        *standing(1, range(30), 1, 1),
        *standing(2, range(30, FRAMES), 1, 1),
        *standing(3, [*range(10, 20), *range(25, FRAMES)], 6, 3),
        *standing(4, range(40, 45), 12, 8),
    ]
    better = [*standing(1, range(FRAMES), 1, 1), *standing(2, range(10, FRAMES), 6, 3)]
    results = {"first<b>": table(first), "better": table(better)}
    return Subject(name, table(truth), results, START, START + FRAMES, footage or Footage(25.0))


def filmed() -> Footage:
    """A camera over the floor, and its pictures."""
    matrix = np.array([[300.0, 0.0, 160.0], [0.0, 300.0, 120.0], [0.0, 0.0, 1.0]])
    view = View(Camera(matrix, np.zeros(0), 320, 240), Ground(3.0, 40.0))
    return Footage(25.0, (320, 240), view, Grey())


def found(name: str = NAME, footage: Footage | None = None) -> list[Finding]:
    """Both results measured."""
    one = subject(name, footage)
    return [finding_of(one, result, Yardstick(ranges=((100, 130),))) for result in one.results]


def report(*names: str) -> ScoreReport:
    """The report on sequences of these names."""
    findings = [one for name in names or (NAME,) for one in found(name)]
    return report_of(findings, Yardstick())

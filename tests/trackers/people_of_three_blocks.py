"""People of three coloured blocks before a speckled wall, as perception of one camera sees them."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass

import numpy as np

from tracking.people import Detections, Observation, Overlays

SIZE = (320, 200)
FPS = 20.0
HEIGHT, WIDTH = 100, 32
PARTS = ((10, 0, 12, 16), (0, 16, 32, 36), (4, 52, 24, 48))
"""Head, torso and legs within a person: left, top, width, height."""


@dataclass(frozen=True)
class Blocks:
    """Somebody; nearer ones stand lower.

    Attributes:
        left_top: frame -> left, top px, or None where they are not there.
        colours: of the three blocks, blue, green, red.
    """

    left_top: Callable[[int], tuple[float, float] | None]
    colours: tuple[tuple[int, int, int], ...]


RED_BLUE = ((40, 60, 90), (30, 30, 200), (160, 60, 40))
GREEN_BROWN = ((190, 210, 230), (60, 160, 60), (30, 50, 90))


def walking(start: tuple[float, float], step: tuple[float, float]) -> Callable[[int], tuple]:
    return lambda frame: (start[0] + step[0] * frame, start[1] + step[1] * frame)


def part_box(person: Blocks, frame: int, part: int) -> np.ndarray:
    """(4,) left, top, right, bottom of a part."""
    left, top = person.left_top(frame)
    x, y, width, height = PARTS[part]
    return np.array((left + x, top + y, left + x + width, top + y + height))


def observations(
    people: Sequence[Blocks], frames: int, pillar: tuple[int, int] | None = None, first: int = 0
) -> Iterator[Observation]:
    """Frame by frame; a pillar is columns of the picture that hide people."""
    random = np.random.default_rng(4100)
    wall = random.integers(100, 150, (SIZE[1], SIZE[0], 3)).astype(np.uint8)
    speckle = random.integers(-12, 13, (SIZE[1], SIZE[0], 3))
    for frame in range(first, frames):
        picture, regions = wall.astype(np.int64), np.zeros((SIZE[1], SIZE[0]), np.int32)
        there = [one for one in people if one.left_top(frame) is not None]
        for one in sorted(there, key=lambda one: one.left_top(frame)[1]):
            _paint(picture, regions, one, frame, people.index(one) + 1, pillar)
        painted = np.clip(picture + np.where(regions[..., None] > 0, speckle, 0), 0, 255)
        yield Observation(
            frame,
            frame / FPS,
            seen_in(regions),
            Overlays((regions > 0).astype(np.uint8) * np.uint8(255), None),
            painted.astype(np.uint8),
        )


def _paint(picture, regions, person, frame, number, pillar) -> None:
    for part, colour in enumerate(person.colours):
        left, top, right, bottom = np.rint(part_box(person, frame, part)).astype(int)
        rows = slice(max(top, 0), max(bottom, 0))
        columns = np.arange(max(left, 0), min(max(right, 0), SIZE[0]))
        if pillar is not None:
            columns = columns[(columns < pillar[0]) | (columns >= pillar[1])]
        picture[rows, columns] = colour
        regions[rows, columns] = number


def seen_in(regions: np.ndarray) -> Detections:
    """One region for each person of whom enough shows."""
    numbers = [n for n in np.unique(regions[regions > 0]) if (regions == n).sum() > 150]
    boxes, cut, ordered = [], [], np.zeros_like(regions)
    for k, number in enumerate(numbers):
        rows, columns = np.nonzero(regions == number)
        ordered[rows, columns] = k + 1
        low, high = (columns.min(), rows.min()), (columns.max() + 1, rows.max() + 1)
        boxes.append((low[0] - 0.5, low[1] - 0.5, high[0] - low[0], high[1] - low[1]))
        cut.append(low[0] == 0 or high[0] == SIZE[0] or low[1] == 0 or high[1] == SIZE[1])
    n = len(boxes)
    return Detections(
        box=np.array(boxes, np.float64).reshape(n, 4),
        position=np.full((n, 3), np.nan),
        size=np.full((n, 2), np.nan),
        merged=np.zeros(n, bool),
        truncated=np.array(cut, bool),
        upper=np.zeros((n, 16), np.float32),
        lower=np.zeros((n, 16), np.float32),
        middle=np.zeros((n, 64), np.float32),
        regions=ordered,
        clothes=np.full((n, 2, 3), np.nan, np.float32),
        from_detector=np.zeros(n, bool),
    )

"""Labels of body parts: many small values, of which each edit changes a few."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping
from dataclasses import dataclass

from tracking.tracks.body_parts import PARTS

PartKey = tuple[int, int, int]
"""frame, track, part."""
Box = tuple[float, float, float, float]
"""left, top, width, height in 0-based pixels of the left image as recorded."""

PART_SOURCES = ("tracker", "person", "truth")
"""By the number in the session file."""
_BLOCK_FRAMES = 256
_Frame = Mapping[tuple[int, int], "PartLabel"]
_Blocks = Mapping[int, Mapping[int, _Frame]]


@dataclass(frozen=True, slots=True)
class PartLabel:
    """A body part's rectangle in one frame, and whether it lies on its part.

    Attributes:
        frame, track: whose and when.
        part: 0 head, 1 torso, 2 hip-leg.
        box: left, top, width, height in pixels of the left image as recorded.
        on_part: whether the rectangle lies on its part; None: unsure.
        source: who drew the rectangle, one of `PART_SOURCES`.
        author: who said it; "" where nobody knows.
        reason: why it was suggested to them; "" where they chose it themselves.
    """

    frame: int
    track: int
    part: int
    box: Box
    on_part: bool | None = True
    source: str = "person"
    author: str = ""
    reason: str = ""

    @property
    def key(self) -> PartKey:
        """There is one label a frame, track and part."""
        return self.frame, self.track, self.part


class PartLabels(Mapping[PartKey, PartLabel]):
    """Part labels by frame, track and part: a value that is never changed.

    Another one with a few labels changed shares the rest with this one, so that the hundred
    thousandth label costs what the first one does.
    """

    __slots__ = ("_blocks", "_count")

    def __init__(self, labels: Iterable[PartLabel] = ()) -> None:
        """Of two labels with one key the later one counts."""
        blocks: dict[int, dict[int, dict[tuple[int, int], PartLabel]]] = {}
        for label in labels:
            block = blocks.setdefault(label.frame // _BLOCK_FRAMES, {})
            block.setdefault(label.frame, {})[label.track, label.part] = label
        self._blocks: _Blocks = blocks
        self._count = sum(len(frame) for block in blocks.values() for frame in block.values())

    def __getitem__(self, key: PartKey) -> PartLabel:
        """The label; KeyError where there is none."""
        frame, track, part = key
        return self._blocks[frame // _BLOCK_FRAMES][frame][track, part]

    def __iter__(self) -> Iterator[PartKey]:
        """All keys, by frame, track and part."""
        for number in sorted(self._blocks):
            block = self._blocks[number]
            for frame in sorted(block):
                for track, part in sorted(block[frame]):
                    yield frame, track, part

    def __len__(self) -> int:
        """How many labels there are."""
        return self._count

    def __eq__(self, other: object) -> bool:
        """Whether the other says the same."""
        return self._blocks == other._blocks if isinstance(other, PartLabels) else NotImplemented

    def of_frame(self, frame: int) -> tuple[PartLabel, ...]:
        """The labels of one frame, by track and part."""
        found = self._blocks.get(frame // _BLOCK_FRAMES, {}).get(frame, {})
        return tuple(found[key] for key in sorted(found))

    def of_track(self, track: int, start: int, end: int) -> tuple[PartLabel, ...]:
        """The labels of one track in a half-open range of frames, by frame and part."""
        first, last = start // _BLOCK_FRAMES, (end - 1) // _BLOCK_FRAMES
        return tuple(
            block[frame][track, part]
            for number, block in sorted(self._blocks.items())
            if first <= number <= last
            for frame in sorted(block)
            if start <= frame < end
            for part in range(PARTS)
            if (track, part) in block[frame]
        )

    def unlike(self, other: PartLabels) -> tuple[list[PartLabel], list[PartLabel]]:
        """The labels of the frames in which the two differ: here, and in the other.

        Of two that share most of their labels only the rest is looked at.
        """
        here: list[PartLabel] = []
        there: list[PartLabel] = []
        for number in self._blocks.keys() | other._blocks.keys():
            mine, theirs = self._blocks.get(number, {}), other._blocks.get(number, {})
            for frame in mine.keys() | theirs.keys() if mine is not theirs else ():
                if mine.get(frame) is not theirs.get(frame):
                    here += mine.get(frame, {}).values()
                    there += theirs.get(frame, {}).values()
        return here, there

    def changed(self, out: Iterable[PartKey], labels: Iterable[PartLabel]) -> PartLabels:
        """These labels without some, and then with others."""
        changes: dict[int, dict[PartKey, PartLabel | None]] = {}
        for key in out:
            changes.setdefault(key[0], {})[key] = None
        for label in labels:
            changes.setdefault(label.frame, {})[label.key] = label
        blocks: dict[int, dict[int, _Frame]] = {}
        count = self._count
        for frame, new in changes.items():
            number = frame // _BLOCK_FRAMES
            block = blocks.setdefault(number, dict(self._blocks.get(number, {})))
            old = block.pop(frame, {})
            said = {(track, part): label for (_, track, part), label in new.items()}
            merged = {**old, **said}
            kept = {key: label for key, label in merged.items() if label is not None}
            count += len(kept) - len(old)
            if kept:
                block[frame] = kept
        return self._made({**self._blocks, **blocks}, count)

    @classmethod
    def _made(cls, blocks: _Blocks, count: int) -> PartLabels:
        made = cls()
        made._blocks = {number: block for number, block in blocks.items() if block}
        made._count = count
        return made

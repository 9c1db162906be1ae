"""What a disk holds after a power cut, from the writes that were recorded before it.

Of each file the bytes of its last sync are there. What was written since is kept, lost or torn at
blocks, each block by chance and in any order. Of names (made, replaced, removed, linked) those are
there that a sync of their folder followed; of later ones some are, either the first few in order,
as a disk with a journal keeps them, or any.
"""

from __future__ import annotations

import random
from collections.abc import Iterator
from dataclasses import dataclass, field
from pathlib import Path


@dataclass(slots=True)
class File:
    """A file: its bytes now, those a power cut leaves for sure, and what was done since.

    Attributes:
        pending: since the last sync; (offset, bytes) of a write, or (size, None) of a new size.
    """

    now: bytearray = field(default_factory=bytearray)
    durable: bytes = b""
    pending: list[tuple[int, bytes | None]] = field(default_factory=list)

    def write(self, offset: int, data: bytes) -> None:
        """Write bytes; a hole before them is zeros."""
        _apply(self.now, offset, data)
        self.pending.append((offset, data))

    def resize(self, size: int) -> None:
        """Cut the file or let it grow."""
        _apply(self.now, size, None)
        self.pending.append((size, None))

    def sync(self) -> None:
        """All that was done is on the disk for good."""
        self.durable, self.pending = bytes(self.now), []

    def after_cut(self, chance: random.Random, block: int, kept: float) -> bytes:
        """The bytes after a power cut, with that share of what was pending."""
        found = bytearray(self.durable)
        for offset, data in self.pending:
            if data is None:
                if chance.random() < kept:
                    _apply(found, offset, None)
                continue
            for start, piece in _blocks(offset, data, block):
                if chance.random() < kept:
                    _apply(found, start, piece)
        return bytes(found)


@dataclass(eq=False, slots=True)
class Folder:
    """A folder: its names, those a power cut leaves for sure, and whose they are."""

    now: dict[str, File | Folder] = field(default_factory=dict)
    durable: dict[str, File | Folder] = field(default_factory=dict)


Naming = tuple[Folder, str, "File | Folder | None"]
"""A name in a folder becomes this file's, or nobody's."""


class Disk:
    """A tree of files under one folder, changed call by call."""

    def __init__(self, top: Path) -> None:
        """As it stands at the path now, all of it on the disk for good."""
        self._path = top
        self.top = _read(top)
        self._pending: list[tuple[Naming, ...]] = []

    def find(self, path: str) -> File | Folder | None:
        """What stands at a path now; None where nothing does, or outside of the tree."""
        try:
            parts = Path(path).relative_to(self._path).parts
        except ValueError:
            return None
        node: File | Folder | None = self.top
        for part in parts:
            node = node.now.get(part) if isinstance(node, Folder) else None
        return node

    def name(self, *changes: tuple[str, File | Folder | None]) -> None:
        """Give names to files, or take them away, all at once."""
        namings: list[Naming] = []
        for path, node in changes:
            parent = self.find(str(Path(path).parent))
            if not isinstance(parent, Folder):
                return
            namings.append((parent, Path(path).name, node))
        for naming in namings:
            _give(naming[0].now, naming)
        self._pending.append(tuple(namings))

    def sync_folder(self, folder: Folder, *, in_order: bool) -> None:
        """Its names are on the disk for good; in order: and all that was named before them."""
        touching = [any(each[0] is folder for each in one) for one in self._pending]
        if not any(touching):
            return
        last = max(at for at, touches in enumerate(touching) if touches)
        for at, one in enumerate(self._pending):
            if touching[at] or (in_order and at < last):
                for naming in one:
                    _give(naming[0].durable, naming)
        self._pending = [
            one
            for at, one in enumerate(self._pending)
            if not (touching[at] or (in_order and at < last))
        ]

    def cut(self, target: Path, chance: random.Random, block: int, *, in_order: bool) -> None:
        """Write what a power cut leaves to a folder of the real disk, which does not exist yet."""
        kept = chance.choice((0.0, 0.5, 0.9, 1.0))
        named = _survivors(self._pending, chance, kept, in_order=in_order)
        folders = _all_folders(self.top) | {each[0] for one in named for each in one}
        names = {folder: dict(folder.durable) for folder in folders}
        for one in named:
            for naming in one:
                _give(names.setdefault(naming[0], dict(naming[0].durable)), naming)

        def put(folder: Folder, place: Path) -> None:
            place.mkdir()
            for name, node in names.get(folder, folder.durable).items():
                if isinstance(node, Folder):
                    put(node, place / name)
                else:
                    (place / name).write_bytes(node.after_cut(chance, block, kept))

        put(self.top, target)


def _survivors(
    pending: list[tuple[Naming, ...]], chance: random.Random, kept: float, *, in_order: bool
) -> list[tuple[Naming, ...]]:
    if in_order:
        return pending[: round(kept * len(pending)) if kept in (0, 1) else _some(pending, chance)]
    return [one for one in pending if chance.random() < kept]


def _some(pending: list[tuple[Naming, ...]], chance: random.Random) -> int:
    return chance.randint(0, len(pending))


def _give(names: dict[str, File | Folder], naming: Naming) -> None:
    _, name, node = naming
    if node is None:
        names.pop(name, None)
    else:
        names[name] = node


def _all_folders(top: Folder) -> set[Folder]:
    found = {top}
    for node in (*top.now.values(), *top.durable.values()):
        if isinstance(node, Folder) and node not in found:
            found |= _all_folders(node)
    return found


def _read(path: Path) -> Folder:
    names: dict[str, File | Folder] = {}
    for child in path.iterdir():
        if child.is_dir():
            names[child.name] = _read(child)
        else:
            data = child.read_bytes()
            names[child.name] = File(bytearray(data), data)
    return Folder(names, dict(names))


def _apply(data: bytearray, offset: int, piece: bytes | None) -> None:
    stop = offset + len(piece or b"")
    if len(data) < stop:
        data.extend(bytes(stop - len(data)))
    if piece is None:
        del data[offset:]
    else:
        data[offset:stop] = piece


def _blocks(offset: int, data: bytes, block: int) -> Iterator[tuple[int, bytes]]:
    """The pieces of a write that lie in blocks of the disk of their own."""
    at = 0
    while at < len(data):
        stop = min(len(data), at + block - (offset + at) % block)
        yield offset + at, data[at:stop]
        at = stop

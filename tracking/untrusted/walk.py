"""HDF5 files from elsewhere, looked over before any of their data is touched.

A file can be made to crash the HDF5 library, to name other files, or to fill the memory. What is
walked here is structure alone: links, types, sizes, filters and attributes.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator
from contextlib import contextmanager
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import h5py
import numpy as np

from tracking.translation import msg
from tracking.untrusted.patience import go_on

_DEEPEST = 8
_MOST_OBJECTS = 20_000
_LARGEST_CHUNK = 64 << 20
_LARGEST_ATTRIBUTE = 16 << 20
_MOST_ATTRIBUTES = 64
_MOST_TEXTS, _LONGEST_TEXT = 10_000, 1 << 20
"""Of an attribute that is text: how many it has, and their letters together."""
_LONGEST_WHY, _TOLD = 400, 40
"""Letters of a message, which may hold names of a file's parts, and of a text in one."""
_BEST_RATIO = 1100
"""DEFLATE packs at most 1032 bytes into one."""
_FILTERS = frozenset({h5py.h5z.FILTER_DEFLATE, h5py.h5z.FILTER_SHUFFLE})
_OURS = {
    "trackwright-session": ("session", "train a detector from it or open it"),
    "trackwright-samples": ("samples export", "train a detector from it"),
    "trackwright-detector": ("detector", "track with it (--detector)"),
}
"""What other files of this program are, and what to do with them."""
SIGNATURE = b"\x89HDF\r\n\x1a\n"
"""How an HDF5 file begins."""
FAILURES = (
    *(OSError, KeyError, ValueError, TypeError),
    *(RuntimeError, AttributeError, OverflowError, MemoryError),
)
"""What the HDF5 library and conversions raise on a file that is not as it should be."""


class Refused(Exception):  # noqa: N818 - a verdict, told to whoever asked
    """The file is not taken; the message says why, in words that follow the file's name.

    Attributes:
        held: what the file says it is, as `Kind.format`; "" where that is not known.
    """

    def __init__(self, why: str, held: str = "", /, **values: object) -> None:
        """Why is a template with {named} places for the values."""
        message = msg(why, **values)
        super().__init__(message.cut_by(_cut) if len(message) > _LONGEST_WHY else message)
        self.held = held[:_TOLD]


def _cut(why: str) -> str:
    return why if len(why) <= _LONGEST_WHY else f"{why[: _LONGEST_WHY - 1]}…"


@dataclass(frozen=True, slots=True)
class Kind:
    """Which files are expected.

    Attributes:
        name: what people call one. format, version: as its root attributes say.
        most_bytes: of all its data together, unpacked.
        dimensions: of its arrays, at most. compound: the only type of rows it may have.
        free: whether what stands at a path does not count as data that is read whole.
    """

    name: str
    format: str
    version: tuple[int, int]
    most_bytes: int
    dimensions: int = 1
    compound: np.dtype[np.void] | None = None
    free: Callable[[str], object] = lambda _: False

    @property
    def choose(self) -> str:
        """What to do instead."""
        return msg("choose a {name} that trackwright saved", name=self.name)


def check_signature(path: Path, kind: Kind) -> None:
    """Refuse what is no HDF5 file. Raises Refused and OSError."""
    with path.open("rb") as raw:
        start = raw.read(len(SIGNATURE))
    if start != SIGNATURE:
        raise Refused(
            "is not an HDF5 file; {choose}" if start else "is empty; {choose}", choose=kind.choose
        )


def version_of(file: h5py.File, kind: Kind) -> tuple[int, int]:
    """The file's format version; raises Refused for another format and for a newer one."""
    check_attributes(file, kind)
    held = str(file.attrs.get("format", ""))
    if held in _OURS and held != kind.format:
        what, instead = _OURS[held]
        raise Refused(
            "is a trackwright {what}, no {name}; {instead}, or {choose}",
            held,
            what=what,
            name=kind.name,
            instead=instead,
            choose=kind.choose,
        )
    if held != kind.format:
        raise Refused(
            "is HDF5, but of another program: it is no trackwright {name}; {choose}",
            name=kind.name,
            choose=kind.choose,
        )
    said = str(file.attrs.get("format_version"))
    try:
        major, minor = (int(part) for part in said.split("."))
    except ValueError:
        raise Refused(
            "names {said!r} as its format version, not like 1.0; {choose}",
            held,
            said=said[:_TOLD],
            choose=kind.choose,
        ) from None
    said = said[:_TOLD]
    if major > kind.version[0]:
        raise Refused(
            "has format {said}, made by a newer trackwright; update to open it", held, said=said
        )
    if major < 1:
        raise Refused("has format {said}, which never was", held, said=said)
    return major, minor


@contextmanager
def checked_file(
    path: Path, kind: Kind
) -> Iterator[tuple[h5py.File, tuple[int, int], dict[str, h5py.Dataset]]]:
    """A file of that kind, its format version, and all its arrays by path.

    Raises Refused where it is another file, or not safe to read.
    """
    check_signature(path, kind)
    with h5py.File(path, "r", locking=False) as file:
        version = version_of(file, kind)
        try:
            yield file, version, Walk(path.stat().st_size, kind).datasets_of(file)
        except Refused as why:
            why.held = kind.format
            raise


class Walk:
    """Goes through all objects of a file once, refusing what such a file never has."""

    def __init__(self, file_bytes: int, kind: Kind) -> None:
        self._file_bytes, self._kind = file_bytes, kind
        self._stored = self._unpacked = 0
        self._objects = 0
        self._datasets: dict[str, h5py.Dataset] = {}

    def datasets_of(self, file: h5py.File) -> dict[str, h5py.Dataset]:
        """All arrays by path. Raises Refused."""
        self._group(file, "", 0)
        return self._datasets

    def dataset_at(self, file: h5py.File, where: str) -> h5py.Dataset | None:
        """One array of a file of which nothing else is touched; None where there is none.

        Its type and its dimensions are whatever they are. Raises Refused.
        """
        go_on()
        node = file
        for name in where.split("/"):
            if not isinstance(node, h5py.Group) or name not in node:
                return None
            if not isinstance(node.get(name, getlink=True), h5py.HardLink):
                raise Refused("has a link to somewhere else at {where}", where=where)
            node = node[name]
        if not isinstance(node, h5py.Dataset):
            return None
        self._check_storage(node, where)
        return node

    def _group(self, group: h5py.Group, path: str, depth: int) -> None:
        if depth > _DEEPEST:
            raise Refused("has groups nested deeper than any {name}", name=self._kind.name)
        if len(group) > _MOST_OBJECTS:
            raise Refused("holds more objects than any {name}", name=self._kind.name)
        check_attributes(group, self._kind)
        for name in group:
            go_on()
            self._objects += 1
            if self._objects > _MOST_OBJECTS:
                raise Refused("holds more objects than any {name}", name=self._kind.name)
            where = f"{path}/{name}".lstrip("/")
            if not isinstance(group.get(name, getlink=True), h5py.HardLink):
                raise Refused("has a link to somewhere else at {where}", where=where)
            node = group[name]
            if isinstance(node, h5py.Group):
                self._group(node, where, depth + 1)
            elif isinstance(node, h5py.Dataset):
                self._dataset(node, where)
            else:
                raise Refused("has something at {where} that is no table", where=where)

    def _dataset(self, dataset: h5py.Dataset, where: str) -> None:
        check_attributes(dataset, self._kind)
        self._check_type(dataset, where)
        self._check_storage(dataset, where)
        self._datasets[where] = dataset

    def _check_storage(self, dataset: h5py.Dataset, where: str) -> None:
        """Refuse what lies elsewhere, is packed in unknown ways, or unpacks to more than it can."""
        layout = dataset.id.get_create_plist()
        if dataset.is_virtual or layout.get_external_count():
            raise Refused("keeps {where} in other files", where=where)
        for at in range(layout.get_nfilters()):
            if layout.get_filter(at)[0] not in _FILTERS:
                raise Refused("packs {where} with a filter of its own", where=where)
        if dataset.chunks and np.prod(dataset.chunks) * dataset.dtype.itemsize > _LARGEST_CHUNK:
            raise Refused(
                "packs {where} in pieces larger than any {name}'s",
                where=where,
                name=self._kind.name,
            )
        stored = dataset.id.get_storage_size()
        self._stored += stored
        if self._stored > self._file_bytes:
            raise Refused("says it stores more than the file holds")
        unpacked = dataset.size * dataset.dtype.itemsize
        if unpacked > stored * _BEST_RATIO:
            raise Refused(
                "says {where} has {count} rows, which {stored} bytes cannot hold",
                where=where,
                count=dataset.size,
                stored=stored,
            )
        self._unpacked += 0 if self._kind.free(where) else unpacked
        if self._unpacked > self._kind.most_bytes:
            raise Refused("holds more data than any {name}", name=self._kind.name)

    def _check_type(self, dataset: h5py.Dataset, where: str) -> None:
        dtype = dataset.dtype
        if dtype.kind == "O":
            if h5py.check_string_dtype(dtype) is None:
                raise Refused("keeps references or lists in {where}", where=where)
        elif dtype.kind not in "iufb" and (
            self._kind.compound is None or dtype != self._kind.compound
        ):
            raise Refused(
                "keeps {dtype} in {where}; numbers or text are expected", dtype=dtype, where=where
            )
        if dataset.ndim > self._kind.dimensions:
            raise Refused(
                "has a table of {ndim} dimensions at {where}", ndim=dataset.ndim, where=where
            )


def attribute_of(node: h5py.Group | h5py.Dataset, name: str) -> Any:
    """A number, a text or an array of them; None where there is none. Raises Refused."""
    if name not in node.attrs:
        return None
    attribute = node.attrs.get_id(name)
    text = h5py.check_string_dtype(attribute.dtype) is not None
    if not (text or attribute.dtype.kind in "iufb") or not _is_small(node, name):
        raise Refused(
            "has an attribute {name!r} that is neither numbers nor text, or too large",
            name=name[:_TOLD],
        )
    return node.attrs[name]


def check_attributes(node: h5py.Group | h5py.Dataset, kind: Kind) -> None:
    """Refuse attributes that are many, large, or neither numbers nor text."""
    if len(node.attrs) > _MOST_ATTRIBUTES:
        raise Refused("has more attributes than any {name}", name=kind.name)
    for name in node.attrs:
        attribute = node.attrs.get_id(name)
        held = attribute.dtype.kind
        text = held == "O" and h5py.check_string_dtype(attribute.dtype) is not None
        if not (text or held in "iufb") or not _is_small(node, name):
            raise Refused(
                "has an attribute {name!r} like no {kind_name}'s",
                name=name[:_TOLD],
                kind_name=kind.name,
            )


def _is_small(node: h5py.Group | h5py.Dataset, name: str) -> bool:
    """Whether an attribute, numbers or text, is no larger than any that is read.

    Of text of any length a file says only where it lies: it is read, which is why looking a file
    over has limits of its own.
    """
    attribute = node.attrs.get_id(name)
    if attribute.get_storage_size() > _LARGEST_ATTRIBUTE:
        return False
    if attribute.dtype.kind != "O":
        return True
    if np.prod(attribute.shape or (), dtype=float) > _MOST_TEXTS:
        return False
    texts = node.attrs[name]
    if isinstance(texts, np.ndarray):
        return sum(map(len, texts.ravel())) <= _LONGEST_TEXT
    return isinstance(texts, h5py.Empty) or len(texts) <= _LONGEST_TEXT

"""The formats tracks can be written to and read from, by the name a command gives."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass
from pathlib import Path
from types import MappingProxyType
from typing import Any

from numpy.typing import NDArray

from tracking.errors import FormatError
from tracking.formats.mot import read_mot, write_mot
from tracking.tracks.columns import Columns


@dataclass(frozen=True, slots=True)
class TrackFormat:
    """A format of another tool.

    Attributes:
        name: as `--format` takes it.
        title: what people call it.
        read: columns of a file. Raises FormatError.
        write: makes a file of columns. Raises OutputError.
    """

    name: str
    title: str
    read: Callable[[Path], dict[str, NDArray[Any]]]
    write: Callable[[Path, Columns], None]


FORMATS: Mapping[str, TrackFormat] = MappingProxyType(
    {"mot": TrackFormat("mot", "MOTChallenge text, ten columns", read_mot, write_mot)}
)


def format_named(name: str) -> TrackFormat:
    """The format of that name.

    Raises:
        FormatError: there is none; lists those there are.
    """
    if name not in FORMATS:
        known = ", ".join(FORMATS)
        raise FormatError(f"format {name!r} is not built yet or unknown; choose one of: {known}")
    return FORMATS[name]

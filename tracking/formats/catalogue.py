"""The formats tracks can be written to and read from, by the name a command gives."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from pathlib import Path
from types import MappingProxyType

from tracking.errors import FormatError, PluginError, explain_unreadable
from tracking.formats.hdf5_tracks import why_refused
from tracking.formats.mot import lacks_commas
from tracking.formats.plugin_guard import guard_format
from tracking.formats.samples_reader import begins_as_hdf5
from tracking.formats.track_format import HEAD_BYTES, TrackFormat
from tracking.plugins import Catalogue, PluginKind
from tracking.translation import joined

_HERE = "tracking.formats"
BUILT_IN: Mapping[str, str] = MappingProxyType(
    {
        "mot": f"{_HERE}.mot:MOT",
        "mot16": f"{_HERE}.mot:MOT16",
        "kitti": f"{_HERE}.kitti:KITTI",
        "csv": f"{_HERE}.csv_tracks:CSV",
        "cvat": f"{_HERE}.cvat:CVAT",
        "coco": f"{_HERE}.coco:COCO",
        "label-studio": f"{_HERE}.label_studio:LABEL_STUDIO",
        "x-anylabeling": f"{_HERE}.xanylabeling:X_ANYLABELING",
        "viame": f"{_HERE}.viame:VIAME",
        "pedpy-txt": f"{_HERE}.floor_text:PEDPY_TEXT",
        "petrack": f"{_HERE}.floor_text:PETRACK",
        "petrack-trc": f"{_HERE}.petrack_trc:PETRACK_TRC",
        "pedpy-h5": f"{_HERE}.floor_hdf5:PEDPY_HDF5",
        "jupedsim-h5": f"{_HERE}.floor_hdf5:JUPEDSIM_HDF5",
        "jupedsim-sqlite": f"{_HERE}.jupedsim:JUPEDSIM_SQLITE",
        "sleap": f"{_HERE}.sleap:SLEAP",
        "idtracker": f"{_HERE}.idtracker:IDTRACKER",
    }
)
"""Where our own formats stand, in the order in which they are listed; pyproject.toml has the same
as entry points."""

FORMATS: Catalogue[TrackFormat] = Catalogue(
    PluginKind.FORMAT, BUILT_IN, lambda: (TrackFormat,), guard_format
)
"""The formats, our own first, then those of plug-ins by name."""


def readable_formats() -> tuple[TrackFormat, ...]:
    """The formats that are read."""
    return tuple(each for each in FORMATS.values() if each.read is not None)


def track_endings() -> tuple[str, ...]:
    """Of files that tracks are read from, with the dot."""
    return tuple(dict.fromkeys(one for each in readable_formats() for one in each.extensions))


def format_named(name: str) -> TrackFormat:
    """The format of that name.

    Raises:
        FormatError: there is none; lists those there are.
        PluginError: it is a plug-in's, which does not work.
    """
    if name not in FORMATS.names:
        known = joined(", ", FORMATS.names)
        raise FormatError(
            "format {name!r} is unknown; choose one of: {known}", name=name, known=known
        )
    return FORMATS[name]


def format_of(path: Path) -> TrackFormat:
    """The format of a file, told by its content; plug-ins are asked where none of ours knows it.

    Raises:
        FormatError: it cannot be read, or is of none that is read here.
        PluginError: the same, and a plug-in failed as it was asked.
    """
    if path.is_dir():
        return _format_of_folder(path)
    if not path.is_file() and path.exists():
        raise FormatError("{path} is no file that can be read twice; save it first", path=path)
    with explain_unreadable(path), path.open("rb") as stream:
        head = stream.read(HEAD_BYTES)
    if not head.strip():
        raise FormatError("{path} is empty; name a file with tracks", path=path)
    found = _first(lambda each: each.recognises(path, head))
    if found is not None:
        return found
    if begins_as_hdf5(path):
        raise FormatError("{path}{why_refused}", path=path, why_refused=why_refused(path))
    if lacks_commas(head):
        raise FormatError(
            "{path} is of no format known here",
            "put commas between values if it is MOT text",
            path=path,
        )
    known = joined(", ", (each.name for each in readable_formats()))
    raise FormatError(
        "{path} is of no format known here",
        "choose one of: {known}",
        option="--format",
        path=path,
        known=known,
    )


def _format_of_folder(path: Path) -> TrackFormat:
    found = _first(lambda each: each.recognises_folder is not None and each.recognises_folder(path))
    if found is not None:
        return found
    raise FormatError("{path} is a folder; name the file with the tracks", path=path)


def _first(recognises: Callable[[TrackFormat], bool]) -> TrackFormat | None:
    """The first format that knows a file: of ours by content, then by numbers, then of plug-ins.

    Raises PluginError where none does and a plug-in failed.
    """
    own = [each for each in FORMATS.of_built_in() if each.read is not None]
    for each in sorted(own, key=lambda one: one.by_numbers):
        if recognises(each):
            return each
    failed: list[PluginError] = []
    for offer, each in FORMATS.of_plugins():
        try:
            if each.read is not None and recognises(each):
                return each
        except PluginError as error:
            FORMATS.note(offer, error)
            failed.append(error)
    failed += [fault.error for fault in FORMATS.faults if fault.error not in failed]
    if failed:
        raise failed[0]
    return None

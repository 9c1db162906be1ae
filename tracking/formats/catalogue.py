"""The formats tracks can be written to and read from, by the name a command gives."""

from __future__ import annotations

from collections.abc import Mapping
from pathlib import Path
from types import MappingProxyType

from tracking.errors import FormatError, explain_unreadable
from tracking.formats.coco import COCO
from tracking.formats.csv_tracks import CSV
from tracking.formats.cvat import CVAT
from tracking.formats.floor_hdf5 import JUPEDSIM_HDF5, PEDPY_HDF5
from tracking.formats.floor_text import PEDPY_TEXT, PETRACK
from tracking.formats.hdf5_tracks import why_refused
from tracking.formats.idtracker import IDTRACKER
from tracking.formats.jupedsim import JUPEDSIM_SQLITE
from tracking.formats.kitti import KITTI
from tracking.formats.label_studio import LABEL_STUDIO
from tracking.formats.mot import MOT, MOT16, lacks_commas
from tracking.formats.petrack_trc import PETRACK_TRC
from tracking.formats.samples_reader import begins_as_hdf5
from tracking.formats.sleap import SLEAP
from tracking.formats.track_format import HEAD_BYTES, TrackFormat
from tracking.formats.viame import VIAME
from tracking.formats.xanylabeling import X_ANYLABELING
from tracking.translation import joined

_ALL = (
    MOT,
    MOT16,
    KITTI,
    CSV,
    CVAT,
    COCO,
    LABEL_STUDIO,
    X_ANYLABELING,
    VIAME,
    PEDPY_TEXT,
    PETRACK,
    PETRACK_TRC,
    PEDPY_HDF5,
    JUPEDSIM_HDF5,
    JUPEDSIM_SQLITE,
    SLEAP,
    IDTRACKER,
)

FORMATS: Mapping[str, TrackFormat] = MappingProxyType({each.name: each for each in _ALL})
"""In the order in which they are listed."""

READABLE: tuple[TrackFormat, ...] = tuple(each for each in _ALL if each.read is not None)
"""The formats that are read."""

_AS_ASKED = sorted(READABLE, key=lambda each: each.by_numbers)
"""In the order in which a file's content is asked about."""

TRACK_ENDINGS: tuple[str, ...] = tuple(
    dict.fromkeys(ending for each in READABLE for ending in each.extensions)
)
"""Of files that tracks are read from, with the dot."""


def format_named(name: str) -> TrackFormat:
    """The format of that name.

    Raises:
        FormatError: there is none; lists those there are.
    """
    if name not in FORMATS:
        known = joined(", ", FORMATS)
        raise FormatError(
            "format {name!r} is unknown; choose one of: {known}", name=name, known=known
        )
    return FORMATS[name]


def format_of(path: Path) -> TrackFormat:
    """The format of a file, told by its content.

    Raises:
        FormatError: it cannot be read, or is of none that is read here.
    """
    if path.is_dir():
        return _format_of_folder(path)
    if not path.is_file() and path.exists():
        raise FormatError("{path} is no file that can be read twice; save it first", path=path)
    with explain_unreadable(path), path.open("rb") as stream:
        head = stream.read(HEAD_BYTES)
    if not head.strip():
        raise FormatError("{path} is empty; name a file with tracks", path=path)
    for each in _AS_ASKED:
        if each.recognises(path, head):
            return each
    if begins_as_hdf5(path):
        raise FormatError("{path}{why_refused}", path=path, why_refused=why_refused(path))
    if lacks_commas(head):
        raise FormatError(
            "{path} is of no format known here",
            "put commas between values if it is MOT text",
            path=path,
        )
    known = joined(", ", (each.name for each in READABLE))
    raise FormatError(
        "{path} is of no format known here",
        "choose one of: {known}",
        option="--format",
        path=path,
        known=known,
    )


def _format_of_folder(path: Path) -> TrackFormat:
    for each in READABLE:
        if each.recognises_folder is not None and each.recognises_folder(path):
            return each
    raise FormatError("{path} is a folder; name the file with the tracks", path=path)

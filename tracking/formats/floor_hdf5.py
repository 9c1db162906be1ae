"""Places on the floor as HDF5: the Pedestrian Dynamics Data Archive's layout and JuPedSim's.

Both keep a table `/trajectory` whose rows have `id, frame, x, y, z` in metres, with the attribute
`fps`; the root's attribute `wkt_geometry` is the walkable area, which is written as a rectangle
around all places. Frames count from 0. PeTrack writes the archive's layout, too; PedPy reads both.
z is 0, the floor, on writing, and not kept on reading: it may be a head's or a person's height.
Sources: ped.fz-juelich.de (da/doku.php?id=info); JuPedSim's Hdf5TrajectoryWriter, schema 2.
"""

from __future__ import annotations

import zlib
from collections.abc import Callable, Iterator, Mapping
from contextlib import closing
from pathlib import Path
from typing import Any

import h5py
import numpy as np
from numpy.typing import NDArray

import tracking
from tracking.atomic_output import part_of
from tracking.formats.floor_rows import Places, fps_of, on_floor, with_place
from tracking.formats.hdf5_tracks import has_layout, number_of, opened
from tracking.formats.read_result import Filmed, Imported, Reading
from tracking.formats.track_format import Content, TrackFormat
from tracking.formats.track_writer import Exported
from tracking.hdf5_image import Hdf5Image
from tracking.progress import Progress, no_progress
from tracking.tracks import Columns
from tracking.translation import msg

_ARCHIVE_ROW = np.dtype([("id", "<i4"), ("frame", "<i4"), ("x", "<f8"), ("y", "<f8"), ("z", "<f8")])
_JUPEDSIM_ROW = np.dtype(
    [("frame", "<u4"), ("id", "<u4"), ("x", "<f8"), ("y", "<f8"), ("z", "<f8")]
)
_ROWS = 1 << 16
_COMPRESSION = 1
_LAYOUTS = ("pedpy-h5", "jupedsim-h5")
_READ = ("frame", "id", "x", "y", "z")
_COLUMNS = {"id": "track", "frame": "frame", "x": "x", "y": "y"}


def import_trajectory(path: Path, _filmed: Filmed, report: Progress = no_progress) -> Imported:
    """The tracks of a `/trajectory` table. Raises FormatError where it is none or is not safe."""
    reading = Reading(path, report)
    with opened(path, *_LAYOUTS) as file:
        table = file["trajectory"]
        held = [name for name in _READ if name in table.dtype.names]
        columns = {name: np.empty(len(table), np.float64) for name in held}
        for start in range(0, len(table), _ROWS):
            piece = table[start : start + _ROWS]
            for name in held:
                columns[name][start : start + len(piece)] = piece[name]
        fps = number_of(table, "fps") or number_of(file, "fps")
    columns["track"] = reading.ids_from_zero(columns.pop("id"))
    return reading.imported(
        with_place(columns), lambda row: msg("row {row} of /trajectory", row=row), fps=fps
    )


def export_archive(path: Path, exported: Exported, report: Progress) -> tuple[Path, ...]:
    """Write the archive's layout. Raises FormatError without places or frames a second."""
    return _export(path, exported, report, _ARCHIVE_ROW, _archive_attributes)


def export_jupedsim(path: Path, exported: Exported, report: Progress) -> tuple[Path, ...]:
    """Write JuPedSim's layout. Raises FormatError without places or frames a second."""
    return _export(path, exported, report, _JUPEDSIM_ROW, _jupedsim_attributes)


_Attributes = Callable[[Exported, Places, float], Mapping[str, Any]]


def _export(
    path: Path, exported: Exported, report: Progress, row: np.dtype[Any], root: _Attributes
) -> tuple[Path, ...]:
    fps = fps_of(path, exported)
    places = Places(path, exported)
    with part_of(path) as part, closing(Hdf5Image(part)) as image:
        with h5py.File(image, "w") as file:
            for name, value in root(exported, places, fps).items():
                file.attrs[name] = value
            chunk = min(_ROWS, places.count)
            table = file.create_dataset(
                "trajectory",
                shape=(places.count,),
                dtype=row,
                chunks=(chunk,),
                compression="gzip",
                compression_opts=_COMPRESSION,
                shuffle=True,
            )
            table.attrs["fps"] = fps
            for number, rows in enumerate(_chunks(exported, report, row, chunk)):
                image.put(table, number * chunk, _packed(rows, chunk))
        image.finish()
        image.verify()
    return (path,)


def _chunks(
    exported: Exported, report: Progress, row: np.dtype[Any], chunk: int
) -> Iterator[NDArray[Any]]:
    """The rows that have a place, so many at once."""
    waiting = np.zeros(0, row)
    for piece in exported.pieces(report):
        waiting = np.concatenate([waiting, _rows(on_floor(piece), row)])
        while len(waiting) >= chunk:
            yield waiting[:chunk]
            waiting = waiting[chunk:]
    if len(waiting):
        yield waiting


def _rows(rows: Columns, row: np.dtype[Any]) -> NDArray[Any]:
    made = np.zeros(len(rows["frame"]), row)
    for name, column in _COLUMNS.items():
        made[name] = rows[column]
    return made


def _packed(rows: NDArray[Any], chunk: int) -> bytes:
    """What the library's shuffle and gzip filters make of a chunk; the last one is filled up."""
    whole = np.zeros(chunk, rows.dtype)
    whole[: len(rows)] = rows
    by_byte = whole.view(np.uint8).reshape(chunk, rows.dtype.itemsize)
    return zlib.compress(by_byte.T.tobytes(), _COMPRESSION)


def _archive_attributes(exported: Exported, places: Places, _fps: float) -> Mapping[str, Any]:
    return {
        "wkt_geometry": places.area,
        "source": f"{exported.name} (trackwright {tracking.__version__})".strip(),
    }


def _jupedsim_attributes(_exported: Exported, places: Places, fps: float) -> Mapping[str, Any]:
    bounds = dict(zip(("xmin", "ymin", "xmax", "ymax"), places.bounds, strict=True))
    return {
        "schema_version": 2,
        "producer": "trackwright",
        "producer_version": tracking.__version__,
        "dt": 1.0 / fps,
        "every_nth_frame": 1,
        "fps": fps,
        "wkt_geometry": places.area,
        **bounds,
    }


PEDPY_HDF5 = TrackFormat(
    "pedpy-h5",
    "Pedestrian Dynamics Data Archive (PedPy), HDF5",
    (".h5", ".hdf5"),
    has_layout("pedpy-h5"),
    import_trajectory,
    export_archive,
    holds=frozenset((Content.PLACES,)),
    needs=Content.PLACES,
    about="Positions on the floor in metres, for analysis of how people walk; no boxes.",
)
JUPEDSIM_HDF5 = TrackFormat(
    "jupedsim-h5",
    "JuPedSim, HDF5",
    (".h5", ".hdf5"),
    has_layout("jupedsim-h5"),
    import_trajectory,
    export_jupedsim,
    holds=frozenset((Content.PLACES,)),
    needs=Content.PLACES,
    about="Positions on the floor in metres, for analysis of how people walk; no boxes.",
)

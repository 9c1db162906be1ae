"""Look HDF5 files of tracks over before their data is touched: `python ... FILE...`.

See `tracking.untrusted.program` for why this is a program of its own. Here it prints
{"layout": name}: which of the layouts read here the file has. Only what is read is looked at: files
of other tools hold much else.
"""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path

import h5py
import numpy as np

from tracking.translation import joined, msg
from tracking.untrusted import Kind, Refused, Walk, attribute_of, check_signature, say_verdicts

_KIND = Kind("file of tracks", "", (1, 0), 4 << 30)
_NEEDED = ("id", "frame", "x", "y")
_PROJECT_FIELDS = {
    "frames": ("frame_id", "video", "frame_idx", "instance_id_start", "instance_id_end"),
    "instances": (
        *("instance_id", "instance_type", "track", "from_predicted", "score"),
        *("point_id_start", "point_id_end"),
    ),
    "points": ("x", "y", "visible"),
    "pred_points": ("x", "y", "visible"),
}
_NEWEST_PROJECT = 3.0
"""From this version on SLEAP keeps its tables as columns; sleap-io refuses them, too."""
_BEST_RATIO = 100
"""Rows of places pack to a hundredth only where they are no places of anybody."""
_USUAL_BYTES = 16 << 20
_MOST_POINT_BYTES = 1 << 30
_MOST_NAMES = 100_000
_LONGEST_NAME = 4096


def inspect(path: Path) -> str:
    """The file's layout. Raises Refused where it has none, or none that is safe to read."""
    check_signature(path, _KIND)
    with h5py.File(path, "r", locking=False) as file:
        held = str(attribute_of(file, "format"))
        if held.startswith("trackwright-"):
            raise Refused(
                "is a {held}; open it, or score it as it is", held, held=held.replace("-", " ", 1)
            )
        walk = Walk(path.stat().st_size, _KIND)
        for layout in (_trajectory, _analysis, _project, _individuals):
            if found := layout(file, walk):
                return found
    raise Refused(
        "is HDF5, but holds no /trajectory, no tracks of SLEAP and no idtracker.ai trajectories"
    )


def _trajectory(file: h5py.File, walk: Walk) -> str:
    """A row a person a frame."""
    rows = walk.dataset_at(file, "trajectory")
    if rows is None:
        return ""
    fields = rows.dtype.names or ()
    missing = [name for name in _NEEDED if name not in fields]
    if rows.ndim != 1 or missing:
        raise Refused(
            "has a /trajectory without {missing}", missing=joined(", ", missing) or msg("rows")
        )
    for name in (*_NEEDED, *({"z"} & set(fields))):
        if rows.dtype[name].kind not in "iuf" or rows.dtype[name].shape:
            raise Refused(
                "keeps {dtype} in {name} of /trajectory; numbers are needed",
                dtype=rows.dtype[name],
                name=name,
            )
    _check_packing(rows)
    for node in (rows, file):
        attribute_of(node, "fps")
    of_jupedsim = all(name in file.attrs for name in ("schema_version", "every_nth_frame"))
    return "jupedsim-h5" if of_jupedsim else "pedpy-h5"


def _analysis(file: h5py.File, walk: Walk) -> str:
    """SLEAP's: points of all nodes of all tracks in all frames."""
    points = walk.dataset_at(file, "tracks")
    if points is None or "node_names" not in file:
        return ""
    _check_numbers(points, "tracks", 4)
    _check_size(points, "tracks")
    names = walk.dataset_at(file, "track_names")
    if names is not None:
        _check_names(names, "track_names")
    for name, dimensions in (("track_occupancy", 2), ("instance_scores", 2)):
        table = walk.dataset_at(file, name)
        if table is not None:
            _check_numbers(table, name, dimensions)
    return "sleap"


def _project(file: h5py.File, walk: Walk) -> str:
    """SLEAP's own: frames, which have instances, which have points."""
    for name, needed in _PROJECT_FIELDS.items():
        table = walk.dataset_at(file, name)
        if table is None:
            return ""
        fields = table.dtype.names or ()
        missing = [each for each in needed if each not in fields]
        if table.ndim != 1 or missing:
            raise Refused(
                "has a table {name} without {missing}",
                name=name,
                missing=joined(", ", missing) or msg("rows"),
            )
        for each in needed:
            if table.dtype[each].kind not in "iufb" or table.dtype[each].shape:
                raise Refused(
                    "keeps {dtype} in {each} of {name}; numbers are needed",
                    dtype=table.dtype[each],
                    each=each,
                    name=name,
                )
        _check_size(table, name)
        _check_packing(table)
    names = walk.dataset_at(file, "tracks_json")
    if names is not None:
        _check_names(names, "tracks_json")
    _check_project_version(file)
    return "sleap-project"


def _check_project_version(file: h5py.File) -> None:
    """Refuse what is newer than any whose tables are known."""
    if "metadata" not in file:
        return
    if not isinstance(file.get("metadata", getlink=True), h5py.HardLink):
        raise Refused("has a link to somewhere else at metadata")
    version = attribute_of(file["metadata"], "format_id")
    if version is None or np.size(version) != 1 or np.asarray(version).dtype.kind not in "iuf":
        return
    if not float(np.asarray(version).item()) < _NEWEST_PROJECT:
        raise Refused(
            "is a SLEAP project of a version newer than is known here; export SLEAP's analysis"
        )


def _individuals(file: h5py.File, walk: Walk) -> str:
    """idtracker.ai's: a centre of each individual in each frame."""
    points = walk.dataset_at(file, "trajectories")
    if points is None:
        return ""
    _check_numbers(points, "trajectories", 3)
    _check_size(points, "trajectories")
    if points.shape[2] != 2:
        raise Refused(
            "has {count} numbers a place in trajectories; two are needed", count=points.shape[2]
        )
    probabilities = walk.dataset_at(file, "id_probabilities")
    if probabilities is not None and probabilities.dtype.kind not in "iuf":
        raise Refused("keeps {dtype} in id_probabilities", dtype=probabilities.dtype)
    for name in ("frames_per_second", "identities_labels", "width", "height"):
        attribute_of(file, name)
    return "idtracker"


def _check_numbers(dataset: h5py.Dataset, where: str, dimensions: int) -> None:
    if dataset.dtype.kind not in "iufb" or dataset.ndim != dimensions:
        raise Refused(
            "has {dtype} in {ndim} dimensions at {where}",
            dtype=dataset.dtype,
            ndim=dataset.ndim,
            where=where,
        )


def _check_size(dataset: h5py.Dataset, where: str) -> None:
    """It is read whole; nearly empty ones pack well, so how well says nothing."""
    if dataset.size * dataset.dtype.itemsize > _MOST_POINT_BYTES:
        raise Refused(
            "holds more than {size} MB of {where}; split it first",
            size=_MOST_POINT_BYTES >> 20,
            where=where,
        )


def _check_packing(rows: h5py.Dataset) -> None:
    unpacked, stored = rows.size * rows.dtype.itemsize, rows.id.get_storage_size()
    if unpacked > _USUAL_BYTES + _BEST_RATIO * stored:
        raise Refused(
            "packs {count} rows into {stored} bytes, as no places of people do",
            count=rows.size,
            stored=stored,
        )


def _check_names(names: h5py.Dataset, where: str) -> None:
    """Few and short: many of them can share one long text. An empty list has any type."""
    if names.size == 0 and names.ndim == 1:
        return
    text = h5py.check_string_dtype(names.dtype) is not None
    if names.ndim != 1 or not (text or names.dtype.kind == "S") or len(names) > _MOST_NAMES:
        raise Refused(
            "has {dtype} in {ndim} dimensions at {where}",
            dtype=names.dtype,
            ndim=names.ndim,
            where=where,
        )
    if _longest(names[()]) > _LONGEST_NAME:
        raise Refused("has names of tracks longer than any")


def _longest(names: Sequence[bytes]) -> int:
    return max(map(len, names), default=0)


if __name__ == "__main__":
    say_verdicts(inspect, "layout")

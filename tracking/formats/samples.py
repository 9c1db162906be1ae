"""Samples of the failure detector for other programs: CSV, HDF5 and LIBSVM text.

CSV holds a row a sample with every column and every digit, and can be read back. HDF5 holds the
same as arrays. LIBSVM text holds labels and features alone, for one machine a file.
"""

from __future__ import annotations

import csv
import io
from collections.abc import Callable, Iterator, Mapping
from pathlib import Path
from types import MappingProxyType
from typing import Any

import h5py
import numpy as np

import tracking
from tracking.errors import FormatError
from tracking.failure import FEATURE_NAMES, SAMPLE_COLUMNS, SAMPLE_SOURCES, Samples
from tracking.failure.samples import TEXT, samples_from_rows
from tracking.formats.lines import numbered_rows, place_of
from tracking.replacing import replace_with, replacing
from tracking.tracks import PART_NAMES

HDF5_FORMAT = "trackwright-samples"
_COLUMNS = (*SAMPLE_COLUMNS, *FEATURE_NAMES)


def write_samples(path: Path, samples: Samples) -> list[Path]:
    """Write samples in the form that the file's ending names.

    Returns:
        The files that were made: one, or for LIBSVM text one for each part that has samples.

    Raises:
        FormatError: the ending names no form. OutputError: a file cannot be written.
    """
    writer = _WRITERS.get(path.suffix.lower())
    if writer is None:
        endings = ", ".join(_WRITERS)
        raise FormatError(f"{path}: samples are written to files that end in {endings}; rename it")
    return writer(path, samples)


def _write_csv(path: Path, samples: Samples) -> list[Path]:
    with replacing(path) as stream:
        rows = csv.writer(stream, lineterminator="\n")
        rows.writerow(_COLUMNS)
        columns = [samples.columns[name].tolist() for name in SAMPLE_COLUMNS]
        for named, features in zip(
            zip(*columns, strict=True), samples.features.tolist(), strict=True
        ):
            rows.writerow((*named, *map(repr, features)))
    return [path]


def _write_hdf5(path: Path, samples: Samples) -> list[Path]:
    image = io.BytesIO()
    with h5py.File(image, "w") as file:
        file.attrs["format"], file.attrs["format_version"] = HDF5_FORMAT, "1.0"
        file.attrs["software"] = f"trackwright {tracking.__version__}"
        features = file.create_dataset("features", data=samples.features)
        features.attrs["names"] = FEATURE_NAMES
        file["group"] = samples.people()
        file["group"].attrs["help"] = "a number for each recording and person: split folds by it"
        for name, dtype in SAMPLE_COLUMNS.items():
            column = samples.columns[name]
            kept = h5py.string_dtype() if dtype == TEXT else dtype
            file.create_dataset(name, data=column, dtype=kept, shape=(len(samples),))
    replace_with(path, image.getvalue())
    return [path]


def _write_libsvm(path: Path, samples: Samples) -> list[Path]:
    """+1 on its part, -1 off it, as in [ZhaoLee2009]: 150 samples for each machine, by hand."""
    part = samples.columns["part"]
    made = []
    for number, name in enumerate(PART_NAMES):
        of_part = samples[part == number]
        if len(of_part):
            target = path.with_name(f"{path.stem}-{name}{path.suffix}")
            with replacing(target) as stream:
                stream.writelines(_libsvm_lines(of_part))
            made.append(target)
    return made


def _libsvm_lines(samples: Samples) -> Iterator[str]:
    signs = np.where(samples.columns["label"] == 1, "+1", "-1").tolist()
    for sign, features in zip(signs, samples.features.tolist(), strict=True):
        numbers = (f"{at}:{value!r}" for at, value in enumerate(features, start=1) if value)
        yield " ".join((sign, *numbers)) + "\n"


_WRITERS: Mapping[str, Callable[[Path, Samples], list[Path]]] = MappingProxyType(
    {
        ".csv": _write_csv,
        ".h5": _write_hdf5,
        ".hdf5": _write_hdf5,
        ".libsvm": _write_libsvm,
        ".svm": _write_libsvm,
        ".txt": _write_libsvm,
    }
)


def read_samples(path: Path) -> Samples:
    """Samples of a CSV file as `write_samples` makes it.

    Raises FormatError where it is missing, no such table, or a row cannot be meant; names the line.
    """
    rows = list(numbered_rows(path, _COLUMNS))
    read = [_row(path, line, values) for line, values in rows]
    features = np.array([numbers for _, numbers in read], float).reshape(-1, len(FEATURE_NAMES))
    bad = np.flatnonzero(~np.isfinite(features).all(axis=1))
    if len(bad):
        where = place_of(path, rows[int(bad[0])][0])
        raise FormatError(f"{where}: a feature is not a finite number; correct or remove the row")
    return samples_from_rows([named for named, _ in read], features)


def _row(path: Path, line: int, values: Mapping[str, str]) -> tuple[tuple[Any, ...], list[float]]:
    named: list[Any] = []
    try:
        for name, dtype in SAMPLE_COLUMNS.items():
            named.append(values[name] if dtype == TEXT else int(values[name]))
        features = [float(values[name]) for name in FEATURE_NAMES]
    except ValueError as error:
        raise FormatError(f"{place_of(path, line)}: {error}; correct or remove the row") from error
    _, track, frame, part, label, _, _, source = named
    for wrong, reason in (
        (not 0 < track < 2**31, "the track is not a positive number"),
        (not 0 <= frame < 2**31, "the frame is not a number from 0 on"),
        (not 0 <= part < len(PART_NAMES), "the part is not 0 (head), 1 (torso) or 2 (hip-leg)"),
        (label not in (0, 1), "the label is not 1 (on its part) or 0 (off it)"),
        (source not in SAMPLE_SOURCES, f"the source is not one of {', '.join(SAMPLE_SOURCES)}"),
    ):
        if wrong:
            raise FormatError(f"{place_of(path, line)}: {reason}; correct or remove the row")
    return tuple(named), features

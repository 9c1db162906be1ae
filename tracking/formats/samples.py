"""Samples of the failure detector for other programs: CSV, HDF5 and LIBSVM text.

CSV holds a row a sample with every column and every digit; HDF5 holds the same as arrays. Both can
be read back (`samples_reader`). LIBSVM text holds labels and features alone, for one machine a
file, and cannot: it does not say whose samples they are.
"""

from __future__ import annotations

import io
from collections.abc import Callable, Iterator, Mapping
from pathlib import Path
from types import MappingProxyType

import h5py
import numpy as np

import tracking
from tracking.atomic_output import replace_with, replacing
from tracking.cells import CsvWriter, cell_of
from tracking.errors import FormatError
from tracking.failure import BESIDES, FEATURE_NAMES, SAMPLE_COLUMNS, Samples
from tracking.failure.core.samples import TEXT
from tracking.formats.samples_layout import HDF5_FORMAT, SHARED, VERSION
from tracking.tracks import PART_NAMES
from tracking.translation import joined

_COLUMNS = (*SAMPLE_COLUMNS, *SHARED, *FEATURE_NAMES)


def write_samples(path: Path, samples: Samples) -> list[Path]:
    """Write samples in the form that the file's ending names.

    Returns:
        The files that were made: one, or for LIBSVM text one for each part that has samples.

    Raises:
        FormatError: the ending names no form. OutputError: a file cannot be written.
    """
    return _writer_of(path)(path, samples)


def sample_files(path: Path) -> list[Path]:
    """The files that `write_samples` may make; raises FormatError for an ending of no form."""
    if _writer_of(path) is not _write_libsvm:
        return [path]
    return [_libsvm_file(path, name) for name in PART_NAMES]


def _writer_of(path: Path) -> Callable[[Path, Samples], list[Path]]:
    writer = _WRITERS.get(path.suffix.lower())
    if writer is None:
        endings = joined(", ", _WRITERS)
        raise FormatError(
            "{path}: samples are written to files that end in {endings}; rename it",
            path=path,
            endings=endings,
        )
    return writer


def _write_csv(path: Path, samples: Samples) -> list[Path]:
    with replacing(path) as stream:
        rows = CsvWriter(stream)
        rows.writerow(_COLUMNS)
        columns = [samples.columns[name].tolist() for name in (*SAMPLE_COLUMNS, *SHARED)]
        for named, features in zip(
            zip(*columns, strict=True), samples.features.tolist(), strict=True
        ):
            known = ("" if value != value else value for value in named)  # NaN is not itself
            rows.writerow((*map(cell_of, known), *map(_digits, features)))
    return [path]


def _digits(value: float) -> str:
    """Every digit of a feature; "" of one that is not known."""
    return "" if value != value else repr(value)


def _write_hdf5(path: Path, samples: Samples) -> list[Path]:
    image = io.BytesIO()
    with h5py.File(image, "w") as file:
        file.attrs["format"], file.attrs["format_version"] = (
            HDF5_FORMAT,
            ".".join(map(str, VERSION)),
        )
        file.attrs["software"] = f"trackwright {tracking.__version__}"
        features = file.create_dataset("features", data=samples.features)
        features.attrs["names"] = FEATURE_NAMES
        file["group"] = samples.people()
        file["group"].attrs["help"] = "a number for each recording and person: split folds by it"
        for name, dtype in SAMPLE_COLUMNS.items():
            column = samples.columns[name]
            kept = h5py.string_dtype() if dtype == TEXT else dtype
            file.create_dataset(name, data=column, dtype=kept, shape=(len(samples),))
        for name in SHARED:
            file.create_dataset(name, data=samples.columns[name], dtype=BESIDES[name].dtype)
    replace_with(path, image.getvalue())
    return [path]


def _write_libsvm(path: Path, samples: Samples) -> list[Path]:
    """+1 on its part, -1 off it, as in [ZhaoLee2009]: 150 samples for each machine, by hand."""
    part = samples.columns["part"]
    made = []
    for number, name in enumerate(PART_NAMES):
        of_part = samples[part == number]
        if len(of_part):
            target = _libsvm_file(path, name)
            with replacing(target) as stream:
                stream.writelines(_libsvm_lines(of_part))
            made.append(target)
    return made


def _libsvm_file(path: Path, part: str) -> Path:
    return path.with_name(f"{path.stem}-{part}{path.suffix}")


def _libsvm_lines(samples: Samples) -> Iterator[str]:
    signs = np.where(samples.columns["label"] == 1, "+1", "-1").tolist()
    for sign, features in zip(signs, samples.features.tolist(), strict=True):
        numbers = (
            f"{at}:{value!r}" for at, value in enumerate(features, start=1) if value == value != 0.0
        )
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

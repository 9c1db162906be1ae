"""Samples of the failure detector from files: CSV and HDF5, as this program writes them."""

from __future__ import annotations

import math
from array import array
from collections.abc import Iterator, Mapping
from pathlib import Path
from typing import Any

import h5py
import numpy as np
from numpy.typing import NDArray

from tracking.errors import FormatError, explain_unreadable
from tracking.failure import BESIDES, FEATURE_NAMES, SAMPLE_COLUMNS, SAMPLE_SOURCES, Samples
from tracking.failure.core.features import EVIDENCE_NAMES, PAPER_NAMES
from tracking.failure.core.samples import NOT_TOLD_APART
from tracking.formats import samples_inspection
from tracking.formats.lines import header_of, numbered_rows, place_of
from tracking.formats.samples_layout import HDF5_FORMAT, NUMBERS, SHARED, TEXTS
from tracking.tracks import LARGEST_NUMBER, PART_NAMES
from tracking.translation import joined, msg
from tracking.untrusted import SIGNATURE, verdicts_of

_REQUIRED = (*SAMPLE_COLUMNS, *PAPER_NAMES)
_ENDINGS = (".h5", ".hdf5")
_LIBSVM = (".libsvm", ".svm", ".txt")
_LABELS = {"frame", "track", "part", "on"}
_MOST_BYTES = 512 << 20
"""Of text: half a million samples."""


def read_samples(path: Path) -> Samples:
    """Samples of a CSV or HDF5 file as `write_samples` makes it; it may come from anywhere.

    Raises FormatError where it is missing, far too large, damaged, hostile or none of these, or a
    row is invalid; names the line.
    """
    if path.suffix.lower() in _LIBSVM:
        raise FormatError(
            "{path}: LIBSVM text does not say whose samples they are, so nobody could be held "
            "out; export them as .csv or .h5",
            path=path,
        )
    samples = samples_in_hdf5(path) if is_hdf5(path) else _read_csv(path)
    if samples is None:
        raise FormatError(
            "{path} holds no samples", "export some", option="--format samples", path=path
        )
    return samples


def samples_at(path: Path) -> Samples | None:
    """The samples of a file; None where it is HDF5 of another kind, as a session is.

    Raises as `read_samples`.
    """
    return samples_in_hdf5(path) if is_hdf5(path) else read_samples(path)


def samples_in_hdf5(path: Path) -> Samples | None:
    """Samples of an HDF5 file, looked over by a program of its own first; None: it holds others.

    Raises FormatError where they are damaged or hostile.
    """
    if not path.is_file():
        return None
    verdict = verdicts_of(samples_inspection.__file__, "samples", [path])[0]
    if "refused" in verdict:
        if verdict.get("held") == HDF5_FORMAT:
            raise FormatError("{path}{why}", path=path, why=verdict["refused"])
        return None
    try:
        with h5py.File(path, "r", locking=False) as file:
            return _checked(path, _columns_of(file), np.asarray(file["features"][()], float))
    except (OSError, KeyError, ValueError, TypeError, RuntimeError, OverflowError) as why:
        raise FormatError("{path}: the samples are damaged; export them again", path=path) from why


def is_hdf5(path: Path) -> bool:
    """Whether a file is meant to be HDF5, by its ending or by how it begins.

    Raises FormatError where it cannot be read.
    """
    if path.suffix.lower() in _ENDINGS:
        return True
    with explain_unreadable(path):
        return begins_as_hdf5(path)


def begins_as_hdf5(path: Path) -> bool:
    """Whether a file begins as HDF5 does. Raises OSError where it cannot be read."""
    with path.open("rb") as stream:
        return stream.read(len(SIGNATURE)) == SIGNATURE


def _columns_of(file: h5py.File) -> dict[str, NDArray[Any]]:
    names = file["features"].attrs.get("names")
    if names is not None and tuple(map(str, names)) not in (PAPER_NAMES, FEATURE_NAMES):
        raise ValueError("its features are others")
    text = {name: np.array(file[name].asstr()[()], object) for name in TEXTS}
    numbers = {name: file[name][()] for name in (*NUMBERS, *SHARED) if name in file}
    return {**text, **numbers}


def _read_csv(path: Path) -> Samples:
    _check_is_no_other_table(path)
    rows = numbered_rows(path, _REQUIRED, (*SHARED, *EVIDENCE_NAMES), most_bytes=_MOST_BYTES)
    names = [*SAMPLE_COLUMNS, *SHARED]
    columns: dict[str, list[Any]] = {name: [] for name in names}
    lines, features = array("q"), array("d")
    for line, values in rows:
        try:
            features.extend(_number(name, values[name], float) for name in PAPER_NAMES)
            features.extend(_evidence(name, values) for name in EVIDENCE_NAMES)
            for name, value in zip(names, _named(values), strict=True):
                columns[name].append(value)
        except ValueError as error:
            raise FormatError(
                "{place}: {error}; correct or remove the row",
                place=place_of(path, line),
                error=error,
            ) from error
        lines.append(line)
    held = {name: np.array(columns[name], object) for name in names}
    table = np.array(features, float).reshape(-1, len(FEATURE_NAMES))
    return _checked(path, held, table, np.array(lines, np.int64))


def _named(values: Mapping[str, str]) -> Iterator[Any]:
    """A row's values by `SAMPLE_COLUMNS` and `SHARED`. Raises ValueError."""
    for name in SAMPLE_COLUMNS:
        yield values[name] if name in TEXTS else _number(name, values[name], int)
    for name in SHARED:
        text, besides = values.get(name, ""), BESIDES[name]
        number = float if besides.dtype.kind == "f" else int
        yield _number(name, text, number) if text else besides.unknown


def _evidence(name: str, values: Mapping[str, str]) -> float:
    """A cell's number, NaN where it is empty. Raises ValueError."""
    text = values.get(name, "")
    return float(_number(name, text, float)) if text else math.nan


def _number(column: str, text: str, kind: type[int] | type[float]) -> int | float:
    """A cell's number. Raises ValueError, which names the column."""
    try:
        return kind(text)
    except ValueError:
        what = msg("a whole number") if kind is int else "a number"
        raise ValueError(
            msg("{column} is {text!r}, not {what}", column=column, text=text, what=what)
        ) from None


def _check_is_no_other_table(path: Path) -> None:
    """Labels of parts are a table, too."""
    names = set(header_of(path))
    if names >= _LABELS and not names >= {"label", FEATURE_NAMES[0]}:
        raise FormatError(
            "{path} holds labels of parts, which say nothing of how the parts stood: take them "
            "into the session they belong to (trackwright import-labels), then train from that",
            path=path,
        )


def _checked(
    path: Path,
    columns: Mapping[str, NDArray[Any]],
    features: NDArray[np.float64],
    lines: NDArray[np.int64] | None = None,
) -> Samples:
    """The samples of columns as read; raises FormatError for the first that is invalid."""
    for wrong, reason in _broken_rules(columns, features):
        rows = np.flatnonzero(wrong)
        if len(rows):
            at = int(rows[0])
            place = (
                msg("{path}, row {at}", path=path, at=at)
                if lines is None
                else place_of(path, int(lines[at]))
            )
            raise FormatError(
                "{place}: {reason}; correct or remove the row", place=place, reason=reason
            )
    types = {**SAMPLE_COLUMNS, **{name: BESIDES[name].dtype for name in SHARED}}
    return Samples({name: column.astype(types[name]) for name, column in columns.items()}, features)


def _broken_rules(
    columns: Mapping[str, NDArray[Any]], features: NDArray[np.float64]
) -> Iterator[tuple[NDArray[np.bool_], str]]:
    """(n,) marks of the samples that break a rule, and the rule."""
    track, frame, part, label = (columns[name] for name in NUMBERS)
    person = columns.get("person", np.zeros(len(features), np.int64))
    time_s = columns.get("time_s", np.zeros(len(features))).astype(float)
    yield ~((track > 0) & (track <= LARGEST_NUMBER)), msg("the track is not a positive number")
    yield ~((frame >= 0) & (frame <= LARGEST_NUMBER)), msg("the frame is not a number from 0 on")
    yield (
        ~np.isin(part, range(len(PART_NAMES))),
        msg("the part is not 0 (head), 1 (torso) or 2 (hip-leg)"),
    )
    yield ~np.isin(label, (0, 1)), msg("the label is not 1 (on its part) or 0 (off it)")
    sources = joined(", ", SAMPLE_SOURCES)
    yield (
        ~np.isin(columns["source"].astype(str), SAMPLE_SOURCES),
        msg("the source is not one of {sample_sources}", sample_sources=sources),
    )
    yield (
        ~((person >= NOT_TOLD_APART) & (person <= LARGEST_NUMBER)),
        msg("the person is not a number from 1 on, 0 (not known) or -1 (not told apart)"),
    )
    yield np.isinf(time_s), msg("the time is not a number of seconds")
    paper, evidence = np.split(features, [len(PAPER_NAMES)], axis=1)
    endless = np.asarray(~np.isfinite(paper).all(axis=1) | np.isinf(evidence).any(axis=1))
    yield endless, msg("a feature is not a finite number")

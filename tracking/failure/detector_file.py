"""Detectors as files: arrays in HDF5, nothing that runs."""

from __future__ import annotations

import io
from functools import cache
from importlib.resources import as_file, files
from pathlib import Path

import h5py
import numpy as np

from tracking.arrays import Floats
from tracking.atomic_output import replace_with
from tracking.errors import FormatError
from tracking.failure import inspection
from tracking.failure.core.detector import Detector, Origin
from tracking.failure.core.machines import Machine, Machines
from tracking.failure.core.operating_points import Curve
from tracking.failure.core.preparation import Preparation, numbers_seen
from tracking.failure.detector_layout import FORMAT, MACHINES, PAPER_VERSION, VERSION
from tracking.tracks import PART_NAMES, PARTS
from tracking.translation import msg
from tracking.untrusted import FAILURES, verdicts_of

BUILT_IN = "part_failures.h5"
BUILT_IN_PAPER = "part_failures_paper.h5"
"""The names of the detectors among the resources: with evidence, and by the paper's features."""

_TEXTS = ("samples", "made", "software", "chosen")
_AGAIN = msg("train it again or choose another one")


def save_detector(path: Path, detector: Detector) -> None:
    """Write a detector. The same one gives the same file, byte for byte.

    Raises OutputError where it cannot be written; what stood at `path` is still there then.
    """
    # Made in memory: the HDF5 library does not survive a full disk.
    image = io.BytesIO()
    with h5py.File(image, "w") as file:
        _write(file, detector)
    replace_with(path, image.getvalue())


def load_detector(path: Path) -> Detector:
    """Read a detector that may come from anywhere: looked over by a program of its own first.

    Raises FormatError where it is missing, no detector, damaged, hostile or too new.
    """
    if path.is_dir():
        raise FormatError("{path}: this is a folder; name a detector file", path=path)
    if not path.is_file():
        raise FormatError("{path}: there is no such detector; check the path", path=path)
    verdict = verdicts_of(inspection.__file__, "detector", [path])[0]
    if "refused" in verdict:
        raise FormatError("{path}{why}", path=path, why=verdict["refused"])
    return _read(path)


@cache
def built_in_detector(*, paper: bool = False) -> Detector:
    """The detector that comes with the program, trained on its rendered scenes.

    Args:
        paper: the one that sees the features of [ZhaoLee2009] alone.

    Raises FormatError where the installation lacks it.
    """
    name = BUILT_IN_PAPER if paper else BUILT_IN
    with as_file(files("resources") / name) as path:
        if not path.is_file():
            raise FormatError("{path} is missing among the resources; install again", path=name)
        return _read(path)


def _write(file: h5py.File, detector: Detector) -> None:
    preparation, origin = detector.preparation, detector.origin
    file.attrs["format"] = FORMAT
    version = PAPER_VERSION if preparation.paper else VERSION
    file.attrs["format_version"] = ".".join(map(str, version))
    file.attrs["fingerprint"] = detector.fingerprint
    file.attrs["by_size"] = preparation.by_size
    file["preparation/centre"], file["preparation/scale"] = preparation.centre, preparation.scale
    thresholds = [*detector.thresholds.tolist(), detector.several_threshold]
    for name, machine, curve, threshold in zip(
        MACHINES, detector.machines.each, detector.curves, thresholds, strict=False
    ):
        kept = file.create_group(f"machines/{name}")
        kept.create_dataset("support", data=machine.support, compression="gzip", shuffle=True)
        kept["coefficient"] = machine.coefficient
        kept.attrs["intercept"], kept.attrs["gamma"] = machine.intercept, machine.gamma
        measured = file.create_group(f"operating/{name}")
        measured["on"], measured["off"] = curve.on, curve.off
        measured.attrs["threshold"] = threshold
        measured.attrs["false_alarms"] = curve.false_alarms(threshold)
        measured.attrs["found"] = curve.found(threshold)
    made_from = file.create_group("origin")
    made_from["counts"], made_from["instants"] = origin.counts, origin.instants
    made_from.create_dataset(
        "recordings",
        data=np.array(origin.recordings, object),
        shape=(len(origin.recordings),),
        dtype=h5py.string_dtype(),
    )
    made_from.attrs["people"] = origin.people
    for name in _TEXTS:
        made_from.attrs[name] = getattr(origin, name)


def _read(path: Path) -> Detector:
    try:
        with h5py.File(path, "r", locking=False) as file:
            return _detector(file)
    except FAILURES as why:
        reason = " ".join(str(why).split())
        raise FormatError(
            "{path}: the detector is damaged ({reason}); {to_do}",
            path=path,
            reason=reason,
            to_do=_AGAIN,
        ) from why


def _detector(file: h5py.File) -> Detector:
    names = [name for name in MACHINES if name in file["machines"]]
    if tuple(names[:PARTS]) != PART_NAMES:
        raise ValueError("it lacks a part")
    by_size = bool(file.attrs["by_size"])
    paper = len(file["preparation/centre"]) == numbers_seen(by_size=by_size, paper=True)
    numbers = numbers_seen(by_size=by_size, paper=paper)
    preparation = Preparation(
        by_size,
        _checked(file["preparation/centre"], (numbers,)),
        _checked(file["preparation/scale"], (numbers,)),
    )
    if not (preparation.scale > 0).all():
        raise ValueError("a scale is not positive")
    machines = tuple(_machine(file["machines"][name], numbers) for name in names)
    curves = tuple(_curve(file["operating"][name]) for name in names)
    thresholds = [_number(file["operating"][name], "threshold") for name in names]
    several = thresholds[PARTS] if len(names) > PARTS else 0.0
    return Detector(
        preparation,
        Machines(machines),
        np.array(thresholds[:PARTS]),
        several,
        curves,
        _origin(file["origin"]),
    )


def _machine(group: h5py.Group, numbers: int) -> Machine:
    rows = len(group["support"])
    gamma = _number(group, "gamma")
    if not rows or gamma < 0:
        raise ValueError(f"{group.name} is no machine")
    return Machine(
        _checked(group["support"], (rows, numbers)),
        _checked(group["coefficient"], (rows,)),
        _number(group, "intercept"),
        gamma,
    )


def _curve(group: h5py.Group) -> Curve:
    on, off = (_checked(group[side], (len(group[side]),)) for side in ("on", "off"))
    if (np.diff(on) < 0).any() or (np.diff(off) < 0).any():
        raise ValueError(f"{group.name} is not ascending")
    return Curve(on, off)


def _origin(group: h5py.Group) -> Origin:
    counts, instants = group["counts"][()], group["instants"][()]
    if counts.shape != (PARTS, 2) or instants.shape != (2,):
        raise ValueError("its counts have another shape")
    return Origin(
        counts.astype(np.int64),
        instants.astype(np.int64),
        tuple(str(text) for text in group["recordings"].asstr(errors="replace")[()]),
        int(group.attrs["people"]),
        **{name: str(group.attrs[name]) for name in _TEXTS},
    )


def _checked(dataset: h5py.Dataset, shape: tuple[int, ...]) -> Floats:
    if dataset.shape != shape:
        raise ValueError(f"{dataset.name} has the shape {dataset.shape}, not {shape}")
    values = np.asarray(dataset[()], float)
    if not np.isfinite(values).all():
        raise ValueError(f"{dataset.name} holds what is no number")
    return values


def _number(group: h5py.Group, name: str) -> float:
    value = float(group.attrs[name])
    if not np.isfinite(value):
        raise ValueError(f"{name} of {group.name} is no number")
    return value

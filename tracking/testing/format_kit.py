"""What every format of tracks must do."""

from __future__ import annotations

from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from tracking.errors import CancelledError, TrackwrightError
from tracking.formats import FORMATS, Exported, Filmed, Imported, TrackFormat
from tracking.formats.read_result import with_all_columns
from tracking.formats.track_format import HEAD_BYTES, Content
from tracking.geometry import Camera, Ground, View
from tracking.progress import no_progress
from tracking.testing.rules import (
    at_the_door,
    hostile_heads,
    leaving_nothing_open,
    never_raises,
    obeying,
    raises_ours_alone,
    require,
)
from tracking.tracks import TrackTable

_FRAMES, _TRACKS = 12, (1, 7, 300)
_SIZE = (640, 480)
_VIEW = View(
    Camera(np.array([[500.0, 0, 320], [0, 500.0, 240], [0, 0, 1]]), np.zeros(0), *_SIZE),
    Ground(2.4, 20.0),
)
"""For formats that tell places as the camera sees them."""
_NEAR = 0.01
"""Pixels and metres: texts round."""
_COLUMNS = {
    Content.BOXES: ("left", "top", "width", "height"),
    Content.PLACES: ("x", "y"),
    Content.VELOCITIES: ("vx", "vy"),
}


def check_format(kind: TrackFormat, folder: Path, sample: Path | None = None) -> None:
    """Check writing, reading, and that no file does harm.

    Args:
        kind: the format. folder: to write in, empty; pytest's `tmp_path`.
        sample: a file of it, for a format that is read and not written.

    Raises BrokenRule for the first rule that it breaks.
    """
    with at_the_door(FORMATS, kind), obeying():
        known = FORMATS[kind.name]
        require(known.read or known.write, "it neither reads nor writes")
        _check_recognition(known, folder)
        if known.write is not None:
            sample = folder / f"tracks{known.extensions[0]}"
            with leaving_nothing_open("write"):
                made = known.write(sample, exported(), no_progress)
            require(sample in made and sample.exists(), "write must make the file it is asked for")
            _check_failing(known, folder)
        if known.read is None:
            return
        require(sample is not None, "give a sample: the format is read and not written")
        assert sample is not None
        _check_reading(known, sample)
        _check_damage(known, sample, folder)


def exported() -> Exported:
    """Three people of whom everything is known."""
    frame = np.repeat(np.arange(_FRAMES), len(_TRACKS))
    track = np.tile(_TRACKS, _FRAMES)
    step = frame.astype(float)
    columns = {
        "frame": frame,
        "track": track,
        "left": 10 + 3 * step + track % 50,
        "top": 20 + step,
        "width": np.full(len(frame), 30.5),
        "height": np.full(len(frame), 81.25),
        "x": track % 5 + step / 8,
        "y": 4 + step / 4,
        "vx": np.full(len(frame), 1.0),
        "vy": np.full(len(frame), 2.0),
    }
    table = TrackTable(with_all_columns(columns))
    return Exported.of_table(table, frames=_FRAMES, fps=8.0, size_px=_SIZE, view=_VIEW)


def _check_recognition(kind: TrackFormat, folder: Path) -> None:
    for head in hostile_heads():
        file = folder / "hostile"
        file.write_bytes(head)
        never_raises(lambda: kind.recognises(file, head), "recognises")  # noqa: B023 - called here
        if kind.recognises_folder is not None:
            never_raises(lambda: kind.recognises_folder(folder), "recognises_folder")  # type: ignore[misc]
    require(not kind.recognises(folder / "hostile", b""), "it takes an empty file for its own")


def _check_failing(kind: TrackFormat, folder: Path) -> None:
    """A file appears whole or not at all."""
    write, ending = kind.write, kind.extensions[0]
    assert write is not None
    place = folder / f"cancelled{ending}"

    def cancel(_done: int, _total: int) -> None:
        raise CancelledError("stopped")

    try:
        write(place, exported(), cancel)
    except CancelledError:
        require(not place.exists(), "a write that was cancelled left a file: use replacing_bytes")
    if kind.is_folder:
        return
    nowhere = folder / "no" / "such" / f"folder{ending}"
    made = raises_ours_alone(lambda: write(nowhere, exported(), no_progress), "write")
    require(made is None, "write made a folder that nobody asked for")


def _check_reading(kind: TrackFormat, sample: Path) -> None:
    assert kind.read is not None
    if kind.is_folder:
        require(
            kind.recognises_folder is not None and kind.recognises_folder(sample),
            "it does not recognise what it wrote",
        )
    else:
        head = sample.read_bytes()[:HEAD_BYTES]
        require(kind.recognises(sample, head), "it does not recognise its own file")
    with leaving_nothing_open("read"):
        found = kind.read(sample, Filmed(frames=_FRAMES, fps=8.0, size_px=_SIZE, view=_VIEW))
    require(len(found.columns["frame"]) > 0, "no row of its own file was read")
    if kind.write is not None:
        _check_same(kind, found)


def _check_same(kind: TrackFormat, found: Imported) -> None:
    """What `holds` says comes back."""
    wanted = exported().rows
    names = ["frame", "track"]
    names += [name for one in kind.holds for name in _COLUMNS.get(one, ())]
    for name in names:
        one, other = found.columns[name], np.asarray(wanted[name][0 : len(_TRACKS) * _FRAMES])
        require(
            len(one) == len(other) and _near(one, other),
            "column {name} does not come back as it was written, though `holds` says so",
            name=name,
        )


def _near(one: NDArray[np.float64], other: NDArray[np.float64]) -> bool:
    return bool(np.allclose(one, other, rtol=0, atol=_NEAR))


def _check_damage(kind: TrackFormat, sample: Path, folder: Path) -> None:
    """Files that end too soon or hold noise are read in part, or refused in one line."""
    read = kind.read
    assert read is not None
    if sample.is_dir():
        return
    whole, noise = sample.read_bytes(), np.random.default_rng(7)
    damaged = [whole[: len(whole) * part // 8] for part in range(8)]
    for _ in range(24):
        bytes_ = bytearray(whole)
        for at in noise.integers(0, max(len(bytes_), 1), 6).tolist():
            bytes_[at] = int(noise.integers(256))
        damaged.append(bytes(bytes_))
    for each in (*damaged, *hostile_heads()):
        file = folder / f"damaged{kind.extensions[0]}"
        file.write_bytes(each)
        raises_ours_alone(lambda: read(file, Filmed()), "read")  # noqa: B023 - called here
    missing = folder / f"missing{kind.extensions[0]}"
    try:
        read(missing, Filmed())
    except TrackwrightError:
        return
    require(False, "read of a file that is not there must raise FormatError")

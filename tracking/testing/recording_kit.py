"""What every kind of recordings must do."""

from __future__ import annotations

from pathlib import Path

import numpy as np

from tracking.recording import open_recording
from tracking.recording.kinds.catalogue import KINDS
from tracking.recording.kinds.kind import RecordingKind
from tracking.testing.rules import (
    at_the_door,
    hostile_heads,
    leaving_nothing_open,
    never_raises,
    obeying,
    require,
)


def check_recording(kind: RecordingKind, folder: Path, sample: Path) -> None:
    """Check that it knows its own recordings, and lets all others be.

    Args:
        kind: of recordings. folder: to write in, empty; pytest's `tmp_path`.
        sample: a recording of the kind, with two frames at least.

    Raises BrokenRule for the first rule that it breaks.
    """
    with at_the_door(KINDS, kind), obeying():
        known = KINDS[kind.name]
        require(known.about[:1].isupper(), "its line `about` must begin with a capital")
        _check_others(known, folder)
        found = known.find(sample)
        require(found is not None, "it does not know its own sample {sample}", sample=sample)
        with leaving_nothing_open("the recording"), open_recording(sample) as recording:
            require(recording.frame_count >= 2, "the sample needs two frames at least")
            first = recording.read(0).left.copy()
            recording.read(recording.frame_count - 1)
            again = recording.read(0).left
            require(np.array_equal(first, again), "frame 0 read twice is not the same")
            require(recording.fps > 0, "it has no frames per second")


def _check_others(kind: RecordingKind, folder: Path) -> None:
    """Whatever else stands on a disk is none of it, and does no harm."""
    others = folder / "others"
    (others / "empty").mkdir(parents=True)
    (others / "deep" / "left").mkdir(parents=True)
    places = [others / "empty", others / "deep", others / "missing", others / "missing.mp4"]
    for number, head in enumerate(hostile_heads()):
        file = others / f"file{number}.bin"
        file.write_bytes(head)
        places.append(file)
    for place in places:
        found = never_raises(lambda: kind.find(place), f"find({place.name})")  # noqa: B023 - called here
        require(found is None, "it takes {place} for a recording of its kind", place=place.name)

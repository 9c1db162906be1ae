"""Writes what is exactly true of a rendered recording as tables beside it."""

from __future__ import annotations

from pathlib import Path

import numpy as np

from tracking.formats import write_mot
from tracking.synthesis.truth import CARED_FOR, SceneTruth
from tracking.tracks import PART_WORDS
from tracking.truth import TRUE_PART_COLUMNS, TRUE_PARTS, VISIBILITY, VISIBILITY_COLUMNS


def write_truth(folder: Path, truths: list[SceneTruth]) -> None:
    """Write the truth of all frames into a recording's folder: tracks, visibility, body parts."""
    counts = [len(truth) for truth in truths]
    frame = np.repeat(np.arange(len(truths), dtype=np.int32), counts)
    box = np.concatenate([truth.box for truth in truths])
    position = np.concatenate([truth.position for truth in truths])
    visibility = np.concatenate([truth.visibility for truth in truths])
    columns = {
        "frame": frame,
        "track": np.concatenate([truth.track for truth in truths]),
        "left": box[:, 0].round(2),
        "top": box[:, 1].round(2),
        "width": box[:, 2].round(2),
        "height": box[:, 3].round(2),
        "confidence": (visibility >= CARED_FOR).astype(np.float64),
        "x": position[:, 0].round(4),
        "y": position[:, 1].round(4),
        "z": np.zeros(len(frame)),
    }
    write_mot(folder / "truth.txt", columns)
    _write_visibility(folder / VISIBILITY, truths)
    _write_parts(folder / TRUE_PARTS, truths)


def _write_visibility(path: Path, truths: list[SceneTruth]) -> None:
    with path.open("w", encoding="utf-8", newline="\n") as stream:
        stream.write(",".join(VISIBILITY_COLUMNS) + "\n")
        for frame, truth in enumerate(truths):
            for track, share in zip(truth.track, truth.visibility, strict=True):
                stream.write(f"{frame},{track},{share:.4f}\n")


def _write_parts(path: Path, truths: list[SceneTruth]) -> None:
    with path.open("w", encoding="utf-8", newline="\n") as stream:
        stream.write(",".join(TRUE_PART_COLUMNS) + "\n")
        for frame, truth in enumerate(truths):
            for row, track in enumerate(truth.track):
                for part, name in enumerate(PART_WORDS):
                    box = ",".join(f"{value:.2f}" for value in truth.part_box[row, part])
                    pixels = truth.part_pixels[row, part]
                    stream.write(f"{frame},{track},{name},{box},{pixels}\n")

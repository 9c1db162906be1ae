"""What tests of several runs ask of the window."""

from dataclasses import replace

import numpy as np

from tracking.tracks import Columns, Run

AGAIN_AT = 50
SHIFTED = (58, 72)
"""Frames in which somebody of the run stands a metre beside where he is."""


def items(controller):
    return controller.document.comparison.scene().items


def place(controller, track, frame):
    return float(controller.document.session.tracks.of_track(track, frame, frame + 1)["x"][0])


def boxes(marks):
    return {mark.label: mark.box for mark in marks}


SWAPPED_AT = 66
"""From here on two people have each other's id in a swapped run."""


def swapped(run: Run) -> tuple[Run, set[int]]:
    """A run in which two people who both stand there have each other's id from a frame on."""
    here = run.tracks["frame"] == SWAPPED_AT
    one, other = run.tracks["track"][here][:2].tolist()
    tracks, signals = (_swap(columns, one, other) for columns in (run.tracks, run.signals))
    return replace(run, tracks=tracks, signals=signals), {one, other}


def _swap(columns: Columns, one: int, other: int) -> Columns:
    late, ids = columns["frame"] >= SWAPPED_AT, columns["track"].copy()
    ids[late & (columns["track"] == one)] = other
    ids[late & (columns["track"] == other)] = one
    order = np.lexsort((ids, columns["frame"]))
    return {name: column[order] for name, column in {**columns, "track": ids}.items()}

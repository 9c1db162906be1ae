"""Swaps in tracked footage and whether their frame is found.

`python -m tests.benchmarks.swap_frame_tracked` renders scenes, tracks them, and looks for swaps
that are injected where two tracks come within 1.2 m, and for those the trackers made themselves,
told by the truth. Trackers glide from one person to the other: a proposal counts as found within
two frames of the swap, or of the frames in which one of the tracks was clearly at neither person;
swaps that took longer than a second are left out. Rendered scenes stay in the temporary folder.
"""

from __future__ import annotations

import argparse
import tempfile
from collections.abc import Iterator
from pathlib import Path

import cv2
import numpy as np
from numpy.typing import NDArray

from tests.benchmarks.rendered_clips import Clip, folder_of
from tracking.editing import apply_change, plan_swap, propose_swap_frames, signals_of
from tracking.formats import read_mot
from tracking.pipeline import track
from tracking.recording import open_recording
from tracking.tracks import Columns, Labels, Run, TrackTable

REPORTED_SEED = 3201
_KEPT = Path(tempfile.gettempdir()) / "trackwright-accuracy"
WITHIN = 2
_SCENES = ("lobby", "uniforms", "plaza")
_TRACKERS = ("stereo-direction", "stereo-colour")
_MEETING_M, _MARGIN, _EACH = 1.2, 20, 3
_SAME_M, _CLEARLY_M = 0.5, 0.25
_LONGEST = 20
_LATER = 60
"""Frames after a swap at which the user notices it."""

Frames = NDArray[np.int64]


def main() -> None:
    """Print a row for each scene and tracker."""
    parser = argparse.ArgumentParser(prog="python -m tests.benchmarks.swap_frame_tracked")
    parser.add_argument("--seed", type=int, default=REPORTED_SEED)
    parser.add_argument("--scenes", nargs="+", default=list(_SCENES))
    asked = parser.parse_args()
    cv2.setNumThreads(1)
    print("| scene | tracker | injected | found | natural | found |")
    print("| --- | --- | --- | --- | --- | --- |")
    for scene in asked.scenes:
        folder = folder_of(Clip(scene, asked.seed), _KEPT)
        truth = read_mot(folder / "truth.txt")
        for tracker in _TRACKERS:
            with open_recording(folder) as recording, track(recording, tracker) as tracking:
                for _ in tracking:
                    pass
                run = tracking.run()
            injected = list(injected_found(run, asked.seed))
            natural = list(natural_found(run, truth))
            figures = [
                f"{len(part)} | {sum(part)}" if part else "0 | -" for part in (injected, natural)
            ]
            print(f"| {folder.name} | {tracker} | {' | '.join(figures)} |", flush=True)


def injected_found(run: Run, seed: int) -> Iterator[bool]:
    """For each swap injected into a run, whether its frame is proposed."""
    random = np.random.default_rng(seed)
    table = TrackTable(run.tracks)
    for a, b, frames in _meetings(table):
        for frame in random.choice(frames, min(_EACH, len(frames)), replace=False).tolist():
            swapped = table.snapshot()
            apply_change(swapped, Labels(), plan_swap(swapped, a, b, frame))
            proposed = propose_swap_frames(swapped, a, b, None, signals_of(swapped, run, (a, b)))[
                0
            ].frame
            yield abs(proposed - frame) <= WITHIN


def _meetings(table: TrackTable) -> Iterator[tuple[int, int, Frames]]:
    """Pairs of tracks, and the frames in which they are close, not just begun or about to end."""
    for a in table.track_ids:
        for b in table.track_ids[: table.track_ids.index(a)]:
            one, other = table.of_track(a), table.of_track(b)
            frames, at, there = np.intersect1d(one["frame"], other["frame"], return_indices=True)
            apart = np.hypot(one["x"][at] - other["x"][there], one["y"][at] - other["y"][there])
            near = (apart < _MEETING_M)[_MARGIN:-_MARGIN]
            if near.any():
                yield a, b, frames[_MARGIN:-_MARGIN][near].astype(np.int64)


def natural_found(run: Run, truth: Columns) -> Iterator[bool]:
    """For each swap the tracker made, whether its frame is proposed to who looks a bit later."""
    table = TrackTable(run.tracks)
    for a, b, first, last in natural_swaps(run.tracks, truth):
        signals = signals_of(table, run, (a, b))
        proposed = propose_swap_frames(table, a, b, last + _LATER, signals)[0].frame
        yield first - WITHIN <= proposed <= last + WITHIN


def natural_swaps(tracks: Columns, truth: Columns) -> Iterator[tuple[int, int, int, int]]:
    """Tracks that took each other's person, and the first and last frame it can have happened."""
    turns = [turn for one in np.unique(tracks["track"]) for turn in _turns(tracks, truth, int(one))]
    for at, (a, left, came, last, first) in enumerate(turns):
        for b, left_b, came_b, last_b, first_b in turns[:at]:
            close = max(first, first_b) - min(last, last_b) <= _LONGEST
            if a != b and left == came_b and came == left_b and close:
                yield a, b, min(last, last_b) + 1, max(first, first_b)


def _turns(tracks: Columns, truth: Columns, one: int) -> Iterator[tuple[int, int, int, int, int]]:
    """Where a track goes from a person to another: both, last frame of one, first of the other."""
    rows = np.flatnonzero((tracks["track"] == one) & ~tracks["predicted"])
    frames, people = tracks["frame"][rows], np.zeros(len(rows), np.int64)
    for at, row in enumerate(rows.tolist()):
        there = np.flatnonzero(truth["frame"] == tracks["frame"][row])
        gap = np.hypot(truth["x"][there] - tracks["x"][row], truth["y"][there] - tracks["y"][row])
        if _clear(gap):
            people[at] = truth["track"][there[int(gap.argmin())]]
    frames, people = frames[people > 0], people[people > 0]
    people = np.array([_usual(people[max(at - 4, 0) : at + 5]) for at in range(len(people))])
    for at in np.flatnonzero(np.diff(people)).tolist():
        yield one, int(people[at]), int(people[at + 1]), int(frames[at]), int(frames[at + 1])


def _clear(gap: NDArray[np.float64]) -> bool:
    """Whether one person is near and everybody else clearly farther off."""
    nearest = np.sort(np.append(gap, [np.inf, np.inf]))
    return bool(nearest[0] < _SAME_M and nearest[1] - nearest[0] > _CLEARLY_M)


def _usual(people: NDArray[np.int64]) -> int:
    return int(np.bincount(people).argmax())


if __name__ == "__main__":
    main()

"""What tracking again after a correction is worth: `python -m tests.benchmarks.again`.

Scenes are rendered and tracked; what the tracker found is then spoilt by a swap where two people
pass close to each other. The swap is put right as a person would, the rest is tracked again from
that frame on, and all of it is taken. Each figure is told of the spoilt tracks, of those put right
by hand, and of those after the take, in this order. A last line for each scene tracks again where
nobody corrected anything. Rendered scenes stay in the temporary folder.
"""

from __future__ import annotations

import argparse
import sys
import tempfile
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import cv2
import numpy as np

from tracking.editing import (
    Change,
    History,
    Protection,
    apply_change,
    find_protected,
    plan_swap,
    plan_take,
)
from tracking.errors import EditError
from tracking.formats import read_mot
from tracking.pipeline import track
from tracking.recording import Recording, open_recording
from tracking.scoring import BoxMatch, ScoringTable, score
from tracking.synthesis import SCENES, render_recording
from tracking.trackers import TRACKERS, Resume
from tracking.tracks import CORRECTED_COLUMNS, Columns, Labels, TrackTable

REPORTED_SEEDS = (3401, 3402)
_SCENES = ("lobby", "square")
_SECONDS = 20.0
_MEETINGS = 2
_MARGIN = 30
"""Frames before and after a meeting in which both people are followed."""
_COLUMNS = (
    "scene",
    "from frame",
    "corrected",
    "people kept",
    "of",
    "identity switches",
    "HOTA",
    "protected rows changed",
)


@dataclass(frozen=True, slots=True)
class Meeting:
    """Two tracks that pass each other: at which frame, how close in metres."""

    frame: int
    one: int
    other: int
    metres: float


@dataclass(frozen=True, slots=True)
class Outcome:
    """What the tracks were like at each stage.

    Attributes:
        scores: of the tracks as they were at first, as corrected, and after the take.
        changed: of the protected rows, the share that the take changed.
    """

    scores: tuple[dict[str, Any], ...]
    changed: float


def main() -> None:
    """Print a line for each meeting, and one for tracking again without a correction."""
    parser = argparse.ArgumentParser(prog="python -m tests.benchmarks.again", description=__doc__)
    parser.add_argument("--seeds", nargs="+", type=int, default=list(REPORTED_SEEDS))
    parser.add_argument("--scenes", nargs="+", default=list(_SCENES), choices=list(SCENES))
    parser.add_argument("--tracker", default="stereo-direction", choices=list(TRACKERS))
    parser.add_argument("--meetings", type=int, default=_MEETINGS, help="for each recording")
    asked = parser.parse_args()
    cv2.setNumThreads(1)
    print("|", " | ".join(_COLUMNS), "|")
    print("|", " | ".join("---" for _ in _COLUMNS), "|")
    for scene in asked.scenes:
        for seed in asked.seeds:
            for line in lines(rendered(scene, seed), asked.tracker, asked.meetings):
                print(line, flush=True)


def rendered(scene: str, seed: int) -> Path:
    """The scene's recording, made if it is not there yet."""
    folder = Path(tempfile.gettempdir()) / "trackwright-again" / f"{scene}-{seed}"
    if not (folder / "truth.txt").is_file():
        print(f"rendering {folder}", file=sys.stderr)
        render_recording(folder, scene, _SECONDS, SCENES[scene].people, seed)
    return folder


def lines(folder: Path, tracker: str, count: int) -> Iterator[str]:
    """The lines of the table for a recording."""
    truth = read_mot(folder / "truth.txt")
    with open_recording(folder) as recording:
        first = tracked(recording, tracker, None).tracks
        for meeting in closest(TrackTable(first), count):
            result = corrected_and_taken(recording, tracker, first, truth, meeting)
            pair = f"{meeting.one} and {meeting.other}, {meeting.metres:.2f} m apart"
            yield row(folder.name, meeting.frame, pair, result)
        middle = recording.frame_count // 2
        yield row(folder.name, middle, "-", taken(recording, tracker, first, truth, middle))


def tracked(recording: Recording, tracker: str, resume: Resume | None) -> Any:
    """The run of a tracker over a recording, or over the rest of it."""
    with track(recording, tracker, resume=resume) as tracking:
        for _ in tracking:
            pass
        return tracking.run()


def closest(table: TrackTable, count: int) -> list[Meeting]:
    """Where two tracks pass each other closest, nearest first; a pair meets once."""
    found: list[Meeting] = []
    for one in table.track_ids:
        for other in table.track_ids[: table.track_ids.index(one)]:
            found += _meeting(table, one, other)
    return sorted(found, key=lambda meeting: meeting.metres)[:count]


def _meeting(table: TrackTable, one: int, other: int) -> Iterator[Meeting]:
    mine, theirs = table.of_track(one), table.of_track(other)
    frames, at, there = np.intersect1d(mine["frame"], theirs["frame"], return_indices=True)
    apart = np.hypot(*(mine[name][at] - theirs[name][there] for name in ("x", "y")))
    inner = apart[_MARGIN:-_MARGIN]
    if len(inner):
        nearest = int(inner.argmin())
        yield Meeting(int(frames[_MARGIN + nearest]), other, one, float(inner[nearest]))


def corrected_and_taken(
    recording: Recording, tracker: str, first: Columns, truth: Columns, meeting: Meeting
) -> Outcome:
    """A swap where two meet, put right, tracked again from there on, and taken."""
    table, history = TrackTable(first), History()
    swap = (meeting.one, meeting.other, meeting.frame)
    apply_change(table, Labels(), plan_swap(table, *swap))
    wrong = _score(truth, table)
    done(table, history, plan_swap(table, *swap))
    right = _score(truth, table)
    changed = take(recording, tracker, table, history, meeting.frame)
    return Outcome((wrong, right, _score(truth, table)), changed)


def taken(
    recording: Recording, tracker: str, first: Columns, truth: Columns, frame: int
) -> Outcome:
    """Tracked again from a frame on where nobody corrected anything, and taken."""
    table = TrackTable(first)
    before = _score(truth, table)
    changed = take(recording, tracker, table, History(), frame)
    return Outcome((before, _score(truth, table)), changed)


def take(
    recording: Recording, tracker: str, table: TrackTable, history: History, frame: int
) -> float:
    """Track again and take all of it; gives the share of protected rows that changed."""
    run = tracked(recording, tracker, Resume.of(table, frame, recording.fps))
    protection = find_protected(table, Labels(), history, fps=recording.fps)
    before = table.snapshot()
    try:
        done(
            table, history, plan_take(table, Labels(), history, run, run.frames, fps=recording.fps)
        )
    except EditError as nothing:
        print(f"{recording.name}: {nothing}", file=sys.stderr)
    return changed_share(before, table, protection)


def done(table: TrackTable, history: History, change: Change) -> None:
    """Make an edit and log it."""
    entry = history.draft(change, "2031-01-01T00:00:00.000Z", "benchmark")
    apply_change(table, Labels(), change)
    history.add(entry, change)


def changed_share(before: TrackTable, after: TrackTable, protection: Protection) -> float:
    """Of the protected rows on either side, the share that is not on the other one to the bit."""
    sides = [_protected_bytes(table, protection) for table in (before, after)]
    either = sides[0] | sides[1]
    return len(sides[0] ^ sides[1]) / len(either) if either else 0.0


def _protected_bytes(table: TrackTable, protection: Protection) -> set[bytes]:
    rows = table.columns()
    kept = protection.covers(rows["track"], rows["frame"])
    columns = [rows[name][kept] for name in CORRECTED_COLUMNS]
    return {b"".join(value.tobytes() for value in values) for values in zip(*columns, strict=True)}


def _score(truth: Columns, table: TrackTable) -> dict[str, Any]:
    people = ScoringTable.from_columns(truth, dont_cares=True)
    return score(people, ScoringTable.from_columns(table.columns()), BoxMatch(0.5)).as_json()


def row(name: str, frame: int, pair: str, result: Outcome) -> str:
    """A line of the table; figures of the stages are parted by strokes."""
    scores = result.scores
    kept = _parted([str(each["people_kept"]) for each in scores])
    of = str(scores[-1]["people_detected"])
    switches = _parted([str(each["id_switches"]) for each in scores])
    hota = _parted([f"{each['HOTA']:.3f}" for each in scores])
    cells = (name, str(frame), pair, kept, of, switches, hota, f"{result.changed:.1%}")
    return f"| {' | '.join(cells)} |"


def _parted(figures: Sequence[str]) -> str:
    return " / ".join(figures)


if __name__ == "__main__":
    main()

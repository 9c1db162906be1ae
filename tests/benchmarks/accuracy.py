"""How well the trackers do on rendered scenes: `python -m tests.benchmarks.accuracy`.

Prints a Markdown table. Scenes are rendered with seeds that no setting was chosen on; other
recordings with truth are named as arguments. Rendered scenes stay in the temporary folder.
"""

from __future__ import annotations

import argparse
import sys
import tempfile
from pathlib import Path

import cv2

from tracking.formats import read_mot
from tracking.pipeline import track
from tracking.recording import open_recording
from tracking.scoring import BoxMatch, Score, ScoringTable, score
from tracking.synthesis import SCENES, render_recording
from tracking.trackers import TRACKERS

REPORTED_SEED = 501
_SCENES = ("lobby", "plaza", "square", "uniforms", "pillars", "corridor", "ceiling", "outdoor")
_SECONDS = 30.0
_COLUMNS = (
    "scene",
    "tracker",
    "people",
    "tracking accuracy",
    "MOTA",
    "IDF1",
    "HOTA",
    "floor error",
)


def main() -> None:
    """Track, score, print a row for each recording and tracker."""
    parser = argparse.ArgumentParser(prog="python -m tests.benchmarks.accuracy")
    parser.add_argument("recordings", nargs="*", type=Path, help="instead of rendered scenes")
    parser.add_argument("--trackers", nargs="+", default=list(TRACKERS), choices=list(TRACKERS))
    parser.add_argument("--scenes", nargs="+", default=list(_SCENES), choices=list(SCENES))
    parser.add_argument("--seed", type=int, default=REPORTED_SEED, help="of the rendered scenes")
    asked = parser.parse_args()
    cv2.setNumThreads(1)
    print("|", " | ".join(_COLUMNS), "|")
    print("|", " | ".join("---" for _ in _COLUMNS), "|")
    for folder in asked.recordings or (rendered(scene, asked.seed) for scene in asked.scenes):
        for tracker in asked.trackers:
            print(row(folder.name, tracker, scored(folder, tracker)), flush=True)


def rendered(scene: str, seed: int) -> Path:
    """The scene's recording, made if it is not there yet."""
    folder = Path(tempfile.gettempdir()) / "trackwright-accuracy" / f"{scene}-{seed}"
    if not (folder / "truth.txt").is_file():
        print(f"rendering {folder}", file=sys.stderr)
        render_recording(folder, scene, _SECONDS, SCENES[scene].people, seed)
    return folder


def scored(folder: Path, tracker: str) -> Score:
    """The tracker's score on a recording with truth."""
    with open_recording(folder) as recording, track(recording, tracker) as tracking:
        for _ in tracking:
            pass
        run = tracking.run()
    truth = ScoringTable.from_columns(read_mot(folder / "truth.txt"), dont_cares=True)
    return score(truth, ScoringTable.from_columns(run.tracks), BoxMatch(0.5))


def row(name: str, tracker: str, result: Score) -> str:
    """A line of the table."""
    figures = result.as_json()
    shares = [f"{figures[key]:.3f}" for key in ("tracking_accuracy", "MOTA", "IDF1", "HOTA")]
    people = f"{figures['people_kept']} of {figures['people_detected']}"
    error = f"{figures['position_error_m']['mean']:.3f} m"
    return f"| {' | '.join((name, tracker, people, *shares, error))} |"


if __name__ == "__main__":
    main()

"""Writes where everybody is, seen or not, and what of a scenario is looked at."""

from __future__ import annotations

from pathlib import Path

from tracking.synthesis.scenario import EVERYBODY
from tracking.synthesis.scene import Scene

FLOOR, MOMENTS = "floor.csv", "moments.csv"


def write_scenario(folder: Path, scene: Scene) -> None:
    """Write `floor.csv` and, of a scene with a scenario, `moments.csv`.

    `floor.csv`: frame (from 0), id, x, y in metres of everybody on the floor, in view or not.
    `moments.csv`: start and end (frames from 0, half-open), id (0: everybody), kind, name,
    difficulty (0: not rated).
    """
    _write_floor(folder / FLOOR, scene)
    if scene.moments():
        _write_moments(folder / MOMENTS, scene)


def _write_floor(path: Path, scene: Scene) -> None:
    with path.open("w", encoding="utf-8", newline="\n") as stream:
        stream.write("frame,id,x,y\n")
        for frame in range(scene.frames):
            there = scene.on_floor(frame)
            for person, (x, y) in zip(there, scene.places(frame), strict=True):
                stream.write(f"{frame},{person + 1},{x:.4f},{y:.4f}\n")


def _write_moments(path: Path, scene: Scene) -> None:
    with path.open("w", encoding="utf-8", newline="\n") as stream:
        stream.write("start,end,id,kind,name,difficulty\n")
        for moment in scene.moments():
            seconds = moment.start_s, moment.end_s
            start, end = (min(max(round(s * scene.fps), 0), scene.frames) for s in seconds)
            if start == end:
                continue
            who = 0 if moment.person == EVERYBODY else moment.person + 1
            name = f'"{moment.name}"' if "," in moment.name else moment.name
            stream.write(f"{start},{end},{who},{moment.kind},{name},{moment.difficulty}\n")

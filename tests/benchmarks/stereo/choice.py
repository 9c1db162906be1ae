"""The trackers for two cameras as they come, beside each other: which to take."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import Any

from tests.benchmarks.pages import Figures, table
from tests.benchmarks.rendered_clips import Clip
from tests.benchmarks.stereo import words
from tests.benchmarks.stereo.clip_scores import figures_of
from tests.benchmarks.stereo.clips import folder
from tests.benchmarks.stereo.columns import AS_THEY_COME
from tests.benchmarks.stereo.goals import per_cent_of_truth
from tests.benchmarks.stereo.trackers import Seen, Variant, runs_over
from tests.benchmarks.stereo.truth import truth_of
from tracking.scoring import BoxMatch, Score, ScoringTable, combined, score
from tracking.synthesis import SCENES

Run = tuple[Score, Seen]


def measure(of_scene: Mapping[str, Sequence[Clip]], kept: Path | None = None) -> dict[str, Any]:
    """Each tracker's figures over everything, and by scene."""
    found = {
        scene: [_runs(folder(clip, kept)) for clip in clips] for scene, clips in of_scene.items()
    }
    return {
        "all": _of_each([runs for several in found.values() for runs in several]),
        "scenes": {scene: _of_each(several) for scene, several in found.items()},
        "clips": [clip.name for clips in of_scene.values() for clip in clips],
    }


def _runs(place: Path) -> dict[str, Run]:
    variants = [Variant(name) for name in AS_THEY_COME]
    runs, truth = runs_over(place, variants), truth_of(place).table
    return {
        variant.tracker: (
            score(truth, ScoringTable.from_columns(seen.tracks), BoxMatch(0.5)),
            seen,
        )
        for variant, seen in runs.items()
    }


def _of_each(clips: Sequence[Mapping[str, Run]]) -> dict[str, Any]:
    return {name: _row([runs[name] for runs in clips]) for name in AS_THEY_COME}


def _row(runs: Sequence[Run]) -> dict[str, Any]:
    frames, seeing_s, following_s = (
        sum(float(seen.times[name][0]) for _, seen in runs)
        for name in ("frames", "seeing_s", "following_s")
    )
    return {
        **figures_of(combined([own for own, _ in runs])),
        "seeing_ms": 1000 * seeing_s / frames,
        "following_ms": 1000 * following_s / frames,
    }


def written(figures: Figures) -> str:
    """The section: which to take, everything together, and who is kept where."""
    rows = figures["all"]
    seeds = sorted({name.split("-")[1] for name in figures["clips"]})
    seeing_ms = max(row["seeing_ms"] for row in rows.values())
    said = words.TRACKERS.format(seeds=f"{seeds[0]} to {seeds[-1]}", seeing_ms=seeing_ms)
    parts = (said.strip(), advice(rows), _all(rows), words.BY_SCENE.strip(), _by_scene(figures))
    return "\n\n".join(parts)


def advice(rows: Figures) -> str:
    """Which to take when, by what each is best at."""
    best = {
        "where everybody must keep one id": max(rows, key=lambda name: _share(rows[name])),
        "where every box counts and ids do not": max(rows, key=lambda name: _mota(rows[name])),
        "where time is short": min(rows, key=lambda name: _ms(rows[name])),
    }
    told = dict(zip(best, (_kept, _boxes, _time), strict=True))
    if len(set(best.values())) == 1:
        (name,) = set(best.values())
        reasons = "; ".join(tell(rows, name) for tell in told.values())
        return f"Take `{name}`: it is ahead in everything ({reasons})."
    parts = []
    for one in dict.fromkeys(best.values()):
        uses = [f"{when} ({told[when](rows, one)})" for when, name in best.items() if name == one]
        parts.append(f"`{one}` {' and '.join(uses)}")
    return f"Take {', '.join(parts[:-1])}, and {parts[-1]}."


def _kept(rows: Figures, best: str) -> str:
    others = ", ".join(f"{name} {rows[name]['people_kept']}" for name in rows if name != best)
    row = rows[best]
    return f"{row['people_kept']} of {row['people_detected']} kept, {others}"


def _boxes(rows: Figures, best: str) -> str:
    others = ", ".join(f"{name} {_mota(rows[name]):.3f}" for name in rows if name != best)
    return f"MOTA {_mota(rows[best]):.3f}, {others}"


def _time(rows: Figures, best: str) -> str:
    others = ", ".join(f"{name} {_ms(rows[name]):.2f}" for name in rows if name != best)
    return f"{_ms(rows[best]):.2f} ms a frame, {others}"


def _share(row: Figures) -> float:
    return float(row["people_kept"] / max(row["people_detected"], 1))


def _mota(row: Figures) -> float:
    return float(row["MOTA"])


def _ms(row: Figures) -> float:
    return float(row["following_ms"])


def _all(rows: Figures) -> str:
    head = (
        "tracker, all scenes", "kept", "IDF1", "MOTA", "misses, %", "false alarms, %", "switches",
        "error, m", "ms a frame",
    )  # fmt: skip
    cells = [
        [
            name,
            f"{row['people_kept']} of {row['people_detected']}",
            *(f"{row[figure]:.3f}" for figure in ("IDF1", "MOTA")),
            *(per_cent_of_truth(row, figure) for figure in ("misses", "false_positives")),
            str(row["id_switches"]),
            f"{row['error_m']:.3f}",
            f"{_ms(row):.2f}",
        ]
        for name, row in rows.items()
    ]
    return table(head, cells)


def _by_scene(figures: Figures) -> str:
    head = ["scene", *(f"kept, {name}" for name in AS_THEY_COME)]
    head += [f"IDF1, {name}" for name in AS_THEY_COME]
    cells = []
    for scene, rows in figures["scenes"].items():
        own = [rows[name] for name in AS_THEY_COME]
        kept = [f"{row['people_kept']} of {row['people_detected']}" for row in own]
        cells.append([SCENES[scene].title.lower(), *kept, *(f"{row['IDF1']:.3f}" for row in own)])
    return table(head, cells)

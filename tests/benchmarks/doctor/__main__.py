"""Doctor: `python -m tests.benchmarks.doctor [--report] [--only SECTION ...]`."""

from __future__ import annotations

import tempfile
import time
from collections.abc import Iterator, Sequence
from itertools import cycle
from pathlib import Path
from typing import Any

from tests.benchmarks.clips import Clip, folder_of
from tests.benchmarks.command import real_data, tell
from tests.benchmarks.doctor.plants import BOTH_WAYS, Plant, cut, plants
from tests.benchmarks.pages import Page
from tracking.doctor import Examination, examine
from tracking.recording import open_recording, read_manifest
from tracking.synthesis import Disturbances

SECONDS = 5.0
TUNED = tuple(Clip(scene, 7101, seconds=SECONDS) for scene in ("lobby", "plaza"))
"""For choosing thresholds; never reported."""
SOUND = tuple(
    Clip(scene, seed, seconds=SECONDS)
    for scene, seed in (
        ("lobby", 7201), ("square", 7202), ("indoor", 7203), ("outdoor", 7204),
        ("ceiling", 7205), ("corridor", 7206),
    )
)  # fmt: skip
"""Nothing is wrong with these."""
HALVES = ((0.0, 0.5), (0.5, 1.0))
"""Of the rendered recordings, each taken as a recording."""
BUMPED = tuple(
    Clip(scene, 7301, seconds=SECONDS, disturbances=Disturbances(bumped_s=0.6 * SECONDS))
    for scene in ("lobby", "corridor")
)
"""Something hits the rig, both cameras at once."""
RENDERED = ("rendered-lobby", "rendered-plaza", "rendered-corridor", "rendered-ceiling",
            "rendered-pillars")  # fmt: skip
"""Of the other renderer, in the folder of test recordings."""


def measure_plants(report: bool) -> list[dict[str, Any]]:
    """Every fault in every recording, one at a time."""
    if report:
        rows = [
            row
            for folder, sign in zip(_rendered(), cycle(BOTH_WAYS), strict=False)
            for row in _planted(folder, (sign,))
        ]
        return rows + [_bumped(clip) for clip in BUMPED]
    return [row for clip in TUNED for row in _planted(folder_of(clip))]


def measure_sound(report: bool) -> list[dict[str, Any]]:
    """What is said of recordings that have no fault."""
    clips = SOUND if report else TUNED
    whole = _rendered() if report else []
    rows = [_examined(folder.name, folder) for folder in whole]
    rows += [_half(folder, *half) for folder in whole for half in HALVES]
    return rows + [_examined(clip.name, folder_of(clip)) for clip in clips]


def _half(recording: Path, begin: float, end: float) -> dict[str, Any]:
    with tempfile.TemporaryDirectory() as scratch:
        return _examined(
            f"{recording.name} {begin:g}..{end:g}", cut(recording, scratch, begin, end)
        )


def _rendered() -> list[Path]:
    return [real_data() / name for name in RENDERED if (real_data() / name).is_dir()]


def _planted(recording: Path, signs: Sequence[int] = BOTH_WAYS) -> Iterator[dict[str, Any]]:
    ground = read_manifest(recording).ground
    assert ground is not None
    with tempfile.TemporaryDirectory() as scratch:
        for plant in plants(ground.tilt_deg, signs):
            yield _row(recording.name, plant, plant.put(recording, Path(scratch)))


def _bumped(clip: Clip) -> dict[str, Any]:
    plant = Plant("both cameras knocked", "synth --bump", ("camera-moved",))
    return _row(clip.name, plant, folder_of(clip))


def _row(name: str, plant: Plant, folder: Path) -> dict[str, Any]:
    row = _examined(name, folder)
    told = row["codes"]
    groups = [code for group in row["alike"] for code in group]
    return {
        **row,
        "kind": plant.kind,
        "amount": plant.amount,
        "named": any(code in told for code in plant.codes),
        "in_group": any(code in groups for code in plant.codes),
        "others": sum(code not in plant.codes for code in told),
    }


def _examined(name: str, folder: Path) -> dict[str, Any]:
    begun_s = time.process_time()
    with open_recording(folder) as recording:
        examination = examine(recording)
    row = {"recording": name, **_told(examination), "cpu_s": time.process_time() - begun_s}
    tell(f"{name}: {', '.join(row['codes']) or 'nothing'}")
    return row


def _told(examination: Examination) -> dict[str, Any]:
    return {
        "codes": [one.code for one in examination.findings],
        "alike": [list(one.alike) for one in examination.findings],
        "cost_m": [round(one.cost_m, 3) for one in examination.findings],
    }


def by_kind(rows: Sequence[dict[str, Any]]) -> list[dict[str, Any]]:
    """The rows of each kind of fault, summed up, in the order of measuring."""
    table = []
    for kind in dict.fromkeys(row["kind"] for row in rows):
        own = [row for row in rows if row["kind"] == kind]
        named, grouped = (sum(row[key] for row in own) for key in ("named", "in_group"))
        table.append(
            {
                "kind": kind,
                "amounts": ", ".join(dict.fromkeys(row["amount"] for row in own)),
                "planted": len(own),
                "named": named,
                "told": sum(row["named"] or row["in_group"] for row in own),
                "found": sum(bool(row["codes"]) for row in own),
                "grouped": grouped,
                "others": sum(row["others"] > 0 for row in own),
            }
        )
    return table


PAGE = Page(
    subject="doctor",
    about=__doc__ or "",
    measures={"plants": measure_plants, "sound": measure_sound},
    words={"by_kind": by_kind},
)

if __name__ == "__main__":
    PAGE.main()

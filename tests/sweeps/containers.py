"""Damaged bags and folders of stereo cameras, opened and read: `containers.py --runs N`.

Each is one rendered scene in a container with bytes changed, moved, or cut off. It is refused in
one line or gives frames; nothing but the program that reads bags ends, and none takes long.
"""

from __future__ import annotations

import contextlib
import os
import random
import shutil
import sys
from collections.abc import Callable, Iterator
from pathlib import Path

sys.path.insert(0, str(Path(__file__).parents[1] / "recording"))

from containers_of_scene import BAGS, FOLDERS, Footage, footage_of_scene, write_rosbag1, write_zed

from tests.sweeps.mutations import mutate
from tests.sweeps.runner import Worker, sweep
from tracking.errors import TrackwrightError
from tracking.recording import OpenOptions, open_recording

LONGEST_S = 2.0
"""Of processor time that a damaged container may take, the start of its program included."""
_OPTIONS = OpenOptions(fps=10.0)
_FRAMES_READ = 3


def _packed(folder: Path, footage: Footage) -> Path:
    return write_rosbag1(folder, footage, packed=True)


def _compressed(folder: Path, footage: Footage) -> Path:
    return write_rosbag1(folder, footage, compressed=True)


_KINDS: dict[str, Callable[[Path, Footage], Path]] = {
    **BAGS,
    **FOLDERS,
    "ZED": write_zed,
    "rosbag 1 packed": _packed,
    "rosbag 1 compressed": _compressed,
}


def attack(worker: Worker) -> Iterator[str]:
    """A damaged container a run."""
    footage, kinds = footage_of_scene(), list(_KINDS.items())
    sound: dict[str, Path] = {}
    for number in worker.numbers:
        chance = worker.chance()
        kind, write = kinds[number % len(kinds)]
        if kind not in sound:
            folder = worker.folder / "sound" / kind
            sound[kind] = write(folder, footage).relative_to(folder)
        damaged = worker.folder / "damaged"
        shutil.rmtree(damaged, ignore_errors=True)
        shutil.copytree(worker.folder / "sound" / kind, damaged)
        files = sorted(file for file in damaged.rglob("*") if file.is_file())
        mutate(chance.choice(_likely(files, chance)), chance)
        began_s = _cpu_s()
        outcome = _outcome(damaged / sound[kind])
        took_s = _cpu_s() - began_s
        worker.count("containers")
        if outcome in ("refused", "read"):
            worker.count(outcome)
        else:
            yield f"{kind} {number}: {outcome}"
        if took_s > LONGEST_S:
            yield f"{kind} {number}: it takes {took_s:.1f} s of processor time"


def _likely(files: list[Path], chance: random.Random) -> list[Path]:
    """Tables and calibrations as often as images, which are most files."""
    others = [file for file in files if file.suffix != ".png"]
    return others if others and chance.random() < 0.7 else files


def _outcome(path: Path) -> str:
    try:
        with open_recording(path, _OPTIONS) as recording:
            for number in range(min(_FRAMES_READ, recording.frame_count)):
                recording.read(number)
    except TrackwrightError as refused:
        return "refused" if "\n" not in str(refused) else f"several lines: {refused!r}"
    except Exception as error:
        return f"raises {error!r}"
    return "read"


def _cpu_s() -> float:
    spent = os.times()
    return spent.user + spent.system + spent.children_user + spent.children_system


if __name__ == "__main__":
    with contextlib.suppress(AttributeError):
        os.nice(5)
    sys.exit(sweep(attack, 10_000))

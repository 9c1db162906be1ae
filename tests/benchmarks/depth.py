"""Depth in place of a right camera, against two cameras: `python -m tests.benchmarks.depth`.

The same rendered scenes are tracked by stereo-joint with both cameras, with exact depth, and with
depth as noisy as a stereo camera's. A line a scene; shares in percent.
"""

from __future__ import annotations

import argparse
import json
import subprocess
import sys
import tempfile
from pathlib import Path

import cv2
import numpy as np

from tracking.synthesis import render_recording

SCENES = ("lobby", "plaza", "ceiling")
NOISE_PX, LOST = 0.15, 0.05
"""Deviation of disparity, and share of places without depth, of the noisy one."""
FOCAL_BASELINE = 55.0
"""px m of the rendered cameras, about."""


def main() -> None:
    """Print the table."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--scenes", nargs="*", default=SCENES)
    parser.add_argument("--seeds", type=int, default=3)
    parser.add_argument("--seconds", type=float, default=20.0)
    given = parser.parse_args()
    print("scene     seed  MOTA: stereo depth noisy   kept: stereo depth noisy")
    for scene in given.scenes:
        for seed in range(given.seeds):
            with tempfile.TemporaryDirectory() as folder:
                shares = _compared(Path(folder), scene, seed, given.seconds)
            mota, kept = zip(*shares, strict=True)
            words = [" ".join(f"{100 * share:6.1f}" for share in one) for one in (mota, kept)]
            print(f"{scene:9} {seed:4}  {words[0]}   {words[1]}", flush=True)


def _compared(folder: Path, scene: str, seed: int, seconds: float) -> list[tuple[float, float]]:
    stereo = render_recording(folder / "stereo", scene, seconds, seed=seed)
    depth = render_recording(folder / "depth", scene, seconds, seed=seed, depth=True)
    found = [_tracked(stereo), _tracked(depth)]
    _add_noise(depth, seed)
    return [*found, _tracked(depth)]


def _add_noise(folder: Path, seed: int) -> None:
    """Make the depth of a recording as noisy as a stereo camera's."""
    rng = np.random.default_rng(seed)
    for path in sorted((folder / "depth").glob("*.png")):
        depth = cv2.imread(str(path), cv2.IMREAD_UNCHANGED) / 1000.0
        coarse = rng.standard_normal((depth.shape[0] // 4, depth.shape[1] // 4))
        noise = NOISE_PX * cv2.resize(coarse, depth.shape[::-1], interpolation=cv2.INTER_NEAREST)
        disparity = FOCAL_BASELINE / np.maximum(depth, 0.1) + noise
        noisy = np.where(disparity > 0.5, 1000 * FOCAL_BASELINE / disparity, 0)
        lost = cv2.resize(
            (rng.random(coarse.shape) < LOST).astype(np.uint8),
            depth.shape[::-1],
            interpolation=cv2.INTER_NEAREST,
        )
        noisy[(lost > 0) | (depth == 0)] = 0
        cv2.imwrite(str(path), np.clip(noisy, 0, 65534).astype(np.uint16))


def _tracked(folder: Path) -> tuple[float, float]:
    """MOTA and the share of people kept, of stereo-joint, by the commands themselves."""
    session = folder.with_suffix(".h5")
    _run("track", folder, "-o", session, "--tracker", "stereo-joint", "--force", "--json")
    told = json.loads(_run("score", session, "--truth", folder / "truth.txt", "--json"))
    return told["MOTA"], told["tracking_accuracy"]


def _run(*words: object) -> bytes:
    command = [sys.executable, "-m", "app", *map(str, words)]
    return subprocess.run(command, check=True, capture_output=True).stdout


if __name__ == "__main__":
    main()

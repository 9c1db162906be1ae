"""Tiny recordings of one camera: somebody walks by; and all that can be wrong with recordings."""

from __future__ import annotations

from pathlib import Path

import cv2
import numpy as np
from numpy.typing import NDArray

WIDTH_PX, HEIGHT_PX = 160, 120
FRAMES = 24
_MANIFEST = 'format = 1\nname = "{name}"\nfps = 10.0\n\n[left]\nsource = "{source}"\n'


def make_walk(folder: Path, seed: int = 0, frames: int = FRAMES, *, truth: bool = False) -> Path:
    """A recording of images in which somebody walks from the left to the right."""
    (folder / "left").mkdir(parents=True)
    for number, picture in enumerate(pictures(seed, frames)):
        cv2.imwrite(str(folder / "left" / f"{number:04}.png"), picture)
    write_manifest(folder, "left/*.png")
    if truth:
        lines = [_truth_line(number, seed, frames) for number in range(frames)]
        (folder / "truth.txt").write_text("".join(lines))
    return folder


def write_manifest(folder: Path, source: str) -> None:
    """The manifest of a recording whose only camera is that."""
    text = _MANIFEST.format(name=folder.name, source=source)
    (folder / "recording.toml").write_text(text)


def pictures(seed: int, frames: int) -> list[NDArray[np.uint8]]:
    """The frames of a walk."""
    chance = np.random.default_rng(seed)
    wall = chance.integers(90, 150, (HEIGHT_PX, WIDTH_PX, 3)).astype(np.uint8)
    wall = cv2.GaussianBlur(wall, (5, 5), 0).astype(np.uint8)
    return [_with_person(wall, _left_px(number, seed, frames)) for number in range(frames)]


def _left_px(number: int, seed: int, frames: int) -> int:
    return round(8 + seed % 7 + (WIDTH_PX - 60) * number / frames)


def _with_person(wall: NDArray[np.uint8], left: int) -> NDArray[np.uint8]:
    picture = wall.copy()
    cv2.rectangle(picture, (left, 40), (left + 22, 75), (30, 30, 190), -1)
    cv2.rectangle(picture, (left + 3, 75), (left + 19, 108), (60, 40, 20), -1)
    cv2.circle(picture, (left + 11, 31), 9, (140, 170, 220), -1)
    return picture


def _truth_line(number: int, seed: int, frames: int) -> str:
    left = _left_px(number, seed, frames)
    return f"{number + 1},1,{left + 1},23,23,86,1,-1,-1,-1\n"


def make_damaged(folder: Path, kind: int) -> Path:
    """A recording that cannot be tracked, in one of five ways."""
    if kind == 0:
        folder.mkdir()
        (folder / "recording.toml").write_text("format = 1\nname = [\n")
    elif kind == 1:
        folder.mkdir()
        write_manifest(folder, "left.mp4")
    elif kind == 2:
        folder.mkdir()
        write_manifest(folder, "left.mp4")
        (folder / "left.mp4").write_bytes(b"\0\0\0\x18ftypmp42 and no more")
    elif kind == 3:
        make_walk(folder, kind)
        text = (folder / "recording.toml").read_text()
        (folder / "recording.toml").write_text(f'{text}\n[calibration]\nfile = "none.yaml"\n')
    else:
        make_walk(folder, kind)
        text = (folder / "recording.toml").read_text()
        (folder / "recording.toml").write_text(text.replace("fps = 10.0\n", ""))
    return folder

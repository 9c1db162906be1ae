"""People walking in parts, and a tracker that now and then loses some of them."""

from __future__ import annotations

import numpy as np

from tracking.failure import Samples, joined, samples_of
from tracking.tracks import PART_COLUMNS, PART_EVIDENCE, PartLabel

FPS = 20.0
_PLACE = np.array([-0.33, -0.1, 0.25])
"""Of head, torso and hip-leg below the middle, in heights."""
_SIZE = np.array([[0.10, 0.12], [0.22, 0.30], [0.20, 0.22]])


def walk(
    random: np.random.Generator, frames: int = 120, *, loses: bool = True
) -> tuple[np.ndarray, np.ndarray]:
    """States (frames, 3, 6) as a tracker has them, px and px a frame; whether lost (frames, 3)."""
    height = random.uniform(100, 240)
    time = np.arange(frames)
    centre = np.array([random.uniform(100, 600), 240.0])
    middle = centre + np.outer(time, random.normal(0, 1.5, 2))
    states = np.zeros((frames, 3, 6))
    sway = np.sin(time / FPS * 2 * np.pi * 1.8 + random.uniform(0, 6))
    states[:, :, 0] = middle[:, :1] + np.outer(sway, [0.005, 0.01, 0.03]) * height
    states[:, :, 1] = middle[:, 1:] + _PLACE * height
    states[:, :, 2:4] = _SIZE * height * (1 + 0.05 * random.normal(size=(frames, 3, 2)))
    states[:, :, :2] += random.normal(0, 0.008 * height, (frames, 3, 2))
    lost = np.zeros((frames, 3), bool)
    for start in range(15, frames - 20, 45) if loses else ():
        count = 1 if random.random() < 0.6 else 2
        for part in random.choice(3, count, replace=False):
            way = random.normal(size=2)
            way *= height * random.uniform(0.25, 0.8) / np.hypot(*way)
            states[start : start + 20, part, :2] += way * np.linspace(0.5, 1, 20)[:, None]
            lost[start : start + 20, part] = True
    states[1:, :, 4:] = np.diff(states[:, :, :2], axis=0)
    return states, lost


def as_parts(states: np.ndarray, track: int, first: int = 0) -> dict[str, np.ndarray]:
    """`PART_COLUMNS` of one person's states (frames, 3, 6)."""
    frames = len(states)
    columns = {name: np.zeros(frames * 3, dtype) for name, dtype in PART_COLUMNS.items()}
    columns |= {name: np.full(frames * 3, np.nan) for name in PART_EVIDENCE}
    columns["frame"][:] = np.repeat(np.arange(first, first + frames), 3)
    columns["track"][:] = track
    columns["part"][:] = np.tile(np.arange(3), frames)
    flat = states.reshape(-1, 6)
    for at, name in enumerate(("cx", "cy", "width", "height", "vx", "vy")):
        columns[name][:] = flat[:, at]
    return columns


def box_of(state: np.ndarray) -> tuple[float, float, float, float]:
    """left, top, width, height of a part's state."""
    x, y, width, height = (float(value) for value in state[:4])
    return x - width / 2, y - height / 2, width, height


def labelled(states: np.ndarray, lost: np.ndarray, track: int, every: int = 4) -> list[PartLabel]:
    """A label of every part in every few frames."""
    return [
        PartLabel(frame, track, part, box_of(states[frame, part]), not lost[frame, part], "tracker")
        for frame in range(0, len(states), every)
        for part in range(3)
    ]


def made_up_samples(seed: int, people: int = 8, every: int = 4, recording: str = "yard") -> Samples:
    """Samples of people of whom parts are lost now and then."""
    random = np.random.default_rng(seed)
    each = []
    for track in range(1, people + 1):
        states, lost = walk(random)
        labels = labelled(states, lost, track, every)
        each.append(samples_of(labels, as_parts(states, track), FPS, recording))
    return joined(each)

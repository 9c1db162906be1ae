"""Walkers who cross on a floor, seen with errors: no pictures, so that only following is judged.

15 people walk between places drawn at random in a floor area of 8 m by 7 m in front of a camera
6.5 m high, 1000 frames at 20 a second; they step aside for each other as far as there is room. A
detection is off by 6 cm (standard deviation, each axis). It is missing by chance, and where others
hide nearly all of the person from the camera; some are nobody's. Its colours are those of the
person and of whoever hides a part.
"""

from __future__ import annotations

from pathlib import Path

import cv2
import numpy as np
from numpy.typing import NDArray

from tests.benchmarks.tracker_peers.detections import NO_PICTURE, SeenClip
from tracking.geometry import Camera, Ground, StereoCalibration, View, write_calibration
from tracking.people import Detections
from tracking.people.observation import Observation
from tracking.recording import Manifest, write_manifest
from tracking.scoring import ScoringTable

WALKERS, FRAMES, FPS = 15, 1000, 20.0
NOISE_M, MISSED, NOBODY_A_FRAME = 0.06, 0.05, 0.1
HIDDEN = 0.9
"""Share of a person that others cover from which on the person is not seen."""
_AREA_M = ((-4.0, 4.0), (4.0, 11.0))
_SPEED_M_S = (0.8, 1.5)
_TURNING_S, _GAIN_M_S2 = 0.3, 3.0
_PASSING_M, _AHEAD_S, _ASIDE_M_S = 0.8, 1.5, 3.0
_BINS, _HUES, _COLOUR_NOISE = 16, 16, 0.1
_HEIGHT_M, _WIDTH_M = 1.7, 0.5
_GROUND = Ground(6.5, 50.0)
_CAMERA = Camera(
    np.array([[520.0, 0.0, 319.5], [0.0, 520.0, 239.5], [0.0, 0.0, 1.0]]), np.zeros(5), 640, 480
)
_VIEW = View(_CAMERA, _GROUND)

Floats = NDArray[np.float64]


def crossing_clip(folder: Path, seed: int, frames: int = FRAMES) -> SeenClip:
    """The walkers of that seed; the recording is written into `folder` if it is not there."""
    _write_recording(folder, frames)
    random = np.random.default_rng(seed)
    paths, hues = _walked(random, frames), random.integers(0, _HUES, WALKERS)
    boxes = _VIEW.box_of_person(paths.reshape(-1, 2), _HEIGHT_M, _WIDTH_M)
    boxes = boxes.reshape(frames, WALKERS, 4)
    covers = np.stack([_covering(box, path) for box, path in zip(boxes, paths, strict=True)])
    observations = tuple(
        Observation(at, at / FPS, _seen(paths[at], hues, covers[at], random), NO_PICTURE)
        for at in range(frames)
    )
    truth = _truth(paths, boxes, _hidden(covers))
    return SeenClip(f"crossing {seed}", folder, observations, FPS, truth)


def _write_recording(folder: Path, frames: int) -> None:
    """Two cameras without anything to see over a floor: what trackers ask of a recording."""
    if (folder / "recording.toml").is_file():
        return
    _, black = cv2.imencode(".png", np.zeros((480, 640), np.uint8))
    for camera in ("left", "right"):
        (folder / camera).mkdir(parents=True, exist_ok=True)
        for frame in range(frames):
            (folder / camera / f"{frame:04}.png").write_bytes(black.tobytes())
    rig = StereoCalibration(_CAMERA, _CAMERA, np.eye(3), np.array([-0.12, 0.0, 0.0]))
    write_calibration(folder / "rig.yaml", rig)
    manifest = Manifest(
        "Crossing", "left", "right", fps=FPS, calibration=("rig.yaml",), ground=_GROUND
    )
    write_manifest(folder, manifest)


def _walked(random: np.random.Generator, frames: int) -> Floats:
    """(frames, WALKERS, 2) m: straight towards a place, then in a bend towards the next."""
    low, high = _AREA_M
    place, goal = random.uniform(low, high, (2, WALKERS, 2))
    speed = random.uniform(*_SPEED_M_S, WALKERS)[:, None]
    velocity = np.zeros((WALKERS, 2))
    walked = np.empty((frames, WALKERS, 2))
    for at in range(frames):
        way = goal - place
        left_m = np.hypot(way[:, 0], way[:, 1])[:, None]
        wanted = speed * way / np.maximum(left_m, 1e-9) + _aside(place, velocity)
        gained = (wanted - velocity) / _TURNING_S
        gained *= np.minimum(1.0, _GAIN_M_S2 / np.maximum(np.linalg.norm(gained, axis=1), 1e-9))[
            :, None
        ]
        velocity = velocity + gained / FPS
        place = place + velocity / FPS
        goal = np.where(left_m < 0.7, random.uniform(low, high, (WALKERS, 2)), goal)
        walked[at] = place
    return walked


def _aside(place: Floats, velocity: Floats) -> Floats:
    """(WALKERS, 2) m/s added to what everybody wants, so that they pass beside each other.

    Looks at how close each two will come within a second and a half if they go on as they do.
    """
    apart, nearing = place[:, None] - place[None], velocity[:, None] - velocity[None]
    speed2 = np.maximum((nearing**2).sum(axis=2), 1e-6)
    in_s = np.clip(-(apart * nearing).sum(axis=2) / speed2, 0.0, _AHEAD_S)
    miss = apart + in_s[..., None] * nearing
    miss_m = np.hypot(miss[..., 0], miss[..., 1])
    np.fill_diagonal(miss_m, np.inf)
    side = np.where(miss_m[..., None] > 0.05, miss, _right_of(nearing))
    side /= np.maximum(np.hypot(side[..., 0], side[..., 1]), 1e-9)[..., None]
    push = np.maximum(0.0, _PASSING_M - miss_m) / _PASSING_M * (1.0 - in_s / _AHEAD_S)
    return np.asarray(_ASIDE_M_S * (push[..., None] * side).sum(axis=1))


def _right_of(way: Floats) -> Floats:
    """What lies to the right of a way, turned by a right angle."""
    return np.stack((way[..., 1], -way[..., 0]), axis=-1)


def _covering(box: Floats, path: Floats) -> Floats:
    """(WALKERS, WALKERS) share of each person's box that each other, nearer, covers."""
    low, high = box[:, :2], box[:, :2] + box[:, 2:]
    shared = np.minimum(high[:, None], high) - np.maximum(low[:, None], low)
    area = shared.clip(0.0).prod(axis=2) / box[:, 2:].prod(axis=1)[:, None]
    nearer = path[None, :, 1] < path[:, None, 1]
    return np.where(nearer, area, 0.0)


def _hidden(covers: Floats) -> NDArray[np.bool_]:
    return np.asarray(covers.sum(axis=-1) >= HIDDEN)


def _seen(
    path: Floats, hues: NDArray[np.int64], covers: Floats, random: np.random.Generator
) -> Detections:
    """One frame's detections, in an order that tells nothing."""
    seen = np.flatnonzero((random.random(WALKERS) >= MISSED) & ~_hidden(covers))
    nobody = random.uniform(*_AREA_M, (random.poisson(NOBODY_A_FRAME), 2))
    noisy = path[seen] + random.normal(0.0, NOISE_M, (len(seen), 2))
    colour = np.concatenate(
        (_colours(hues, covers)[seen], np.eye(_BINS)[random.integers(0, _BINS, len(nobody))])
    )
    order = random.permutation(len(colour))
    return _detections(np.concatenate((noisy, nobody))[order], colour[order], random)


def _colours(hues: NDArray[np.int64], covers: Floats) -> Floats:
    """(WALKERS, bins) what shows of each, with what shows of those in front in its region."""
    own = np.eye(_BINS)[hues]
    others = 0.5 * covers
    return (1.0 - others.sum(axis=1, keepdims=True)).clip(0.0) * own + others @ own


def _detections(places: Floats, colour: Floats, random: np.random.Generator) -> Detections:
    count = len(places)
    shown = colour + 0.01 + _COLOUR_NOISE * np.abs(random.normal(size=colour.shape))
    histogram = (shown / shown.sum(axis=1, keepdims=True)).astype(np.float32)
    return Detections(
        box=_VIEW.box_of_person(places, _HEIGHT_M, _WIDTH_M),
        position=np.column_stack((places, np.full(count, _HEIGHT_M / 2))),
        size=np.tile((_WIDTH_M, _HEIGHT_M), (count, 1)),
        merged=np.zeros(count, bool),
        truncated=np.zeros(count, bool),
        upper=histogram,
        lower=histogram,
        middle=histogram,
        regions=np.zeros((1, 1), np.int32),
        clothes=_clothes(histogram),
        from_detector=np.zeros(len(histogram), bool),
    )


def _clothes(histogram: NDArray[np.float32]) -> NDArray[np.float32]:
    """(n, 2, 3) CIELAB: every bin has its direction of a and b, what shows is their mean."""
    angle = np.arange(_BINS) * 2 * np.pi / _BINS
    tint = 60.0 * histogram @ np.column_stack((np.cos(angle), np.sin(angle)))
    lab = np.column_stack((np.full(len(tint), 50.0), tint))
    return np.repeat(lab[:, None], 2, axis=1).astype(np.float32)


def _truth(paths: Floats, boxes: Floats, hidden: NDArray[np.bool_]) -> ScoringTable:
    """Everybody in every frame; whoever is hidden is a don't-care."""
    frames = len(paths)
    box, place = boxes.reshape(-1, 4), paths.reshape(-1, 2)
    columns = {
        "frame": np.repeat(np.arange(frames), WALKERS),
        "track": np.tile(np.arange(1, WALKERS + 1), frames),
        **dict(zip(("left", "top", "width", "height"), box.T, strict=True)),
        "x": place[:, 0],
        "y": place[:, 1],
        "confidence": (~hidden).astype(float).ravel(),
    }
    return ScoringTable.from_columns(columns, dont_cares=True)

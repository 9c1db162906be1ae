"""How often the frame of a swap is found: `python -m tests.benchmarks.swap_frame`.

Two people of a rendered scene's cast, seen as a tracker sees them (places with noise that goes
along, clothes and heights that vary with light and pose, hidden people missing or predicted), bear
each other's name from some frame on; a proposal counts as found within two frames. Prints a
Markdown table, a row for each kind of meeting. With --tracked, swaps are injected into what the
trackers make of rendered footage, and those they made themselves are looked for.
"""

from __future__ import annotations

import argparse
from collections.abc import Iterator
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray
from scipy.ndimage import gaussian_filter1d
from scipy.signal import lfilter

from tracking.editing import propose_swap_frames
from tracking.synthesis import SCENES
from tracking.synthesis.crowd import PlannedWalk, walk
from tracking.synthesis.itineraries import plan_itineraries
from tracking.synthesis.rig import Rig
from tracking.tracks import CORRECTED_COLUMNS, SIGNAL_COLUMNS, Columns, TrackTable

REPORTED_SEEDS = tuple(range(3201, 3211))
KINDS = (
    "close", "smoothed", "hidden", "both hidden", "predicted", "same way", "turning round",
    "brushing", "brushing, hidden",
)  # fmt: skip
WITHIN = 2
_SCENES = ("lobby", "plaza", "square", "uniforms", "corridor", "outdoor")
_SECONDS, _FPS, _PEOPLE = 40.0, 20.0, 10
_MEETING_M = 1.2
_MARGIN = 25
_BODIES_M = 0.3
_EACH = 3
"""So many swaps of a kind from one scene at most."""
_SPREAD = np.array([16.0, 8.0, 12.0] * 2)
_UNIFORM_SPREAD = np.array([4.0, 2.0, 3.0] * 2)

Floats = NDArray[np.float64]


@dataclass(frozen=True, slots=True, eq=False)
class Meeting:
    """Two people in consecutive frames; row i is frame i.

    Attributes:
        places: (2, n, 2) m. looks: (2, 7) colours and height. near: (n,) closer than a swap needs.
    """

    places: Floats
    looks: Floats
    near: NDArray[np.bool_]


@dataclass(frozen=True, slots=True, eq=False)
class Case:
    """A swap to be found.

    Attributes:
        table, signals: with the names changed over. frame: from there on. seen_at: where the user
        looks.
    """

    table: TrackTable
    signals: Columns
    frame: int
    seen_at: int


def meetings(scene: str, seed: int) -> Iterator[Meeting]:
    """Everybody of a scene who comes close to somebody else, while both are in view."""
    spec = SCENES[scene]
    rig, random = Rig.of_scene(spec, (640, 480)), np.random.default_rng((seed, 1))
    plans = plan_itineraries(spec, rig, _PEOPLE, _SECONDS, random)
    walks = [way for way in walk(spec, plans, round(_SECONDS * _FPS), _FPS) if way is not None]
    spread = _UNIFORM_SPREAD if spec.uniform else _SPREAD
    looks = np.column_stack(
        [
            random.normal((45, 5, 5) * 2, spread, (len(walks), 6)),
            random.normal(1.7, 0.08, len(walks)),
        ]
    )
    seen = [_in_view(rig, way) for way in walks]
    for first in range(len(walks)):
        for second in range(first):
            frames = np.intersect1d(seen[first], seen[second])
            if len(frames) < 4 * _MARGIN or len(frames) <= np.ptp(frames):
                continue
            both = (walks[first], walks[second])
            places = np.stack([way.position[frames - way.first_frame] for way in both])
            near = np.linalg.norm(places[0] - places[1], axis=1) < _MEETING_M
            near[:_MARGIN] = near[-_MARGIN:] = False
            if near.any():
                yield Meeting(places, looks[[first, second]], near)


def _in_view(rig: Rig, way: PlannedWalk) -> NDArray[np.int64]:
    boxes = rig.view.box_of_person(way.position, 1.7, 0.5)
    middle = boxes[:, :2] + boxes[:, 2:] / 2
    with np.errstate(invalid="ignore"):
        inside = ((middle > 0) & (middle < rig.size)).all(axis=1)
    return np.flatnonzero(inside) + way.first_frame


def frames_of_kind(meeting: Meeting, kind: str) -> NDArray[np.int64]:
    """Where a swap of the kind can be."""
    step = np.gradient(gaussian_filter1d(meeting.places, 4, axis=1), axis=1) * _FPS
    speed, way = np.linalg.norm(step, axis=2), np.arctan2(step[..., 1], step[..., 0])
    chosen = meeting.near.copy()
    if kind == "same way":
        chosen &= (np.cos(way[0] - way[1]) > 0.7) & (speed.min(axis=0) > 0.4)
    if kind == "turning round":
        around = round(1.2 * _FPS)
        turned = np.cos(np.roll(way, around, axis=1) - np.roll(way, -around, axis=1)).min(axis=0)
        chosen &= turned < -0.3
    return np.flatnonzero(chosen)


def case(meeting: Meeting, kind: str, frame: int, random: np.random.Generator) -> Case:
    """The meeting as a tracker sees it, with a swap."""
    count = meeting.places.shape[1]
    places = meeting.places + _place_noise(meeting.places, random)
    if kind.startswith("brushing"):
        places = _brought_together(places, frame)
    changed = np.arange(count) >= frame
    tracks = np.where(changed[None, :, None], places[::-1], places)
    if kind in ("smoothed", "brushing"):
        tracks = gaussian_filter1d(tracks, 2.0, axis=1, mode="nearest")
    seen = np.ones((2, count), np.bool_)
    if "hidden" in kind or kind == "predicted":
        hidden = slice(max(frame - int(random.integers(4, 26)), 2), frame)
        seen[int(random.integers(0, 2)), hidden] = False
        if kind in ("both hidden", "brushing, hidden"):
            seen[:, hidden] = False
    noticed = np.where(changed[None, :, None], *_looks(meeting, random))
    noticed[~seen] = np.nan
    return Case(
        _table(tracks, seen, keep=kind == "predicted"),
        _signals(noticed),
        frame,
        int(np.clip(frame + random.integers(-40, 80), 0, count - 1)),
    )


def _brought_together(places: Floats, frame: int) -> Floats:
    """The two closer to each other all the way, as near as bodies can come in the given frame."""
    middle, half = places.mean(axis=0), (places[0] - places[1]) / 2
    share = min(1.0, _BODIES_M / 2 / max(float(np.linalg.norm(half[frame])), 1e-6))
    return np.stack([middle + half * share, middle - half * share])


def _place_noise(places: Floats, random: np.random.Generator) -> Floats:
    """Measured places err more far off, and for some frames on end in the same way."""
    reach = np.linalg.norm(places, axis=2, keepdims=True)
    white = random.normal(0, 1, places.shape) * (0.03 + 0.0008 * reach**2)
    slow = lfilter([1], [1, -0.9], random.normal(0, 0.015, places.shape), axis=1)
    return np.asarray(white + slow)


def _looks(meeting: Meeting, random: np.random.Generator) -> tuple[Floats, Floats]:
    """(2, n, 7) what is noticed, names changed over and not; unknown where two are one region."""
    shape = (2, meeting.places.shape[1], 7)
    noise = np.array([4.0] * 6 + [0.04])
    slow = lfilter([np.sqrt(1 - 0.95**2)], [1, -0.95], random.normal(0, 1, shape), axis=1)
    looks = meeting.looks[:, None] + noise * (0.6 * random.normal(0, 1, shape) + slow)
    apart = np.linalg.norm(meeting.places[0] - meeting.places[1], axis=1)
    missing = random.random(shape[:2]) < np.where(apart < 0.8, 0.7, 0.1)
    looks[missing] = np.nan
    return looks[::-1], looks


def _table(tracks: Floats, seen: NDArray[np.bool_], *, keep: bool) -> TrackTable:
    """Rows of tracks 1 and 2; who is not seen is missing, or keep: predicted straight on."""
    tracks = tracks.copy()
    for person in range(2):
        for at in np.flatnonzero(~seen[person]):
            tracks[person, at] = 2 * tracks[person, at - 1] - tracks[person, at - 2]
    frames = np.repeat(np.arange(tracks.shape[1]), 2)
    rows = {name: np.zeros(len(frames), dtype) for name, dtype in CORRECTED_COLUMNS.items()}
    rows["frame"], rows["track"] = frames, np.tile([1, 2], tracks.shape[1])
    rows["x"], rows["y"] = (tracks[..., axis].T.ravel() for axis in (0, 1))
    rows["predicted"] = ~seen.T.ravel()
    there = np.ones(len(frames), np.bool_) if keep else seen.T.ravel()
    return TrackTable({name: column[there] for name, column in rows.items()})


def _signals(noticed: Floats) -> Columns:
    count = noticed.shape[1]
    rows = {
        name: np.full(2 * count, np.nan, dtype) if dtype.kind == "f" else np.zeros(2 * count, dtype)
        for name, dtype in SIGNAL_COLUMNS.items()
    }
    rows["frame"][:], rows["track"][:] = np.repeat(np.arange(count), 2), np.tile([1, 2], count)
    names = ("upper_l", "upper_a", "upper_b", "lower_l", "lower_a", "lower_b", "height_m")
    for name, column in zip(names, noticed.transpose(1, 0, 2).reshape(-1, 7).T, strict=True):
        rows[name][:] = column
    return rows


def cases(kind: str, seeds: tuple[int, ...]) -> Iterator[Case]:
    """All swaps of a kind."""
    for seed in seeds:
        for scene in _SCENES:
            random = np.random.default_rng((seed, KINDS.index(kind)))
            for number, meeting in enumerate(meetings(scene, seed)):
                frames = frames_of_kind(meeting, kind)
                if len(frames) and number < _EACH:
                    yield case(meeting, kind, int(random.choice(frames)), random)


def found(case: Case, *, looks: bool, near: bool) -> tuple[bool, bool, float]:
    """Whether the first proposal is right, whether one of five is, and how sure the first was."""
    proposals = propose_swap_frames(
        case.table, 1, 2, case.seen_at if near else None, case.signals if looks else None
    )
    right = [abs(proposal.frame - case.frame) <= WITHIN for proposal in proposals]
    return right[0], any(right), proposals[0].likelihood


def main() -> None:
    """Print a row for each kind of meeting, and one for all."""
    parser = argparse.ArgumentParser(prog="python -m tests.benchmarks.swap_frame")
    parser.add_argument("--seeds", nargs="+", type=int, default=list(REPORTED_SEEDS))
    asked = parser.parse_args()
    print("| meeting | swaps | found | with the frame looked at | without looks | among five |")
    print("| --- | --- | --- | --- | --- | --- |")
    everything: list[list[float]] = []
    for kind in KINDS:
        figures = []
        for swap in cases(kind, tuple(asked.seeds)):
            plain, five, _ = found(swap, looks=True, near=False)
            near = found(swap, looks=True, near=True)[0]
            blind = found(swap, looks=False, near=False)[0]
            figures.append([plain, near, blind, five])
        everything += figures
        _print(kind, figures)
    _print("all", everything)


def _print(kind: str, figures: list[list[float]]) -> None:
    shares = np.mean(np.array(figures, float).reshape(-1, 4), axis=0)
    print(
        f"| {kind} | {len(figures)} | {' | '.join(f'{share:.1%}' for share in shares)} |",
        flush=True,
    )


if __name__ == "__main__":
    main()

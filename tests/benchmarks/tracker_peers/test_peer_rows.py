"""Our trackers beside those of others: clips, figures, and what is told of who is missing."""

from __future__ import annotations

import subprocess
import sys
from pathlib import Path

import numpy as np
import pytest

from tests.benchmarks.tracker_peers import comparison
from tests.benchmarks.tracker_peers.crossings import FPS, WALKERS, crossing_clip
from tests.benchmarks.tracker_peers.detections import SeenClip
from tests.peers import environments
from tests.peers.follow import follow
from tests.peers.followers import FOLLOWERS
from tests.peers.sequences import read_tables, write_tables

FRAMES = 60


@pytest.fixture(scope="module")
def clip(tmp_path_factory: pytest.TempPathFactory) -> SeenClip:
    return crossing_clip(tmp_path_factory.mktemp("crossing"), seed=1, frames=FRAMES)


def exact(clip: SeenClip) -> np.ndarray:
    """Rows right where everybody is, under their own numbers."""
    truth = clip.truth
    return np.column_stack((truth.frame, truth.track, truth.position))


def test_detections_are_as_far_off_as_is_said_and_the_same_for_a_seed(
    clip: SeenClip, tmp_path: Path
) -> None:
    nearest = [
        np.hypot(*(clip.truth.position[clip.truth.frame == row[0]] - row[5:7]).T).min()
        for row in clip.seen
    ]
    assert np.median(nearest) == pytest.approx(0.06 * np.sqrt(2 * np.log(2)), rel=0.1)
    assert np.array_equal(crossing_clip(tmp_path, seed=1, frames=FRAMES).seen, clip.seen)


def test_without_colours_only_places_tell_people_apart(clip: SeenClip) -> None:
    bare = clip.without_colours
    assert np.array_equal(bare.seen, clip.seen)
    for one in bare.observations:
        assert len(np.unique(one.people.middle)) == 1
        assert np.isnan(one.people.clothes).all()


def test_two_who_change_numbers_are_two_switches(clip: SeenClip) -> None:
    found, times = exact(clip), np.full(FRAMES, 0.005)
    right = comparison.figures_of([clip], {clip.name: (found.copy(), times)})
    assert (right["id_switches"], right["idf1"], right["kept"]) == (0, 1.0, WALKERS)
    assert right["ms"] == pytest.approx(5.0)
    late = found[:, 0] >= FRAMES / 2
    found[late, 1] = np.select([found[late, 1] == 1, found[late, 1] == 2], [2, 1], found[late, 1])
    wrong = comparison.figures_of([clip], {clip.name: (found, times)})
    assert (wrong["id_switches"], wrong["kept"]) == (2, WALKERS - 2)


def test_a_tracker_gets_each_frame_once_and_its_names_become_numbers() -> None:
    seen = np.zeros((3, 8))
    seen[:, 0], seen[:, 5], seen[1, 7] = (0, 0, 2), (1, 2, 3), 1
    asked = []

    def start(settings: dict[str, bool], fps: float):
        def step(frame: int, given: np.ndarray):
            asked.append((frame, len(given)))
            return [("anna", place) for place in given[:, 5:7]]

        return step

    told, taken_s = follow(start, seen, 3, FPS, {"with_merged": False})
    assert asked == [(0, 1), (1, 0), (2, 1)]
    assert told.tolist() == [[0, 1, 1, 0], [2, 1, 3, 0]]
    assert len(taken_s) == 3


def test_trackers_nobody_asks_for_need_not_be_installed(tmp_path: Path) -> None:
    given, told = tmp_path / "given.npz", tmp_path / "told.npz"
    write_tables(given, {"clip": (2, 10.0, np.zeros((0, 8)))})
    script = environments.HERE / "follow.py"
    subprocess.run([sys.executable, script, given, told, "[]"], check=True)
    assert read_tables(told) == []


def test_every_tracker_has_its_row_and_who_is_missing_is_told(
    clip: SeenClip, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(environments, "KEPT", tmp_path)
    found = comparison.compared_on([clip], "crossing", ["stereo-direction"])
    ours, peers = found[:4], found[4:]
    assert {(r["colour"], r["finished"]) for r in ours} == {(a, b) for a in (0, 1) for b in (0, 1)}
    assert all(row["figures"]["idf1"] > 0.9 for row in ours)
    assert [row["tracker"] for row in peers] == [one.name for one in FOLLOWERS]
    for row, follower in zip(peers, FOLLOWERS, strict=True):
        assert row["figures"] is None
        assert row["absent"].endswith(f"-m tests.peers {follower.peer.name}")


def test_a_peer_that_fails_is_a_row_that_says_so(
    clip: SeenClip, monkeypatch: pytest.MonkeyPatch
) -> None:
    def failing(*_: object) -> str:
        raise RuntimeError("follow.py failed: first\nMemoryError")

    monkeypatch.setattr(environments.Peer, "installed", True)
    monkeypatch.setattr(environments.Peer, "run", failing)
    found = comparison.compared_on([clip], "crossing", [])
    assert [row["figures"] for row in found] == [None] * len(FOLLOWERS)
    assert found[0]["absent"] == "norfair failed: MemoryError"


@pytest.mark.skipif(not environments.NORFAIR.installed, reason=environments.NORFAIR.absent)
def test_a_peer_that_is_installed_follows_the_walkers(clip: SeenClip) -> None:
    norfair = next(one for one in FOLLOWERS if one.name == "norfair")
    settings = comparison.chosen_settings("crossing")["norfair"]
    (told,) = norfair.follow({clip.name: (FRAMES, FPS, clip.seen)}, [settings])
    assert comparison.figures_of([clip], told)["idf1"] > 0.8

"""The trackers of others that follow the same detections, each in its own environment."""

from __future__ import annotations

import json
import tempfile
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from tests.peers.environments import MOTPY, NORFAIR, STONESOUP, TRACKERS, Peer
from tests.peers.peer_runs import read_followed, write_detections

Seen = tuple[int, float, NDArray[np.float64]]
"""Frames, frames a second, and (n, 8) detections; see `following.SEEN`."""

Followed = tuple[NDArray[np.float64], NDArray[np.float64]]
"""(n, 4) rows by `following.FOLLOWED`, and (frames,) seconds of processor time."""

Settings = Mapping[str, Any]


@dataclass(frozen=True, slots=True)
class Follower:
    """A tracker of others.

    Attributes:
        name: as tables show it.
        peer: the environment it lives in.
        script: of this folder, that starts it.
    """

    name: str
    peer: Peer
    script: str

    def follow(
        self, clips: Mapping[str, Seen], settings: Sequence[Settings]
    ) -> list[dict[str, Followed]]:
        """What it makes of all clips, by their names, with each of these settings.

        Raises:
            RuntimeError: it is not installed, or it fails.
        """
        with tempfile.TemporaryDirectory() as folder:
            given, told = Path(folder) / "given.npz", Path(folder) / "told.npz"
            write_detections(given, clips)
            asked = json.dumps([[self.name, dict(one)] for one in settings])
            self.peer.run(self.script, given, told, asked)
            followed: list[dict[str, Followed]] = read_followed(told)
        return followed


STONESOUP_GNN = Follower("Stone Soup GNN", STONESOUP, "stonesoup_follows.py")

FOLLOWERS = (
    Follower("norfair", NORFAIR, "norfair_follows.py"),
    Follower("motpy", MOTPY, "motpy_follows.py"),
    Follower("SORT", TRACKERS, "trackers_follows.py"),
    Follower("ByteTrack", TRACKERS, "trackers_follows.py"),
    Follower("OC-SORT", TRACKERS, "trackers_follows.py"),
    STONESOUP_GNN,
    Follower("Stone Soup JPDA", STONESOUP, "stonesoup_follows.py"),
)

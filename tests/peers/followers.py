"""The trackers of others that follow the same detections, each in its own environment."""

from __future__ import annotations

import json
import tempfile
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from numpy.typing import NDArray

from tests.peers.environments import MOTPY, NORFAIR, STONESOUP, TRACKERS, Peer
from tests.peers.sequences import read_tables, write_tables

Seen = tuple[int, float, NDArray[Any]]
"""Frames, frames a second, and (n, 8) detections; by `follow.SEEN`."""

Followed = tuple[NDArray[Any], NDArray[Any]]
"""(n, 4) rows by `follow.FOLLOWED`, and (frames,) seconds of processor time."""

Settings = Mapping[str, Any]


@dataclass(frozen=True, slots=True)
class Follower:
    """A tracker of others: its name in tables, and the environment it lives in."""

    name: str
    peer: Peer

    def follow(
        self, clips: Mapping[str, Seen], settings: Sequence[Settings]
    ) -> list[dict[str, Followed]]:
        """What it makes of all clips, by their names, with each of these settings.

        Raises:
            RuntimeError: it is not installed, or it fails.
        """
        with tempfile.TemporaryDirectory() as folder:
            given, told = Path(folder) / "given.npz", Path(folder) / "told.npz"
            write_tables(given, clips)
            asked = json.dumps([[self.name, dict(one)] for one in settings])
            self.peer.run("follow.py", given, told, asked)
            followed: list[dict[str, Followed]] = read_tables(told)
        return followed


STONESOUP_GNN = Follower("Stone Soup GNN", STONESOUP)
FOLLOWERS = (
    Follower("norfair", NORFAIR),
    Follower("motpy", MOTPY),
    Follower("SORT", TRACKERS),
    Follower("ByteTrack", TRACKERS),
    Follower("OC-SORT", TRACKERS),
    STONESOUP_GNN,
    Follower("Stone Soup JPDA", STONESOUP),
)

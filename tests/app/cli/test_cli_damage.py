"""Commands that read a session say on stderr what of it is damaged or may be missing."""

from __future__ import annotations

from contextlib import closing
from pathlib import Path

import pytest
from command_line import Trackwright

from tracking.editing import plan_rename
from tracking.session import Session


@pytest.fixture
def damaged(session: Path) -> Path:
    """A session with one flipped bit in the name of a track."""
    with closing(Session.open(session)) as opened:
        track = opened.tracks.track_ids[0]
        opened.apply(plan_rename(opened.tracks, opened.labels, track, "red coat"))
        opened.save()
    data = bytearray(session.read_bytes())
    data[data.rindex(b"red coat")] ^= 1
    session.write_bytes(data)
    return session


@pytest.mark.parametrize("command", ["export", "count", "review"])
def test_a_damaged_session_is_told_on_stderr(
    trackwright: Trackwright, damaged: Path, tmp_path: Path, command: str
) -> None:
    options = {
        "export": ["-o", tmp_path / "out.txt", "--format", "mot"],
        "count": ["--line", "door:0,0:1,1"],
        "review": [],
    }[command]
    status, _, told = trackwright(command, damaged, *options)
    assert status == 0
    assert told.count("its checksum does not hold") == 1

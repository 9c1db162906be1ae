"""The program that reads a bag may stall or end at any message."""

from __future__ import annotations

import time
from pathlib import Path

import pytest

from tracking.errors import RecordingError
from tracking.recording.bags import bag_process
from tracking.recording.bags.bag_process import BagProcess, BrokenMessageError

_PROGRAM = """
import json, sys, time
def say(data):
    sys.stdout.buffer.write(data)
    sys.stdout.buffer.flush()
start = json.loads(sys.stdin.buffer.readline())
if "counts" in start:
    sys.stdin.buffer.read(24 * sum(start["counts"]))
    say(b'{"ready": true}\\n')
else:
    head = {"topics": ["/a", "", ""], "counts": [50, 0, 0], "sizes": [[4, 4], [], []]}
    head |= {"in_metres": False, "recorded_times": False, "calibrations": []}
    say(json.dumps(head).encode() + b"\\n")
    STALL_IN_TABLES
    say(bytes(24 * 50))
while line := sys.stdin.buffer.readline():
    number = json.loads(line)["number"]
    END_AT
    say(b'{"shape": [4, 4, 3], "kind": "uint8"}\\n')
    STALL_IN_PICTURE
    say(bytes([number]) * 48)
"""
_STALLED_S = 20


def write_program(
    folder: Path, monkeypatch: pytest.MonkeyPatch, **changes: str
) -> tuple[Path, tuple[str, str, str]]:
    text = _PROGRAM
    for name in ("STALL_IN_TABLES", "STALL_IN_PICTURE", "END_AT"):
        text = text.replace(name, changes.get(name, "pass"))
    program, bag = folder / "program.py", folder / "run.bag"
    program.write_text(text)
    bag.write_bytes(b"")
    monkeypatch.setattr(bag_process, "_WORKER", program)
    return bag, ("", "", "")


def test_a_program_that_stalls_in_its_tables_is_ended(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(bag_process, "_PATIENCE_S", 1.0)
    stall = {"STALL_IN_TABLES": f"time.sleep({_STALLED_S})"}
    begin = time.monotonic()
    with pytest.raises(RecordingError, match="is damaged"):
        BagProcess(*write_program(tmp_path, monkeypatch, **stall))
    assert time.monotonic() - begin < _STALLED_S / 2


def test_a_program_that_stalls_in_a_picture_is_ended(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    stall = {"STALL_IN_PICTURE": f"time.sleep({_STALLED_S})"}
    bag = BagProcess(*write_program(tmp_path, monkeypatch, **stall))
    monkeypatch.setattr(bag_process, "_PATIENCE_S", 1.0)
    begin = time.monotonic()
    with pytest.raises(BrokenMessageError):
        bag.read(0, 0)
    assert time.monotonic() - begin < _STALLED_S / 2
    bag.close()

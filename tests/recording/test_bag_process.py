"""The program that reads a bag may stall or end at any message."""

from __future__ import annotations

import time
from io import BytesIO
from pathlib import Path

import pytest
from containers_of_scene import footage_of_scene, write_rosbag1

from tracking.errors import RecordingError
from tracking.recording.bags import bag_process, bag_program, messages
from tracking.recording.bags.bag_process import BagProcess, BrokenMessageError
from tracking.untrusted.pipe import receive_head, send

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


def test_a_program_that_ends_at_every_other_picture_is_started_again(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    bag = BagProcess(*write_program(tmp_path, monkeypatch, END_AT="if number % 2: break"))
    for number in range(0, 16, 2):
        assert (bag.read(0, number) == number).all()
        with pytest.raises(BrokenMessageError):
            bag.read(0, number + 1)
    bag.close()


def test_a_program_that_always_ends_is_given_up(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    bag = BagProcess(*write_program(tmp_path, monkeypatch, END_AT="break"))
    for _ in range(bag_process._MOST_RESTARTS + 1):
        with pytest.raises(BrokenMessageError):
            bag.read(0, 0)
    with pytest.raises(RecordingError, match="is damaged"):
        bag.read(0, 0)


@pytest.mark.filterwarnings("ignore")  # the program leaves closing to its end
def test_time_is_given_by_size_and_none_is_lost_by_the_library(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    path = write_rosbag1(tmp_path, footage_of_scene(), packed=True)
    allowed: list[tuple[float, int]] = []
    made = messages._store.cache_info

    def note(seconds: float) -> float:
        before = allowed[-1][0] if allowed else 0.0
        allowed.append((seconds, made().currsize))
        return before

    monkeypatch.setattr(bag_program, "_allow", note)
    monkeypatch.setattr(bag_program, "_limit_memory", lambda: None)
    monkeypatch.setattr(bag_program, "_WORKED_BYTES_A_SECOND", 1000)
    topic = "/stereo/left/image_raw"
    commands, answers = BytesIO(), BytesIO()
    send(commands, {"path": str(path), "topics": [topic, "", ""], "counts": [0, 0, 0]})
    commands.seek(0)
    messages._store.cache_clear()
    bag_program.main(commands, answers)
    answers.seek(0)
    assert receive_head(answers) == {"ready": True}
    # Made while no limit runs, before the program says that it is ready.
    unlimited = next(at for at, (seconds, _) in enumerate(allowed) if not seconds)
    assert [count for _, count in allowed[unlimited : unlimited + 2]] == [0, 1]

    allowed.clear()
    commands, answers = BytesIO(), BytesIO()
    send(commands, {"path": str(path), "topics": [topic, "", ""]})
    send(commands, {"side": 0, "number": 0})
    commands.seek(0)
    bag_program.main(commands, answers)
    picture_bytes = 160 * 120 * 3
    assert max(seconds for seconds, _ in allowed[-8:]) > picture_bytes / 1000

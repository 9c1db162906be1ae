"""How fast a bag of an hour opens, and is read anywhere: `python -m tests.benchmarks.bags`.

Two cameras with 20 compressed images a second, written into each kind of bag. Opening is all that
`open_recording` does, its program started; a seek is both images of one frame. In seconds and ms of
the clock, and seconds of processor time of both programs. The first opening reads from the disk,
where the system can forget what it keeps of a file in memory.
"""

from __future__ import annotations

import argparse
import os
import random
import shutil
import tempfile
import time
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import cv2
import numpy as np
from mcap.writer import CompressionType, Writer
from rosbags.rosbag1 import Writer as Rosbag1Writer
from rosbags.rosbag2 import StoragePlugin
from rosbags.rosbag2 import Writer as Rosbag2Writer
from rosbags.typesys import Stores, get_typestore

from tracking.recording import open_recording

FPS, SIZE, SEEKS = 20, (160, 120), 50
START_NS = 1_700_000_000_000_000_000
_KIND = "sensor_msgs/msg/CompressedImage"


def main() -> None:
    """Print a line a container."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--minutes", type=float, default=60.0)
    parser.add_argument("--folder", type=Path, help="where the bags go; a temporary folder if None")
    given = parser.parse_args()
    with tempfile.TemporaryDirectory(dir=given.folder) as folder:
        for name, write in (
            ("rosbag 1", _rosbag1),
            ("rosbag 2, SQLite", _sqlite),
            ("MCAP, plain", _plain_mcap),
            ("MCAP, zstd", _packed_mcap),
        ):
            path = write(Path(folder), round(given.minutes * 60 * FPS))
            print(f"{name:18} {_measured(path)}", flush=True)
            shutil.rmtree(path) if path.is_dir() else path.unlink()


def _measured(path: Path) -> str:
    files = list(path.iterdir()) if path.is_dir() else [path]
    bytes_held = sum(file.stat().st_size for file in files)
    for file in files:
        _forget(file)
    first, again = _opened(path), _opened(path)
    with open_recording(path) as recording:
        chance = random.Random(0)
        seeks = []
        for _ in range(SEEKS):
            number = chance.randrange(recording.frame_count)
            began = time.perf_counter()
            recording.read(number)
            seeks.append(1000 * (time.perf_counter() - began))
        frames = recording.frame_count
    return (
        f"{bytes_held / 1e9:5.2f} GB, {frames} frames: opens in {first}, again in {again}, "
        f"seeks in {np.median(seeks):5.1f} ms (longest {max(seeks):5.1f})"
    )


def _forget(path: Path) -> None:
    """Have the system read a file from the disk again, where it can be told."""
    if not hasattr(os, "posix_fadvise"):
        return
    with path.open("rb") as file:
        os.fsync(file.fileno())
        os.posix_fadvise(file.fileno(), 0, 0, os.POSIX_FADV_DONTNEED)


def _opened(path: Path) -> str:
    """How long it takes to open a bag, by the clock and in processor time of both programs."""
    cpu_s, began = _cpu_s(), time.perf_counter()
    recording = open_recording(path)
    opened_s = time.perf_counter() - began
    recording.close()
    del recording  # its program ends
    return f"{opened_s:5.2f} s ({_cpu_s() - cpu_s:5.2f} s of processor time)"


def _cpu_s() -> float:
    spent = os.times()
    return spent.user + spent.system + spent.children_user + spent.children_system


def _messages(store: Any, frames: int) -> Iterator[tuple[str, int, Any]]:
    """Topic, time and message; eight images in turn."""
    kinds = store.types
    header = kinds["std_msgs/msg/Header"]
    sequence = {"seq": 0} if "seq" in header.__dataclass_fields__ else {}
    rng = np.random.default_rng(0)
    images = []
    for _ in range(8):
        coarse = rng.integers(0, 256, (24, 32, 3), np.uint8)
        image = cv2.resize(coarse, SIZE, interpolation=cv2.INTER_CUBIC)
        images.append(np.frombuffer(cv2.imencode(".jpg", image)[1].tobytes(), np.uint8))
    for number in range(frames):
        stamp = START_NS + number * 10**9 // FPS
        time_kind = kinds["builtin_interfaces/msg/Time"]
        told = time_kind(sec=stamp // 10**9, nanosec=stamp % 10**9)
        for late, side in enumerate(("left", "right")):
            value = kinds[_KIND](
                header=header(stamp=told, frame_id="camera", **sequence),
                format="jpeg",
                data=images[(number + late) % 8],
            )
            yield f"/{side}/image_raw/compressed", stamp + 1000 * late, value


def _rosbag1(folder: Path, frames: int) -> Path:
    path, store = folder / "one.bag", get_typestore(Stores.ROS1_NOETIC)
    with Rosbag1Writer(path) as writer:
        topics: dict[str, Any] = {}
        for topic, stamp, value in _messages(store, frames):
            if topic not in topics:
                topics[topic] = writer.add_connection(topic, _KIND, typestore=store)
            writer.write(topics[topic], stamp, store.serialize_ros1(value, _KIND))
    return path


def _sqlite(folder: Path, frames: int) -> Path:
    path, store = folder / "two", get_typestore(Stores.ROS2_HUMBLE)
    plugin = StoragePlugin.SQLITE3
    with Rosbag2Writer(path, version=9, storage_plugin=plugin) as writer:
        topics: dict[str, Any] = {}
        for topic, stamp, value in _messages(store, frames):
            if topic not in topics:
                topics[topic] = writer.add_connection(topic, _KIND, typestore=store)
            writer.write(topics[topic], stamp, store.serialize_cdr(value, _KIND))
    return path


def _plain_mcap(folder: Path, frames: int) -> Path:
    return _mcap(folder / "plain.mcap", frames, CompressionType.NONE)


def _packed_mcap(folder: Path, frames: int) -> Path:
    return _mcap(folder / "packed.mcap", frames, CompressionType.ZSTD)


def _mcap(path: Path, frames: int, compression: CompressionType) -> Path:
    store = get_typestore(Stores.ROS2_HUMBLE)
    definition, _ = store.generate_msgdef(_KIND, ros_version=2)
    with path.open("wb") as file:
        writer = Writer(file, compression=compression)
        writer.start(profile="ros2")
        schema = writer.register_schema(_KIND, "ros2msg", definition.encode())
        channels = {
            f"/{side}/image_raw/compressed": writer.register_channel(
                f"/{side}/image_raw/compressed", "cdr", schema
            )
            for side in ("left", "right")
        }
        for topic, stamp, value in _messages(store, frames):
            data = bytes(store.serialize_cdr(value, _KIND))
            writer.add_message(channels[topic], stamp, data, stamp)
        writer.finish()
    return path


if __name__ == "__main__":
    main()

"""Images, depth and camera_info in ROS messages; which topics are the cameras'.

Runs in the bag program.
"""

from __future__ import annotations

import re
import struct
from collections.abc import Mapping, Sequence
from functools import cache
from typing import Any

import cv2
import numpy as np
from numpy.typing import NDArray

from tracking.recording.bags.container import (
    BagError,
    Container,
    Topic,
)
from tracking.translation import msg

IMAGE, COMPRESSED = "sensor_msgs/msg/Image", "sensor_msgs/msg/CompressedImage"
INFO = "sensor_msgs/msg/CameraInfo"
_KINDS = (IMAGE, COMPRESSED, INFO)
MOST_PIXELS = 40_000_000
_SIDES = (("left", "right"), ("infra1", "infra2"), ("cam0", "cam1"), ("camera0", "camera1"))
_SIDES_OF_NUMBERS = (("0", "1"), ("1", "2"))
_DEPTH_HEAD_BYTES = 12
_DEPTH_UNITS = ("16UC1", "mono16")
_CHANNELS: Mapping[str, tuple[type[np.generic], int, int | None]] = {
    "mono8": (np.uint8, 1, cv2.COLOR_GRAY2BGR),
    "8UC1": (np.uint8, 1, cv2.COLOR_GRAY2BGR),
    "bgr8": (np.uint8, 3, None),
    "8UC3": (np.uint8, 3, None),
    "rgb8": (np.uint8, 3, cv2.COLOR_RGB2BGR),
    "bgra8": (np.uint8, 4, cv2.COLOR_BGRA2BGR),
    "rgba8": (np.uint8, 4, cv2.COLOR_RGBA2BGR),
    "bayer_rggb8": (np.uint8, 1, cv2.COLOR_BayerBG2BGR),
    "bayer_bggr8": (np.uint8, 1, cv2.COLOR_BayerRG2BGR),
    "bayer_gbrg8": (np.uint8, 1, cv2.COLOR_BayerGR2BGR),
    "bayer_grbg8": (np.uint8, 1, cv2.COLOR_BayerGB2BGR),
    "mono16": (np.uint16, 1, None),
    "16UC1": (np.uint16, 1, None),
    "32FC1": (np.float32, 1, None),
}
"""Pixel, channels and OpenCV's conversion to BGR of the encodings that are read. ROS names Bayer
patterns by their first pixels, OpenCV by the second row's."""

Picture = NDArray[Any]


class Messages:
    """Messages of a bag as values."""

    def prepare(self, topics: Sequence[Topic]) -> None:
        """Make what reading images of such topics takes, which no file has a part in."""
        for is_ros1 in {topic.is_ros1 for topic in topics if topic.kind in _KINDS}:
            _store(is_ros1)

    def value(self, topic: Topic, data: bytes) -> Any:
        """The message as the library has it."""
        store = _store(topic.is_ros1)
        read = store.deserialize_ros1 if topic.is_ros1 else store.deserialize_cdr
        return read(data, topic.kind)

    def picture(self, topic: Topic, data: bytes) -> Picture:
        """(height, width, 3) uint8 BGR, or (height, width) uint16 units or float32 m of depth."""
        value = self.value(topic, data)
        return _of_compressed(value) if topic.kind == COMPRESSED else _of_image(value)


@cache
def _store(is_ros1: bool) -> Any:
    """The library's types of messages, which take a while to make."""
    from rosbags.typesys import Stores, get_typestore

    return get_typestore(Stores.ROS1_NOETIC if is_ros1 else Stores.ROS2_HUMBLE)


def stamp_ns(topic: Topic, head: bytes) -> int:
    """The time in a message's header, by its first bytes."""
    if topic.is_ros1:
        seconds, rest = struct.unpack_from("<II", head, 4)
    else:
        order = "<" if head[1] & 1 else ">"
        seconds, rest = struct.unpack_from(f"{order}iI", head, 4)
    return int(seconds) * 10**9 + int(rest)


def _of_image(value: Any) -> Picture:
    height, width, step = int(value.height), int(value.width), int(value.step)
    known = _CHANNELS.get(str(value.encoding))
    if known is None:
        raise BagError(msg("holds images of {encoding}", encoding=str(value.encoding)[:40]))
    kind, channels, conversion = known
    size = np.dtype(kind).itemsize
    if not 0 < height * width <= MOST_PIXELS or step < width * channels * size:
        raise BagError(msg("holds an image of an impossible size"))
    rows = np.frombuffer(value.data, np.uint8)[: height * step].reshape(height, step)
    pixels = np.ascontiguousarray(rows[:, : width * channels * size]).view(kind)
    if value.is_bigendian and size > 1:
        pixels = pixels.byteswap()
    if channels > 1:
        pixels = pixels.reshape(height, width, channels)
    return pixels if conversion is None else np.asarray(cv2.cvtColor(pixels, conversion))


def _of_compressed(value: Any) -> Picture:
    data, told = np.frombuffer(value.data, np.uint8), str(value.format)
    if "compressedDepth" in told:
        return _of_compressed_depth(data, in_metres="32FC1" in told)
    of_units = any(name in told for name in _DEPTH_UNITS)
    return _decoded(data, cv2.IMREAD_UNCHANGED if of_units else cv2.IMREAD_COLOR)


def _of_compressed_depth(data: NDArray[np.uint8], in_metres: bool) -> Picture:
    """A PNG behind a head of its own; of metres it holds the inverse, in steps the head tells.

    Source: ROS' compressed_depth_image_transport, codec.cpp.
    """
    head, data = data[:_DEPTH_HEAD_BYTES].tobytes(), data[_DEPTH_HEAD_BYTES:]
    units = _decoded(data, cv2.IMREAD_UNCHANGED)
    if units.ndim != 2 or units.dtype != np.uint16:
        raise BagError(msg("holds depth that is not of 16 bits and one channel"))
    if not in_metres:
        return units
    scale, offset = np.frombuffer(head, "<f4", 2, offset=4)
    with np.errstate(all="ignore"):
        depth = scale / (units.astype(np.float32) - offset)
    return np.where(units > 0, depth, np.float32(np.nan))


def _decoded(data: NDArray[np.uint8], flag: int) -> Picture:
    _check_header(data[:65536].tobytes())
    picture = cv2.imdecode(data, flag)
    if picture is None:
        raise BagError(msg("holds an image that cannot be decoded"))
    return np.asarray(picture)


_JPEG_FRAME = re.compile(rb"\xff[\xc0-\xc3\xc5-\xc7\xc9-\xcb\xcd-\xcf]..\x08(..)(..)", re.DOTALL)


def _check_header(start: bytes) -> None:
    """Refuse what is neither JPEG nor PNG, or is too large to be decoded."""
    if start.startswith(b"\x89PNG\r\n\x1a\n"):
        width, height = struct.unpack_from(">II", start, 16)
    elif start.startswith(b"\xff\xd8") and (found := _JPEG_FRAME.search(start)):
        height, width = (int.from_bytes(side, "big") for side in found.groups())
    else:
        raise BagError(msg("holds compressed images that are neither JPEG nor PNG"))
    if not 0 < width * height <= MOST_PIXELS:
        raise BagError(msg("holds an image of an impossible size"))


def choose_topics(
    topics: Sequence[Topic], named: Sequence[str], is_depth: Mapping[str, bool]
) -> tuple[str, str, str]:
    """The topics of the left camera, the right one and depth; "" where there is none.

    Args:
        topics: that hold images. named: what a manifest says of each; "": not told.
        is_depth: whether a topic's images are of depth, by its name.
    """
    names = {topic.name for topic in topics}
    for name in filter(None, named):
        if name not in names:
            known = ", ".join(sorted(names))[:400] or "none"
            raise BagError(
                msg("has no images on topic {name}, only on {known}", name=name[:200], known=known)
            )
    left, right, depth = named
    cameras = sorted((t for t in topics if not is_depth[t.name]), key=_rank)
    if not left:
        pair = _pair([topic.name for topic in cameras]) if not depth else None
        if pair is not None:
            return pair[0], pair[1], ""
        left = cameras[0].name if cameras else ""
    if not depth and not right:
        depth = next((t.name for t in sorted(topics, key=_rank) if is_depth[t.name]), "")
    return left, right, depth


def _rank(topic: Topic) -> tuple[int, bool, str]:
    """Most messages first, images as they are before compressed ones."""
    return -topic.count, topic.kind == COMPRESSED, topic.name


def _pair(names: Sequence[str]) -> tuple[str, str] | None:
    """Two topics whose names differ in the side alone, the likeliest pair."""
    there = set(names)
    for sides in (_SIDES, _SIDES_OF_NUMBERS):
        for name in names:
            for left, right in sides:
                for found in re.finditer(re.escape(left), name):
                    other = name[: found.start()] + right + name[found.end() :]
                    if other in there:
                        return name, other
    return None


def info_topic(image: str, infos: Sequence[Topic]) -> Topic | None:
    """The camera_info that stands nearest above an image topic."""
    parts = image.split("/")
    for length in range(len(parts) - 1, 0, -1):
        above = "/".join(parts[:length])
        for topic in infos:
            if topic.name.rpartition("/")[0] == above:
                return topic
    return None


def calibration_text(value: Any, image_topic: str) -> str:
    """camera_info in YAML, as ROS' camera_calibration writes it; of rectified images, theirs."""
    matrix, lens, turn, projection = (
        np.asarray(getattr(value, name, getattr(value, name.lower(), None)), float).ravel()
        for name in ("K", "D", "R", "P")
    )
    model = re.sub(r"[^a-z_]", "", str(value.distortion_model))
    if "rect" in image_topic.rpartition("/")[2] or "/image_rect" in image_topic:
        matrix = projection.reshape(3, 4)[:, :3].ravel()
        lens, turn, model = np.zeros(5), np.eye(3).ravel(), "plumb_bob"
    if not turn.any():
        turn = np.eye(3).ravel()
    if not projection.any():
        projection = np.column_stack((matrix.reshape(3, 3), np.zeros(3))).ravel()
    if not lens.size:
        lens = np.zeros(5)
    lines = [f"image_width: {int(value.width)}", f"image_height: {int(value.height)}"]
    lines.append(f"distortion_model: {model}")
    for name, numbers, shape in (
        ("camera_matrix", matrix, (3, 3)),
        ("distortion_coefficients", lens, (1, lens.size)),
        ("rectification_matrix", turn, (3, 3)),
        ("projection_matrix", projection, (3, 4)),
    ):
        listed = ", ".join(repr(float(number)) for number in numbers)
        lines += [f"{name}:", f"  rows: {shape[0]}", f"  cols: {shape[1]}", f"  data: [{listed}]"]
    return "\n".join(lines) + "\n"


def first_value(container: Container, messages: Messages, topic: Topic) -> Any:
    """The first message of a topic."""
    entries = container.entries(topic)
    if not len(entries.place):
        raise BagError(msg("holds no message of {topic}", topic=topic.name[:200]))
    return messages.value(topic, container.read(int(entries.part[0]), int(entries.place[0])))

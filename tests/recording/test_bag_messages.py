"""Images and depth in ROS messages."""

from __future__ import annotations

import struct
from typing import Any

import cv2
import numpy as np
import pytest
from rosbags.typesys import Stores, get_typestore

from tracking.recording.bags.container import (
    BagError,
    Topic,
)
from tracking.recording.bags.messages import COMPRESSED, Messages

DEPTH = Topic("/depth/compressedDepth", COMPRESSED, False, 1)


def message_of(told: str, picture: Any, scale: float = 0.0, offset: float = 0.0) -> bytes:
    store = get_typestore(Stores.ROS2_HUMBLE)
    stamp = store.types["builtin_interfaces/msg/Time"](sec=1, nanosec=0)
    header = store.types["std_msgs/msg/Header"](stamp=stamp, frame_id="camera")
    packed = struct.pack("<iff", 0, scale, offset) + cv2.imencode(".png", picture)[1].tobytes()
    data = np.frombuffer(packed, np.uint8)
    value = store.types[COMPRESSED](header=header, format=told, data=data)
    return bytes(store.serialize_cdr(value, COMPRESSED))


def test_compressed_depth_in_metres_is_depth() -> None:
    metres = np.linspace(0.5, 8.0, 48, dtype=np.float32).reshape(6, 8)
    scale, offset = 100.0 * 101.0, -1.0
    inverse = np.rint(scale / metres + offset).astype(np.uint16)
    inverse[0, 0] = 0
    found = Messages().picture(DEPTH, message_of("32FC1; compressedDepth", inverse, scale, offset))
    assert (found.shape, found.dtype) == (metres.shape, np.float32)
    assert np.isnan(found[0, 0])
    assert np.allclose(found.ravel()[1:], metres.ravel()[1:], rtol=1e-2)


def test_compressed_depth_in_units_is_depth() -> None:
    units = np.arange(48, dtype=np.uint16).reshape(6, 8)
    found = Messages().picture(DEPTH, message_of("16UC1; compressedDepth png", units))
    assert (found == units).all()


@pytest.mark.parametrize("told", ["32FC1; compressedDepth", "16UC1; compressedDepth"])
def test_compressed_depth_of_colours_is_refused(told: str) -> None:
    colours = np.zeros((6, 8, 3), np.uint8)
    with pytest.raises(BagError, match="not of 16 bits"):
        Messages().picture(DEPTH, message_of(told, colours))

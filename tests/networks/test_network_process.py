"""A network in a program of its own: batches, limits, and what damage does to it."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path

import numpy as np
import pytest
from onnx import TensorProto, helper, numpy_helper
from small_networks import SIZE, bright_rectangles, damaged, model, saying, written

from tracking.errors import FormatError
from tracking.networks.model_file import read_model
from tracking.networks.network_process import Limits, NetworkProcess

CHOSEN = np.array([[10, 8, 30, 48, 0.8, 0]] * 2, np.float32)
BRIGHT = {"decoder": "yolo", "classes": ["person"], "head": "v8"}


@pytest.fixture
def processes() -> Iterator[list[NetworkProcess]]:
    """Those to be ended."""
    held: list[NetworkProcess] = []
    yield held
    for process in held:
        process.close()


def picture(left: int, top: int, width: int = 20, height: int = 40) -> np.ndarray:
    """A bright rectangle on black."""
    drawn = np.zeros((2 * SIZE, 2 * SIZE, 3), np.uint8)
    drawn[top : top + height, left : left + width] = 255
    return drawn


@pytest.mark.parametrize("engine", ["opencv", "onnxruntime"])
def test_two_cameras_are_one_batch_with_the_boxes_of_each(
    tmp_path: Path, processes: list[NetworkProcess], engine: str
) -> None:
    read = model(tmp_path, bright_rectangles(10, 20), engine=engine, **BRIGHT)
    processes.append(NetworkProcess(read, 0.3, cameras=2))
    assert processes[0].batches
    left, right = processes[0].find([picture(32, 40), picture(64, 56)], 0.6)
    for boxes, place in ((left, (32, 40)), (right, (64, 56))):
        assert len(boxes) == 1
        assert boxes.box[0] == pytest.approx((*place, 20, 40), abs=9)


@pytest.mark.parametrize("engine", ["opencv", "onnxruntime"])
def test_a_network_for_one_picture_is_asked_twice(
    tmp_path: Path, processes: list[NetworkProcess], engine: str
) -> None:
    read = model(tmp_path, saying({"dets": CHOSEN}), decoder="boxes", engine=engine)
    processes.append(NetworkProcess(read, 0.65, cameras=2))
    assert not processes[0].batches
    found = processes[0].find([picture(0, 0), picture(0, 0)], 0.3)
    assert [len(boxes) for boxes in found] == [1, 1]


def test_a_network_that_mixes_the_pictures_of_a_batch_is_asked_twice(
    tmp_path: Path, processes: list[NetworkProcess]
) -> None:
    read = model(tmp_path, _mixing(), decoder="boxes")
    processes.append(NetworkProcess(read, 0.65, cameras=2))
    assert not processes[0].batches


def _mixing() -> bytes:
    """A network whose scores are of the mean of all pictures of a batch."""
    constants = [
        numpy_helper.from_array(CHOSEN[None], "boxes"),
        numpy_helper.from_array(np.array([[[0, 0, 0, 0, 0.1, 0]]], np.float32), "part"),
    ]
    nodes = [
        helper.make_node("ReduceMean", ["images"], ["all"], axes=[0, 2, 3], keepdims=1),
        helper.make_node("ReduceMean", ["images"], ["each"], axes=[1, 2, 3], keepdims=1),
        helper.make_node("Sub", ["each", "each"], ["nothing"]),
        helper.make_node("ReduceMean", ["all"], ["one"], axes=[1], keepdims=1),
        helper.make_node("Add", ["nothing", "one"], ["light4"]),
        helper.make_node("Squeeze", ["light4", "last"], ["light"]),
        helper.make_node("Mul", ["light", "part"], ["more"]),
        helper.make_node("Add", ["more", "boxes"], ["dets"]),
    ]
    constants.append(numpy_helper.from_array(np.array([3], np.int64), "last"))
    inputs = [helper.make_tensor_value_info("images", TensorProto.FLOAT, ["n", 3, SIZE, SIZE])]
    told = [helper.make_tensor_value_info("dets", TensorProto.FLOAT, ["n", 2, 6])]
    graph = helper.make_graph(nodes, "mixing", inputs, told, constants)
    opset = [helper.make_opsetid("", 13)]
    return bytes(helper.make_model(graph, opset_imports=opset, ir_version=8).SerializeToString())


def _loop(rounds: int) -> bytes:
    """A network that multiplies matrices for so many rounds, or grows by each."""
    body = helper.make_graph(
        [
            helper.make_node("Identity", ["more_in"], ["more_out"]),
            helper.make_node("MatMul", ["m_in", "m_in"], ["m_out"]),
        ],
        "body",
        [
            helper.make_tensor_value_info("round", TensorProto.INT64, []),
            helper.make_tensor_value_info("more_in", TensorProto.BOOL, []),
            helper.make_tensor_value_info("m_in", TensorProto.FLOAT, [256, 256]),
        ],
        [
            helper.make_tensor_value_info("more_out", TensorProto.BOOL, []),
            helper.make_tensor_value_info("m_out", TensorProto.FLOAT, [256, 256]),
        ],
    )
    constants = [
        numpy_helper.from_array(np.array(rounds, np.int64), "rounds"),
        numpy_helper.from_array(np.array(True), "go"),
        numpy_helper.from_array(np.zeros((256, 256), np.float32), "m"),
        numpy_helper.from_array(CHOSEN[None], "boxes"),
    ]
    nodes = [
        helper.make_node("ReduceMean", ["images"], ["light"], keepdims=0),
        helper.make_node("Add", ["m", "light"], ["m0"]),
        helper.make_node("Loop", ["rounds", "go", "m0"], ["m1"], body=body),
        helper.make_node("ReduceMax", ["m1"], ["most"], keepdims=0),
        helper.make_node("Sub", ["most", "most"], ["nothing"]),
        helper.make_node("Add", ["boxes", "nothing"], ["dets"]),
    ]
    inputs = [helper.make_tensor_value_info("images", TensorProto.FLOAT, [1, 3, SIZE, SIZE])]
    told = [helper.make_tensor_value_info("dets", TensorProto.FLOAT, [1, 2, 6])]
    graph = helper.make_graph(nodes, "loop", inputs, told, constants)
    opset = [helper.make_opsetid("", 13)]
    return bytes(helper.make_model(graph, opset_imports=opset, ir_version=8).SerializeToString())


def test_a_network_without_end_is_ended(tmp_path: Path) -> None:
    read = model(tmp_path, _loop(1 << 40), decoder="boxes", engine="onnxruntime")
    with pytest.raises(FormatError, match="took longer than 2 s") as refused:
        NetworkProcess(read, limits=Limits(start_s=2.0, frame_s=2.0))
    assert "\n" not in str(refused.value)


def _eats_memory() -> bytes:
    """A network that makes 8 GB of nothing in order to say its boxes."""
    constants = [
        numpy_helper.from_array(np.array([2048, 1024, 1024], np.int64), "huge"),
        numpy_helper.from_array(CHOSEN[None], "boxes"),
    ]
    nodes = [
        helper.make_node("ReduceMean", ["images"], ["light"], keepdims=0),
        helper.make_node("Expand", ["light", "huge"], ["much"]),
        helper.make_node("Exp", ["much"], ["more"]),
        helper.make_node("ReduceMean", ["more"], ["mean"], keepdims=0),
        helper.make_node("Sub", ["mean", "mean"], ["nothing"]),
        helper.make_node("Add", ["boxes", "nothing"], ["dets"]),
    ]
    inputs = [helper.make_tensor_value_info("images", TensorProto.FLOAT, [1, 3, SIZE, SIZE])]
    told = [helper.make_tensor_value_info("dets", TensorProto.FLOAT, [1, 2, 6])]
    graph = helper.make_graph(nodes, "memory", inputs, told, constants)
    opset = [helper.make_opsetid("", 13)]
    return bytes(helper.make_model(graph, opset_imports=opset, ir_version=8).SerializeToString())


@pytest.mark.parametrize("engine", ["opencv", "onnxruntime"])
def test_a_network_that_eats_memory_is_refused_in_one_line(tmp_path: Path, engine: str) -> None:
    read = model(tmp_path, _eats_memory(), decoder="boxes", engine=engine)
    with pytest.raises(FormatError, match=r"memory|alloc") as refused:
        NetworkProcess(read, limits=Limits(memory_bytes=2 << 30))
    assert "\n" not in str(refused.value)


def test_weights_in_another_file_are_not_read(tmp_path: Path) -> None:
    for engine in ("opencv", "onnxruntime"):
        path = written(tmp_path, _outside(tmp_path / "secret"), decoder="boxes", engine=engine)
        with pytest.raises(FormatError) as refused:
            NetworkProcess(read_model(path))
        assert "\n" not in str(refused.value)


def _outside(place: Path) -> bytes:
    """A network whose boxes are bytes of another file."""
    place.write_bytes(CHOSEN.tobytes())
    tensor = TensorProto(name="boxes", data_type=TensorProto.FLOAT, dims=[1, 2, 6])
    tensor.data_location = TensorProto.EXTERNAL
    tensor.external_data.add(key="location", value=str(place))
    nodes = [
        helper.make_node("ReduceMean", ["images"], ["light"], keepdims=0),
        helper.make_node("Sub", ["light", "light"], ["nothing"]),
        helper.make_node("Add", ["boxes", "nothing"], ["dets"]),
    ]
    inputs = [helper.make_tensor_value_info("images", TensorProto.FLOAT, [1, 3, SIZE, SIZE])]
    told = [helper.make_tensor_value_info("dets", TensorProto.FLOAT, [1, 2, 6])]
    graph = helper.make_graph(nodes, "outside", inputs, told, [tensor])
    opset = [helper.make_opsetid("", 13)]
    return bytes(helper.make_model(graph, opset_imports=opset, ir_version=8).SerializeToString())


@pytest.mark.slow
def test_damaged_networks_end_in_one_line_or_a_sound_answer(tmp_path: Path) -> None:
    for number in range(60):
        assert damaged(tmp_path, number) in ("refused", "answered")

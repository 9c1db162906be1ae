"""Small networks made by hand, whose outputs are known."""

from __future__ import annotations

import random
from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray
from onnx import TensorProto, helper, numpy_helper

from tracking.errors import FormatError
from tracking.networks.model_file import Model, read_model
from tracking.networks.network_process import Limits, NetworkProcess

SIZE = 64
_OPSET = 17


def saying(
    outputs: Mapping[str, NDArray[Any]],
    batch: int | str = 1,
    extra_inputs: Sequence[str] = (),
) -> bytes:
    """An ONNX that says the same of any picture: `outputs`, without the batch.

    With a batch by name it takes any number of pictures.
    """
    nodes, constants, told = [], [], []
    rows = batch if isinstance(batch, int) else -1
    nodes.append(helper.make_node("ReduceMean", ["images"], ["mean"], axes=[1, 2, 3], keepdims=1))
    constants.append(numpy_helper.from_array(np.zeros(1, np.float32), "zero"))
    nodes.append(helper.make_node("Mul", ["mean", "zero"], ["nothing4"]))
    for name, values in outputs.items():
        shape = np.array([rows] + [1] * values.ndim, np.int64)
        constants.append(numpy_helper.from_array(shape, f"s_{name}"))
        constants.append(numpy_helper.from_array(values[None], f"c_{name}"))
        kind = helper.np_dtype_to_tensor_dtype(values.dtype)
        nodes.append(helper.make_node("Reshape", ["nothing4", f"s_{name}"], [f"n_{name}"]))
        nodes.append(helper.make_node("Cast", [f"n_{name}"], [f"t_{name}"], to=kind))
        nodes.append(helper.make_node("Add", [f"t_{name}", f"c_{name}"], [name]))
        told.append(helper.make_tensor_value_info(name, kind, [batch, *values.shape]))
    inputs = [
        helper.make_tensor_value_info("images", TensorProto.FLOAT, [batch, 3, SIZE, SIZE]),
        *(helper.make_tensor_value_info(n, TensorProto.INT64, [batch, 2]) for n in extra_inputs),
    ]
    return _model(helper.make_graph(nodes, "said", inputs, told, constants))


def bright_rectangles(width: int, height: int, cell: int = 8) -> bytes:
    """An ONNX with head v8 and one class that finds bright rectangles of one size.

    The score of a cell is how bright the box about its middle is, above 0.5. Boxes have the size
    `width` x `height` px, in an input of any batch of SIZE x SIZE.
    """
    count = SIZE // cell
    window = (1, 3, height | 1, width | 1)
    pool = np.full(window, 1.0 / np.prod(window), np.float32)
    centres = (np.indices((count, count))[::-1].reshape(2, -1) + 0.5) * cell
    boxes = np.vstack((centres, np.full_like(centres, 0.0)))
    boxes[2], boxes[3] = width, height
    constants = [
        numpy_helper.from_array(pool, "pool"),
        numpy_helper.from_array(boxes[None].astype(np.float32), "boxes"),
        numpy_helper.from_array(np.array([-1, 1, count * count], np.int64), "flat"),
        numpy_helper.from_array(np.zeros(1, np.float32), "zero"),
        numpy_helper.from_array(np.array([2, 3], np.int64), "axes"),
        numpy_helper.from_array(np.array([cell // 2] * 2, np.int64), "starts"),
        numpy_helper.from_array(np.array([SIZE] * 2, np.int64), "ends"),
        numpy_helper.from_array(np.array([cell] * 2, np.int64), "steps"),
    ]
    pads = [(height | 1) // 2, (width | 1) // 2] * 2
    nodes = [
        helper.make_node("Conv", ["images", "pool"], ["light"], pads=pads),
        helper.make_node("Slice", ["light", "starts", "ends", "axes", "steps"], ["cells"]),
        helper.make_node("Reshape", ["cells", "flat"], ["scores"]),
        helper.make_node("Mul", ["scores", "zero"], ["nothing"]),
        helper.make_node("Add", ["nothing", "boxes"], ["places"]),
        helper.make_node("Concat", ["places", "scores"], ["output0"], axis=1),
    ]
    inputs = [helper.make_tensor_value_info("images", TensorProto.FLOAT, ["n", 3, SIZE, SIZE])]
    told = [helper.make_tensor_value_info("output0", TensorProto.FLOAT, ["n", 5, count * count])]
    return _model(helper.make_graph(nodes, "bright", inputs, told, constants))


def mean_colours(bands: int = 2, batch: int | str = "n") -> bytes:
    """An ONNX of an appearance network: the mean colours of bands of a crop, from top to bottom."""
    kernel = [SIZE // bands, SIZE]
    nodes = [
        helper.make_node("AveragePool", ["crops"], ["bands"], kernel_shape=kernel, strides=kernel),
        helper.make_node("Flatten", ["bands"], ["embedding"]),
    ]
    inputs = [helper.make_tensor_value_info("crops", TensorProto.FLOAT, [batch, 3, SIZE, SIZE])]
    told = [helper.make_tensor_value_info("embedding", TensorProto.FLOAT, [batch, 3 * bands])]
    return _model(helper.make_graph(nodes, "colours", inputs, told, []))


def _model(graph: Any) -> bytes:
    opset = [helper.make_opsetid("", _OPSET)]
    return bytes(helper.make_model(graph, opset_imports=opset, ir_version=8).SerializeToString())


def written(folder: Path, onnx: bytes, **keys: object) -> Path:
    """The TOML of a network in a folder, beside its ONNX."""
    folder.mkdir(exist_ok=True)
    (folder / "people.onnx").write_bytes(onnx)
    usual: dict[str, object] = {
        "name": "test network",
        "licence": "MIT",
        "classes": ["person", "dog"],
        "size": [SIZE, SIZE],
        **keys,
    }
    path = folder / "people.toml"
    path.write_text("".join(f"{key} = {_toml(value)}\n" for key, value in usual.items()))
    return path


def written_appearance(folder: Path, onnx: bytes, **keys: object) -> Path:
    """The TOML of an appearance network in a folder, beside its ONNX."""
    folder.mkdir(exist_ok=True)
    (folder / "who.onnx").write_bytes(onnx)
    usual: dict[str, object] = {
        "kind": "appearance",
        "name": "test colours",
        "licence": "MIT",
        "size": [SIZE, SIZE],
        "mean": [0.5, 0.5, 0.5],
        "std": [1.0, 1.0, 1.0],
        **keys,
    }
    path = folder / "who.toml"
    path.write_text("".join(f"{key} = {_toml(value)}\n" for key, value in usual.items()))
    return path


def model(folder: Path, onnx: bytes, **keys: object) -> Model:
    """The same, read."""
    return read_model(written(folder, onnx, **keys))


def _toml(value: object) -> str:
    if isinstance(value, bool):
        return str(value).lower()
    if isinstance(value, Mapping):
        return "{" + ", ".join(f"{k} = {_toml(v)}" for k, v in value.items()) + "}"
    if isinstance(value, list | tuple):
        return "[" + ", ".join(map(_toml, value)) + "]"
    return f'"{value}"' if isinstance(value, str) else repr(value)


LIMITS = Limits(memory_bytes=3 << 30, start_s=20.0, frame_s=20.0)


_APPEARANCE = 9
"""Every tenth damaged network, this one first, is an appearance network."""


def damaged(folder: Path, number: int) -> str:
    """What becomes of a network with a random damage: "refused" in one line, or "answered".

    Anything else is raised, or told as what it is.
    """
    chance = random.Random(number)
    engine = ("opencv", "onnxruntime")[number % 2]
    is_appearance = number % 10 == _APPEARANCE
    onnx = bytearray(mean_colours(8) if is_appearance else bright_rectangles(10, 20))
    if chance.random() < 0.25:
        del onnx[chance.randrange(len(onnx)) :]
    for _ in range(chance.choice((0, 1, 1, 2, 8))):
        if onnx:
            onnx[chance.randrange(len(onnx))] = chance.randrange(256)
    whole = np.full((80, 120, 3), 255, np.uint8)
    keys = {"decoder": "yolo", "classes": ["person"], "head": "v8", "engine": engine}
    process = None
    try:
        if is_appearance:
            path = written_appearance(folder, bytes(onnx), engine=engine)
            process = NetworkProcess(read_model(path), limits=LIMITS)
            found = process.embed([whole, whole[:40], whole[:, :50]])
            return "answered" if np.isfinite(found).all() else f"no embeddings: {found}"
        process = NetworkProcess(model(folder, bytes(onnx), **keys), limits=LIMITS)
        (boxes,) = process.find([whole], 0.3)
    except FormatError as refused:
        return "refused" if "\n" not in str(refused) else f"several lines: {refused!r}"
    finally:
        if process is not None:
            process.close()
    return "answered" if np.isfinite(boxes.box).all() else f"boxes that are none: {boxes.box}"

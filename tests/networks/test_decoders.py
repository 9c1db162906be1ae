"""What networks of each family say as boxes, run by either engine in the child process."""

from __future__ import annotations

from collections.abc import Mapping
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from numpy.typing import NDArray
from small_networks import SIZE, model, saying

from tracking.errors import FormatError
from tracking.networks.decoders import decode
from tracking.networks.network_process import NetworkProcess
from tracking.networks.network_spec import NetworkSpec

PICTURE = np.zeros((SIZE, SIZE, 3), np.uint8)
ENGINES = ("opencv", "onnxruntime")
BOX = (10.0, 8.0, 20.0, 40.0)
"""left, top, width, height px."""
CENTRE = (20.0, 28.0, 20.0, 40.0)
CORNERS = (10.0, 8.0, 30.0, 48.0)
SHARES = tuple(side / SIZE for side in CENTRE)
ROWS = 84
"""Cells of grids of 8, 16 and 32 px in the input."""


def _rows(*rows: tuple[float, ...], count: int = ROWS) -> NDArray[np.float32]:
    table = np.zeros((count, len(rows[0])), np.float32)
    table[: len(rows)] = rows
    return table


def found(
    folder: Path, told: Mapping[str, NDArray[Any]], **keys: object
) -> list[tuple[float, ...]]:
    """The boxes and scores in a black picture."""
    process = NetworkProcess(model(folder, saying(told), **keys), 0.65)
    try:
        (boxes,) = process.find([PICTURE], 0.3)
    finally:
        process.close()
    return [(*map(float, box), float(s)) for box, s in zip(boxes.box, boxes.score, strict=True)]


def assert_only_box(rows: list[tuple[float, ...]], score: float) -> None:
    """The box is the only one, with that score."""
    assert len(rows) == 1
    assert rows[0] == pytest.approx((*BOX, score), abs=1e-3)


@pytest.mark.parametrize("engine", ENGINES)
def test_yolox_from_steps_of_its_grids(tmp_path: Path, engine: str) -> None:
    rows = np.zeros((ROWS, 7), np.float32)
    at = 64 + 1 * 4 + 1  # of the grid of 16 px: row 1, column 1
    rows[at] = (20 / 16 - 1, 28 / 16 - 1, np.log(20 / 16), np.log(40 / 16), 0.9, 0.8, 0.1)
    rows[0] = (0, 0, 0, 0, 0.9, 0.1, 0.8)  # a dog
    assert_only_box(found(tmp_path, {"output": rows}, decoder="yolox", engine=engine), 0.72)


def test_yolox_that_has_decoded_its_boxes(tmp_path: Path) -> None:
    rows = _rows((*CENTRE, 0.9, 0.8, 0.1), count=10)
    assert_only_box(found(tmp_path, {"output": rows}, decoder="yolox", decoded=True), 0.72)


@pytest.mark.parametrize("engine", ENGINES)
def test_yolo_with_objectness_as_v5_has_it(tmp_path: Path, engine: str) -> None:
    rows = _rows((*CENTRE, 0.9, 0.8, 0.1), (*CENTRE, 0.8, 0.8, 0.1), (*CENTRE, 0.9, 0.1, 0.9))
    assert_only_box(found(tmp_path, {"output": rows}, decoder="yolo", engine=engine), 0.72)


@pytest.mark.parametrize("engine", ENGINES)
def test_yolo_in_columns_as_v8_has_it(tmp_path: Path, engine: str) -> None:
    rows = _rows((*CENTRE, 0.8, 0.1), (*CENTRE, 0.7, 0.1), (*CENTRE, 0.1, 0.9))
    columns = np.ascontiguousarray(rows.T)
    assert_only_box(found(tmp_path, {"output0": columns}, decoder="yolo", engine=engine), 0.8)


def test_yolo_that_has_chosen_its_boxes_as_v10_has_it(tmp_path: Path) -> None:
    rows = _rows((*CORNERS, 0.8, 0.0), (*CORNERS, 0.9, 1.0), count=300)
    assert_only_box(found(tmp_path, {"output0": rows}, decoder="yolo"), 0.8)


def test_a_head_that_may_be_two_has_to_be_named(tmp_path: Path) -> None:
    rows = _rows((*CORNERS, 0.8, 0.0), count=300)
    keys: dict[str, Any] = {"decoder": "yolo", "classes": ["person"]}
    with pytest.raises(FormatError, match="may be of head v10 or v5"):
        found(tmp_path, {"output0": rows}, **keys)
    assert_only_box(found(tmp_path, {"output0": rows}, head="v10", **keys), 0.8)


@pytest.mark.parametrize("engine", ENGINES)
def test_detr_with_sigmoid_or_softmax_by_the_number_of_its_logits(
    tmp_path: Path, engine: str
) -> None:
    boxes, keys = _rows(SHARES, SHARES), {"decoder": "detr", "engine": engine}
    sigmoid = np.full((ROWS, 2), -9.0, np.float32)
    sigmoid[:2] = (2.0, -2.0), (-2.0, 4.0)
    rows = found(tmp_path, {"logits": sigmoid, "pred_boxes": boxes}, **keys)
    assert_only_box(rows, 1 / (1 + np.exp(-2.0)))
    softmax = np.zeros((ROWS, 3), np.float32)
    softmax[:, 2], softmax[0] = 9.0, (3.0, 1.0, 0.0)
    rows = found(tmp_path, {"logits": softmax, "pred_boxes": boxes}, **keys)
    assert_only_box(rows, np.exp(3) / (np.exp(3) + np.exp(1) + 1))


def test_detr_in_one_output_with_scores(tmp_path: Path) -> None:
    rows = _rows((*SHARES, 0.8, 0.1), (*SHARES, 0.1, 0.8))
    assert_only_box(found(tmp_path, {"output0": rows}, decoder="detr"), 0.8)


@pytest.mark.parametrize(
    ("box", "keys"),
    [
        (CORNERS, {}),
        (CENTRE, {"sides": "centre"}),
        (BOX, {"sides": "sides"}),
        (SHARES, {"sides": "centre", "unit": "shares"}),
    ],
)
def test_plain_boxes_with_scores_and_labels(
    tmp_path: Path, box: tuple[float, ...], keys: dict[str, object]
) -> None:
    outputs = {
        "boxes": _rows(box, box),
        "scores": np.array([0.8, 0.9] + [0.0] * (ROWS - 2), np.float32),
        "labels": np.array([0, 1] + [0] * (ROWS - 2), np.int64),
    }
    assert_only_box(found(tmp_path, outputs, decoder="boxes", **keys), 0.8)


def test_plain_boxes_in_one_output(tmp_path: Path) -> None:
    rows = _rows((*CORNERS, 0.8, 0.0), (*CORNERS, 0.9, 1.0))
    assert_only_box(found(tmp_path, {"dets": rows}, decoder="boxes"), 0.8)


@pytest.mark.parametrize(
    ("outputs", "keys", "said"),
    [
        ({"output0": _rows((1.0,) * 9)}, {"decoder": "yolo"}, "none of its outputs fits"),
        ({"output0": _rows((1.0,) * 7, count=9)}, {"decoder": "yolox"}, "has other grids"),
        ({"a": _rows((*CORNERS, np.nan, 0.0))}, {"decoder": "boxes"}, "not a number"),
        ({"a": _rows((np.inf, 1.0, 2.0, 2.0, 0.9, 0.0))}, {"decoder": "boxes"}, "not finite"),
        ({"a": _rows((*CORNERS, 7.0, 0.0))}, {"decoder": "boxes"}, "above 1"),
        ({"a": _rows(CORNERS)}, {"decoder": "boxes"}, "none of its outputs fits"),
        ({"a": _rows((*CORNERS, 0.9))}, {"decoder": "boxes"}, "says no class"),
        ({"a": _rows(CORNERS)}, {"decoder": "boxes", "outputs": {"boxes": "b"}}, "no output b"),
        (
            {"boxes": _rows(SHARES), "logits": _rows((1.0, 1.0), count=9)},
            {"decoder": "detr"},
            "but scores of 9",
        ),
    ],
)
def test_outputs_that_are_no_boxes_are_refused_in_one_line(
    tmp_path: Path, outputs: dict[str, NDArray[Any]], keys: dict[str, Any], said: str
) -> None:
    with pytest.raises(FormatError, match=said) as refused:
        found(tmp_path, outputs, **keys)
    assert "\n" not in str(refused.value)
    assert str(refused.value).startswith(str(tmp_path))


def test_far_too_many_boxes_are_refused() -> None:
    many = np.broadcast_to(np.float32(0.5), (1, 20_000_000, 6))
    spec = NetworkSpec("boxes", (SIZE, SIZE), 1, (0,))
    with pytest.raises(FormatError, match="far more than any detector"):
        decode({"dets": many}, spec, 1)

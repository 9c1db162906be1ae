"""What networks say as boxes of people: a decoder for each family of heads.

A decoder takes the outputs of a batch and gives boxes (n, 4) as left, top, right, bottom px of the
input, with scores (n,), a pair for each picture. It raises FormatError, without a name of a file,
where the outputs are not those of its family.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from typing import Any

import numpy as np
from numpy.typing import NDArray

from tracking.errors import FormatError
from tracking.networks.network_spec import NetworkSpec

Array = NDArray[Any]
Found = tuple[Array, Array]
_YOLOX_STRIDES = ((8, 16, 32), (8, 16, 32, 64))
_MOST_VALUES = 50_000_000
"""In one output: twenty times those of the largest public networks."""
_END_TO_END = 6
"""Columns of boxes that a network has chosen by itself: corners, score, class."""


def decode(outputs: Mapping[str, Array], spec: NetworkSpec, count: int) -> list[Found]:
    """The people in each of `count` pictures, surer ones not before others.

    Raises FormatError.
    """
    if not outputs:
        raise FormatError("it has no output")
    for name, values in outputs.items():
        if values.size > _MOST_VALUES:
            raise FormatError(
                "output {name} has {size} values, far more than any detector",
                name=name[:100],
                size=values.size,
            )
    return _DECODERS[spec.decoder](outputs, spec, count)


def _yolox(outputs: Mapping[str, Array], spec: NetworkSpec, count: int) -> list[Found]:
    """Rows of centre, size, objectness and class scores; boxes as steps of a grid, or in px."""
    columns = 5 + spec.class_count
    rows = _rows(outputs, spec.boxes_output, count, lambda shape: shape[2] == columns, columns)
    if not spec.decoded:
        rows = _on_grid(rows, spec.size_px)
    return [(_from_centre(each[:, :4]), each[:, 4] * _people(each[:, 5:], spec)) for each in rows]


def _on_grid(rows: Array, size_px: tuple[int, int]) -> Array:
    """Centres and sizes in px, of rows whose boxes are steps from the cells of three or four grids.

    Source: [Ge2021], `decode_outputs` of its head.
    """
    for strides in _YOLOX_STRIDES:
        shapes = [(size_px[1] // stride, size_px[0] // stride) for stride in strides]
        if sum(high * wide for high, wide in shapes) == rows.shape[1]:
            break
    else:
        raise FormatError(
            "it has {rows} boxes, but an input of {width} x {height} px has other grids; is size "
            "right, or decoded = true?",
            rows=rows.shape[1],
            width=size_px[0],
            height=size_px[1],
        )
    cells = np.concatenate([np.indices(shape)[::-1].reshape(2, -1).T for shape in shapes])
    stride = np.repeat(strides, [high * wide for high, wide in shapes])[:, None]
    moved = rows.copy()
    moved[..., :2] = (rows[..., :2] + cells) * stride
    with np.errstate(over="ignore"):
        moved[..., 2:4] = np.exp(rows[..., 2:4]) * stride
    return moved


def _yolo(outputs: Mapping[str, Array], spec: NetworkSpec, count: int) -> list[Found]:
    """v5: as YOLOX in px; v8: columns of centre, size, class scores; v10: boxes it has chosen."""
    classes = spec.class_count
    fits: dict[str, Callable[[tuple[int, ...]], bool]] = {
        "v5": lambda shape: shape[2] == 5 + classes,
        "v8": lambda shape: shape[1] == 4 + classes,
        "v10": lambda shape: shape[2] == _END_TO_END,
    }
    wanted = {spec.head: fits[spec.head]} if spec.head else fits
    named = _named(outputs, spec.boxes_output)
    shapes = [_batched(values, 3, count) for values in named.values()]
    found = [
        (head, values)
        for values in shapes
        for head, fit in wanted.items()
        if values is not None and fit(values.shape)
    ]
    heads = {head for head, _ in found}
    if len(heads) > 1:
        raise FormatError(
            "its outputs may be of head {heads}; write head = ... in the TOML",
            heads=" or ".join(sorted(heads)),
        )
    if not found:
        raise _no_output(outputs, f"{classes} classes")
    head, rows = found[0]
    if head == "v5":
        return [
            (_from_centre(each[:, :4]), each[:, 4] * _people(each[:, 5:], spec)) for each in rows
        ]
    if head == "v8":
        return [(_from_centre(each[:4].T), _people(each[4:].T, spec)) for each in rows]
    return [(each[:, :4], _labelled(each[:, 4], each[:, 5], spec)) for each in rows]


def _detr(outputs: Mapping[str, Array], spec: NetworkSpec, count: int) -> list[Found]:
    """Boxes as shares of the picture, class logits beside them; both in one output of some."""
    classes = spec.class_count
    many = _rows(outputs, spec.boxes_output, count, lambda s: s[2] in (4, 4 + classes), 4)
    if many.shape[2] != 4:
        boxes, logits = many[..., :4], many[..., 4:]
        activation = spec.activation or "none"
    else:
        others = {
            name: v for name, v in outputs.items() if v.shape != many.shape or v.shape[-1] != 4
        }
        boxes = many
        fits = (classes, classes + 1)
        logits = _rows(
            others, spec.scores_output, count, lambda s: s[2] in fits, classes, everything=outputs
        )
        activation = spec.activation or ("sigmoid" if logits.shape[2] == classes else "softmax")
    if logits.shape[1] != boxes.shape[1]:
        raise FormatError(
            "it has {boxes} boxes, but scores of {scores}",
            boxes=boxes.shape[1],
            scores=logits.shape[1],
        )
    scores = _activated(logits, activation)[..., :classes]
    scale = np.tile(np.array(spec.size_px, np.float32), 2)
    return [
        (_from_centre(box * scale), _people(score, spec))
        for box, score in zip(boxes, scores, strict=True)
    ]


def _activated(logits: Array, activation: str) -> Array:
    if activation == "none":
        return logits
    with np.errstate(over="ignore", invalid="ignore"):  # what is no number is refused later
        if activation == "sigmoid":
            return np.asarray(1.0 / (1.0 + np.exp(-logits)))
        powers = np.exp(logits - logits.max(axis=2, keepdims=True))
        return np.asarray(powers / powers.sum(axis=2, keepdims=True))


def _boxes(outputs: Mapping[str, Array], spec: NetworkSpec, count: int) -> list[Found]:
    """Boxes, scores and classes: in one output, in two, or each in its own."""
    rows = _rows(outputs, spec.boxes_output, count, lambda shape: shape[2] in (4, 5, 6), 4)
    columns, shape = rows.shape[2], rows.shape[:2]
    lists = {
        name: flat
        for name, values in outputs.items()
        if (flat := _listed(values, count, shape)) is not None
    }
    score = rows[..., 4] if columns > 4 else _list_of(lists, spec.scores_output, "f", outputs)
    if columns > 5:
        label: Array | None = rows[..., 5]
    elif lists and (spec.labels_output or any(v.dtype.kind in "iu" for v in lists.values())):
        label = _list_of(lists, spec.labels_output, "iu", outputs)
    else:
        label = None
    if label is None and spec.class_count > 1:
        raise FormatError("it says no class of its boxes; name one class, or the output of labels")
    scale = np.tile(np.array(spec.size_px, np.float32), 2) if spec.unit == "shares" else 1.0
    corners = _CORNERS[spec.sides]
    return [
        (
            corners(rows[at, :, :4] * scale),
            score[at] if label is None else _labelled(score[at], label[at], spec),
        )
        for at in range(count)
    ]


def _listed(values: Array, count: int, shape: tuple[int, ...]) -> Array | None:
    """(count, rows) of an output with one value for each box; None: it has none."""
    if values.shape in (shape, (*shape, 1)) or (count == 1 and values.shape == shape[1:]):
        return values.reshape(shape)
    return None


def _list_of(
    lists: Mapping[str, Array], name: str, kinds: str, outputs: Mapping[str, Array]
) -> Array:
    """The only one of these outputs that has a name or, without one, numbers of these kinds."""
    found = [
        values
        for each, values in lists.items()
        if (each == name if name else values.dtype.kind in kinds)
    ]
    if len(found) != 1:
        raise _no_output(outputs, "scores" if kinds == "f" else "labels")
    return found[0]


def _from_centre(boxes: Array) -> Array:
    """Corners of boxes (n, 4) as centre and size."""
    half = boxes[:, 2:] / 2
    return np.concatenate((boxes[:, :2] - half, boxes[:, :2] + half), axis=1)


def _from_sides(boxes: Array) -> Array:
    """Corners of boxes (n, 4) as left, top, width, height."""
    return np.concatenate((boxes[:, :2], boxes[:, :2] + boxes[:, 2:]), axis=1)


_CORNERS: Mapping[str, Callable[[Array], Array]] = {
    "corners": lambda boxes: boxes,
    "centre": _from_centre,
    "sides": _from_sides,
}


def _people(scores: Array, spec: NetworkSpec) -> Array:
    """(n,) the score of people where no other class has a higher one, else 0.

    scores: (n, classes). What is no number stays none.
    """
    best = scores.argmax(axis=1)  # of rows with NaN: the place of the first
    score = np.take_along_axis(scores, best[:, None], 1)[:, 0]
    return np.asarray(np.where(np.isin(best, spec.people) | np.isnan(score), score, 0.0))


def _labelled(score: Array, label: Array, spec: NetworkSpec) -> Array:
    """(n,) the scores of boxes whose label is one of people, else 0."""
    return np.asarray(np.where(np.isin(label, spec.people) | np.isnan(score), score, 0.0))


def _named(outputs: Mapping[str, Array], name: str) -> Mapping[str, Array]:
    """All outputs, or the one with that name."""
    if not name:
        return outputs
    if name not in outputs:
        raise FormatError(
            "it has no output {name}; there are {names}",
            name=name,
            names=", ".join(each[:40] for each in list(outputs)[:8]),
        )
    return {name: outputs[name]}


def _batched(values: Array, dimensions: int, count: int) -> Array | None:
    """An output of so many dimensions for `count` pictures; of one it may lack the first."""
    if count == 1 and values.ndim == dimensions - 1:
        values = values[None]
    if values.ndim != dimensions or values.shape[0] != count or values.dtype.kind not in "fiu":
        return None
    return values.astype(np.float32, copy=False)


def _rows(
    outputs: Mapping[str, Array],
    name: str,
    count: int,
    fits: Callable[[tuple[int, ...]], bool],
    columns: int,
    everything: Mapping[str, Array] | None = None,
) -> Array:
    """(count, rows, columns) the output of that name, or the first one with a shape that fits."""
    for values in _named(outputs, name).values():
        rows = _batched(values, 3, count)
        if rows is not None and fits(rows.shape):
            return rows
    raise _no_output(everything or outputs, f"{columns} columns")


def _no_output(outputs: Mapping[str, Array], wanted: str) -> FormatError:
    shapes: Sequence[str] = [
        f"{name[:40]} {' x '.join(map(str, values.shape))}"
        for name, values in list(outputs.items())[:6]
    ]
    return FormatError(
        "none of its outputs fits the decoder with {wanted}: {shapes}; are decoder and classes "
        "right?",
        wanted=wanted,
        shapes=", ".join(shapes),
    )


_DECODERS: Mapping[str, Callable[[Mapping[str, Array], NetworkSpec, int], list[Found]]] = {
    "yolox": _yolox,
    "yolo": _yolo,
    "detr": _detr,
    "boxes": _boxes,
}

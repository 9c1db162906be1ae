"""What an appearance network says of crops of people: one embedding each, of unit length."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from typing import Any

import numpy as np
from numpy.typing import NDArray

from tracking.errors import FormatError
from tracking.networks.letterbox import Picture, network_input
from tracking.networks.network_spec import NetworkSpec

Batch = NDArray[np.float32]
Run = Callable[[Batch], Mapping[str, NDArray[Any]]]

LENGTHS = (2, 4096)
"""Numbers of an embedding; public networks have 128 to 2048."""
_MOST_AT_ONCE = 16
"""Crops of a batch: more are no faster."""
_TRIED = (2, 3)
"""Sizes of batches that are tried: a network may be made for one size alone."""
_DIFFER = 1e-3
"""How far the embeddings of a crop alone and of one in a batch may be apart."""


class Embedder:
    """Describes crops of people, where it can many at once.

    Args:
        run: gives the outputs of a batch by name. noise: to try it out with.

    Attributes:
        batches: whether crops in a batch get what each of them gets alone.

    Raises FormatError where what the network says is no embedding.
    """

    def __init__(self, run: Run, spec: NetworkSpec, noise: np.random.Generator) -> None:
        self._run, self._spec = run, spec
        width, height = spec.size_px
        tried = noise.random((max(_TRIED), 3, height, width), np.float32)
        alone = np.concatenate([self._described(each[None]) for each in tried])
        self.batches = all(self._is_same(tried[:count], alone[:count]) for count in _TRIED)

    def embed(self, crops: Sequence[Picture]) -> NDArray[np.float32]:
        """(n, d) embeddings of n crops, at least one; see `network_input`."""
        step = _MOST_AT_ONCE if self.batches else 1
        parts = [crops[at : at + step] for at in range(0, len(crops), step)]
        return np.concatenate(
            [self._described(network_input(part, self._spec)[0]) for part in parts]
        )

    def _is_same(self, batch: Batch, alone: NDArray[np.float32]) -> bool:
        try:
            together = self._described(batch)
        except FormatError:
            return False
        if together.shape != alone.shape:
            return False
        return bool(np.abs(together - alone).max() <= _DIFFER)

    def _described(self, batch: Batch) -> NDArray[np.float32]:
        return embeddings_of(self._run(batch), self._spec, len(batch))


def embeddings_of(
    outputs: Mapping[str, NDArray[Any]], spec: NetworkSpec, count: int
) -> NDArray[np.float32]:
    """(count, d) embeddings of unit length in the outputs of a batch.

    Raises FormatError where none of them, or more than one, is of that shape, or an embedding has
    no direction.
    """
    named = spec.embedding_output
    fitting = {
        name: values.reshape(count, -1)
        for name, values in outputs.items()
        if name == (named or name) and _fits(values, count)
    }
    if len(fitting) != 1:
        shapes = ", ".join(
            f"{name[:40]} {' x '.join(map(str, values.shape))}"
            for name, values in list(outputs.items())[:6]
        )
        raise FormatError(
            "{count} of its outputs may be an embedding: {shapes}; name the one in outputs",
            count=len(fitting),
            shapes=shapes,
        )
    (values,) = fitting.values()
    values = values.astype(np.float64)
    with np.errstate(over="ignore", invalid="ignore"):
        length = np.linalg.norm(values, axis=1, keepdims=True)
    if not (np.isfinite(length) & (length > 0)).all():
        raise FormatError("an embedding has no direction: it is zero or not finite")
    return np.asarray(values / length, np.float32)


def _fits(values: NDArray[Any], count: int) -> bool:
    """Whether it has one row of numbers for each crop; sides of length 1 count for nothing."""
    if values.ndim < 2 or values.shape[0] != count or values.dtype.kind != "f":
        return False
    length = values.size // count
    return LENGTHS[0] <= length <= LENGTHS[1] and max(values.shape[1:]) == length

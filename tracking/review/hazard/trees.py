"""A sum of small decision trees, as plain columns that are read from a text file."""

from __future__ import annotations

import json
from dataclasses import asdict, dataclass
from functools import cache
from importlib.resources import files
from typing import Any

import numpy as np
from numpy.typing import NDArray

from tracking.arrays import Floats
from tracking.review.hazard.features import FEATURES


@dataclass(frozen=True, slots=True)
class Trees:
    """Decision trees whose leaves' values are added up to log odds.

    A node is a list of five: the number of its feature (-1: a leaf), the threshold (of a leaf its
    value), the nodes for values up to the threshold and above it, and that for NaN.

    Attributes:
        features: names, in the order of the columns. base: log odds before any tree.
        trees: of each the nodes, the first its root.
    """

    features: tuple[str, ...]
    base: float
    trees: tuple[tuple[tuple[float, ...], ...], ...]

    def log_odds(self, values: NDArray[np.float32]) -> Floats:
        """(n,) of rows (n, features)."""
        total = np.full(len(values), self.base)
        for tree in self.trees:
            total += _judged(tree, values)
        return total

    def as_text(self) -> str:
        """JSON, a tree a line."""
        columns: dict[str, Any] = asdict(self)
        trees = ",\n".join(json.dumps(tree) for tree in columns.pop("trees"))
        return f'{json.dumps(columns)[:-1]}, "trees": [\n{trees}\n]}}\n'

    @classmethod
    def from_text(cls, text: str) -> Trees:
        """What `as_text` wrote."""
        stored = json.loads(text)
        trees = tuple(tuple(tuple(node) for node in tree) for tree in stored["trees"])
        return cls(tuple(stored["features"]), stored["base"], trees)


@cache
def built_in_trees() -> Trees:
    """Those fitted to rendered scenes: `python -m tests.benchmarks.review --fit`."""
    found = Trees.from_text((files("resources") / "review" / "hazard.json").read_text("utf-8"))
    assert found.features == FEATURES
    return found


def _judged(
    tree: tuple[tuple[float, ...], ...], values: NDArray[np.float32], node: int = 0
) -> NDArray[np.float32] | float:
    """(n,) the value of the leaf each row comes to from a node on."""
    feature, threshold, low, high, unknown = tree[node]
    if feature < 0:
        return threshold
    column = values[:, int(feature)]
    to_low = column <= np.float32(threshold)
    if unknown == low:
        to_low |= np.isnan(column)
    below, above = (_judged(tree, values, int(branch)) for branch in (low, high))
    return np.where(to_low, np.float32(below), np.float32(above))

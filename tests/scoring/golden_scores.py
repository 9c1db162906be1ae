"""Sequences with other scorers' figures, kept under `tests/golden/scoring`."""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any

import numpy as np

from tracking.scoring import BoxMatch, FloorMatch, Match, ScoringTable

KEPT = Path(__file__).parents[1] / "golden" / "scoring"
WAYS: dict[str, Match] = {"box": BoxMatch(), "floor": FloorMatch(0.5)}

_COLUMNS = ("frame", "track", "left", "top", "width", "height", "x", "y", "confidence")


def golden_sequences() -> dict[str, tuple[ScoringTable, ScoringTable]]:
    """Truth and result by the sequences' names, in the order the peers combined them."""
    kept: dict[str, Any] = _read("sequences.json")
    return {
        name: (_table(truth, True), _table(result, False)) for name, (truth, result) in kept.items()
    }


def golden_figures(peer: str) -> Any:
    """The figures of "trackeval" or "py-motmetrics" by way of matching, sequence and name."""
    return _read(f"{peer}.json")


def _read(name: str) -> Any:
    return json.loads((KEPT / name).read_text(encoding="utf-8"))


def _table(rows: list[list[float]], dont_cares: bool) -> ScoringTable:
    values = np.array(rows, np.float64).reshape(-1, len(_COLUMNS)).T
    columns = dict(zip(_COLUMNS, values, strict=True))
    for name in ("frame", "track"):
        columns[name] = columns[name].astype(np.int32)
    return ScoringTable.from_columns(columns, dont_cares=dont_cares)

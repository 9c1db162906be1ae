"""How far apart the figures of two scorers are."""

from __future__ import annotations

import math

Figure = float | list[float]
Figures = dict[str, Figure]
"""By the peer's names; curves are lists; None in what peers say is undefined."""

COUNTS = frozenset(
    [f"CLEAR.{name}" for name in ("CLR_TP", "CLR_FN", "CLR_FP", "IDSW", "MT", "PT", "ML", "Frag")]
    + ["CLEAR.CLR_Frames", "Identity.IDTP", "Identity.IDFN", "Identity.IDFP"]
    + ["HOTA.HOTA_TP", "HOTA.HOTA_FN", "HOTA.HOTA_FP"]
    + ["Count.Dets", "Count.GT_Dets", "Count.IDs", "Count.GT_IDs"]
    + ["num_objects", "num_predictions", "num_unique_objects", "num_matches", "num_switches"]
    + ["num_detections", "num_false_positives", "num_misses", "num_fragmentations"]
    + ["mostly_tracked", "partially_tracked", "mostly_lost", "idtp", "idfp", "idfn"]
)
"""Whole numbers: they must be the same; everything else within 1e-9."""


def differences(ours: Figures, theirs: Figures) -> dict[str, float]:
    """How far each figure of theirs is from ours; what we do not have is as far as can be."""
    return {name: _apart(ours.get(name, math.inf), value) for name, value in theirs.items()}


def _apart(ours: Figure, theirs: Figure | None) -> float:
    if isinstance(ours, list) and isinstance(theirs, list):
        if len(ours) != len(theirs):
            return math.inf
        return max((_apart(a, b) for a, b in zip(ours, theirs, strict=True)), default=0.0)
    if isinstance(ours, list) or isinstance(theirs, list):
        return math.inf
    if theirs is None or not math.isfinite(ours):
        return 0.0 if theirs is None and not math.isfinite(ours) else math.inf
    return abs(ours - theirs)

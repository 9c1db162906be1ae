"""Scores of several recordings as one."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import fields

import numpy as np

from tracking.errors import SettingsError
from tracking.scoring.clear import Clear
from tracking.scoring.hota import combined_hota
from tracking.scoring.identity import Identity
from tracking.scoring.papers import People, PositionError
from tracking.scoring.passages import combined_passages
from tracking.scoring.score import Score
from tracking.scoring.track_map import combined_track_map

_NOT_SUMMED = ("one_sided", "conventions", "unit")


def combined(scores: Sequence[Score]) -> Score:
    """The score over several recordings, as TrackEval's COMBINED_SEQ.

    Counts are added up and shares follow from the sums; association and LocA are weighted with
    the matches at each alpha; people of different recordings are different people. Frames of a
    recording in which a side is empty do not count for `false_positives_per_frame`, as there.

    Args:
        scores: at least one; all measured the same way.

    Raises:
        SettingsError: none, or some were measured by other conventions.
    """
    if not scores:
        raise SettingsError("there is no score to combine; name at least one recording")
    maps = [one.track_map for one in scores if one.track_map is not None]
    return Score(
        frames=sum(one.frames for one in scores),
        truth_people=sum(one.truth_people for one in scores),
        result_tracks=sum(one.result_tracks for one in scores),
        clear=_clear([one.clear for one in scores]),
        identity=Identity(
            sum(one.identity.true_positives for one in scores),
            sum(one.identity.misses for one in scores),
            sum(one.identity.false_positives for one in scores),
        ),
        hota=combined_hota([one.hota for one in scores]),
        people=People(
            sum(one.people.detected for one in scores), sum(one.people.kept for one in scores)
        ),
        position_error=PositionError(
            np.concatenate([one.position_error.distances_m for one in scores])
        ),
        track_map=combined_track_map(maps) if len(maps) == len(scores) else None,
        passages=combined_passages([one.passages for one in scores]),
    )


def _clear(parts: list[Clear]) -> Clear:
    first = parts[0]
    if any((one.conventions, one.unit) != (first.conventions, first.unit) for one in parts):
        raise SettingsError("scores of different conventions cannot be combined; use one for all")
    summed = [field.name for field in fields(Clear) if field.name not in _NOT_SUMMED]
    sums = {name: sum(getattr(one, name) for one in parts) for name in summed}
    return Clear(**sums, conventions=first.conventions, unit=first.unit)

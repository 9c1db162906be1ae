"""What a tracker of a plug-in gives, checked before anything is kept of it."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import fields
from typing import Any, Final

import numpy as np
from numpy.typing import NDArray

from tracking.errors import EditError, PluginError
from tracking.people.detections import Detections
from tracking.people.observation import Observation
from tracking.plugins import Offer
from tracking.plugins.blame import accused
from tracking.trackers.shared.protocol import ASSOCIATION_COLUMNS, StepResult
from tracking.tracks import (
    DETECTION_COLUMNS,
    EMBEDDING_COLUMNS,
    NETWORK_BOX_COLUMNS,
    PART_COLUMNS,
    PART_PARTICLE_COLUMNS,
    PARTICLE_COLUMNS,
    SIGNAL_COLUMNS,
    TRACK_COLUMNS,
    TRACKLET_COLUMNS,
    Columns,
    check_tracks,
    checked_columns,
)
from tracking.tracks.columns import SIDES, Types
from tracking.translation import msg

_TABLES: Final[Mapping[str, Types]] = {
    "tracks": TRACK_COLUMNS,
    "detections": DETECTION_COLUMNS,
    "particles": PARTICLE_COLUMNS,
    "associations": ASSOCIATION_COLUMNS,
    "signals": SIGNAL_COLUMNS,
    "parts": PART_COLUMNS,
    "part_particles": PART_PARTICLE_COLUMNS,
    "tracklets": TRACKLET_COLUMNS,
    "network_boxes": NETWORK_BOX_COLUMNS,
    "embeddings": EMBEDDING_COLUMNS,
}
_SHARES: Final = ("confidence", "visibility")
_MAY_BE_UNKNOWN: Final = ("x", "y", "z", "vx", "vy")
_MOST: Final = 1e6
"""Pixels and metres beyond it are of no picture and no floor."""


def checked_step(result: object, frame: int, offer: Offer) -> StepResult:
    """A step with its tables in the right types.

    Raises PluginError that names the plug-in, the frame, the table and what is wrong with it.
    """
    if not isinstance(result, StepResult):
        raise accused(
            offer, "frame {frame}: step gave {found}, and should give a StepResult",
            frame=frame, found=type(result).__name__,
        )  # fmt: skip
    if result.frame != frame:
        raise accused(
            offer, "frame {frame}: its result says that it is of frame {found}",
            frame=frame, found=result.frame,
        )  # fmt: skip
    try:
        tables = {
            name: _checked(getattr(result, name), name, types, frame)
            for name, types in _TABLES.items()
        }
        check_tracks(tables["tracks"], "tracks")
        _check_values(tables)
    except EditError as error:
        raise accused(offer, "frame {frame}: {error}", frame=frame, error=error) from error
    except (TypeError, ValueError, AttributeError, OverflowError) as error:
        raise _no_table(offer, frame, error) from error
    return StepResult(frame, **tables)


def _no_table(offer: Offer, frame: int, error: Exception) -> PluginError:
    return accused(
        offer, "frame {frame}: its result is no table of numbers ({error})",
        frame=frame, error=str(error).partition("\n")[0],
    )  # fmt: skip


def _checked(columns: Columns, name: str, types: Types, frame: int) -> Mapping[str, NDArray[Any]]:
    checked = checked_columns(columns, types, name)
    if "frame" in types and np.any(checked["frame"] != frame):
        raise EditError("{table}: has rows of other frames", table=name)
    return checked


def _check_values(tables: Mapping[str, Mapping[str, NDArray[Any]]]) -> None:
    """Numbers that a run must not hold. Raises EditError."""
    for name in ("tracks", "detections"):
        for column in SIDES:
            _require(tables[name][column], name, column, known=True)
        for column in _MAY_BE_UNKNOWN:
            if column in tables[name]:
                _require(tables[name][column], name, column, known=False)
        if np.any(tables[name]["width"] < 0) or np.any(tables[name]["height"] < 0):
            raise EditError("{table}: a box has a negative width or height", table=name)
    for column in _SHARES:
        values = tables["tracks"][column]
        if not bool(np.all((values >= 0) & (values <= 1))):
            raise EditError("tracks: {column} must be 0 to 1", column=column)
    for column in ("x", "y", "weight"):
        _require(tables["particles"][column], "particles", column, known=True)
    signals, tracks = tables["signals"]["track"], tables["tracks"]["track"]
    if len(signals) and not np.array_equal(signals, tracks):
        raise EditError("signals: needs one row for each row of tracks, or none at all")


def _require(values: NDArray[Any], table: str, column: str, *, known: bool) -> None:
    right = np.abs(values) <= _MOST
    if not known:
        right |= np.isnan(values)
    if not bool(np.all(right)):
        raise EditError(
            "{table}: column {column} holds {value}",
            table=table,
            column=column,
            value=float(values[np.argmin(right)]),
        )


def checked_observation(observed: object, frame: int, offer: Offer) -> Observation:
    """What perception gave. Raises PluginError that names the plug-in and what is wrong."""
    if not isinstance(observed, Observation):
        raise accused(
            offer, "frame {frame}: observe gave {found}, and should give an Observation",
            frame=frame, found=type(observed).__name__,
        )  # fmt: skip
    if observed.frame != frame:
        raise accused(
            offer, "frame {frame}: its observation says that it is of frame {found}",
            frame=frame, found=observed.frame,
        )  # fmt: skip
    for problem in _problems(observed.people):
        raise accused(offer, "frame {frame}: {problem}", frame=frame, problem=problem)
    return observed


def _problems(people: Detections) -> Iterator[str]:
    lengths = {
        one.name: len(getattr(people, one.name)) for one in fields(people) if one.name != "regions"
    }
    if len(set(lengths.values())) > 1:
        yield msg("people have {lengths} rows", lengths=lengths)
    elif people.box.shape != (len(people), 4):
        yield msg("boxes have shape {shape}", shape=people.box.shape)
    elif not bool(np.isfinite(people.box).all()):
        yield msg("a box of people is no number")

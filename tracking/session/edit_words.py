"""What stands on one side of an edit, in a line that people read."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping, Sequence

import numpy as np

from tracking.editing import LabelState, State
from tracking.editing.core.scope import scope_text, tracks_text
from tracking.editing.labels.part_labels import SAID_OF_PART
from tracking.tracks import PART_NAMES, Columns, Occluder, PartLabel, Region, TrackLabel

NOTHING = "nothing"
"""What an edit that only adds says of before."""
_MOST_NAMED = 4


def in_words(side: State, other: State) -> str:
    """One side of an edit; of labels of tracks only what the other side says otherwise."""
    groups: list[Iterable[str]] = [
        (f"track {track} {_within(start, end)}" for track, start, end in side.stretches.tolist()),
        _rows(side.rows),
        _track_labels(side.labels.tracks, other.labels.tracks),
        *_other_labels(side.labels),
    ]
    return "; ".join(text for group in groups for text in _few(list(group))) or NOTHING


def _within(start: int, end: int) -> str:
    """The frames of a stretch: what the edit reaches, which a track may end or begin inside."""
    return scope_text(start, end).replace("in frames", "within frames", 1)


def _rows(rows: Columns) -> Iterator[str]:
    """How many rows of each track, and where; where one alone is, its box and place too."""
    if len(rows["frame"]) == 1:
        yield _single(rows)
        return
    for track in np.unique(rows["track"]).tolist():
        frames = rows["frame"][rows["track"] == track]
        count = "1 box" if len(frames) == 1 else f"{len(frames)} boxes"
        yield f"track {track}: {count} {scope_text(int(frames.min()), int(frames.max()) + 1)}"


def _single(rows: Columns) -> str:
    numbers = [float(rows[name][0]) for name in ("left", "top", "width", "height")]
    left, top, width, height = (f"{number:.1f}" for number in numbers)
    text = f"track {rows['track'][0]}: box {width} x {height} px at {left}, {top}"
    if np.isfinite(rows["x"][0]) and np.isfinite(rows["y"][0]):
        text += f", on the floor at {rows['x'][0]:.2f}, {rows['y'][0]:.2f} m"
    return f"{text} in frame {rows['frame'][0]}"


def _track_labels(own: Mapping[int, TrackLabel], other: Mapping[int, TrackLabel]) -> Iterator[str]:
    for track, label in own.items():
        fields = _differing(label, other.get(track, TrackLabel()))
        if fields:
            yield f"track {track}: {', '.join(fields)}"


def _differing(own: TrackLabel, other: TrackLabel) -> list[str]:
    """The fields of a label in words that the other label says otherwise."""
    said = []
    if own.name != other.name:
        said.append(f"name {own.name}" if own.name else "no name")
    for key in sorted({*own.attributes, *other.attributes}):
        value = own.attributes.get(key)
        if value != other.attributes.get(key):
            said.append(f"no {key}" if value is None else f"{key} = {value}")
    if own.notes != other.notes:
        said.append(f"notes {' '.join(own.notes.split())}" if own.notes else "no notes")
    return said


def _other_labels(labels: LabelState) -> Iterator[Iterable[str]]:
    yield (
        f"{f'track {seen.track}' if seen.track else 'everybody'} reviewed "
        f"{scope_text(seen.start, seen.end)}"
        for seen in labels.reviewed
    )
    yield (
        f"{said.kind} of {tracks_text(said.tracks) if said.tracks else 'nobody'} "
        f"in frame {said.frame}: "
        f"{said.decision}"
        for said in labels.verdicts
    )
    yield (_drawn("occluder", one) for one in labels.occluders)
    yield (f"counting line {line.name}" for line in labels.lines)
    yield (_drawn("region", one) for one in labels.regions)
    yield (_part(label) for label in labels.parts)


def _drawn(what: str, one: Occluder | Region) -> str:
    return f"{what} {one.name} with {len(one.polygon)} corners"


def _part(label: PartLabel) -> str:
    who = f"{PART_NAMES[label.part]} of {label.track} in frame {label.frame}"
    return f"{who}: {SAID_OF_PART[label.on_part]}"


def _few(words: Sequence[str]) -> Sequence[str]:
    if len(words) <= _MOST_NAMED:
        return words
    return [*words[:_MOST_NAMED], f"{len(words) - _MOST_NAMED} more"]

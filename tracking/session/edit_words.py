"""What stands on one side of an edit, in a line that people read."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping, Sequence

import numpy as np

from tracking.editing import LabelState, State
from tracking.editing.core.scope import scope_text, tracks_text
from tracking.editing.labels.part_labels import SAID_OF_PART
from tracking.tracks import PART_NAMES, Columns, Occluder, PartLabel, Region, TrackLabel
from tracking.translation import count_msg, joined, msg, some_of

NOTHING = msg("nothing")
"""What an edit that only adds says of before."""
_MOST_NAMED = 4


def in_words(side: State, other: State) -> str:
    """One side of an edit; of labels of tracks only what the other side says otherwise."""
    groups: list[Iterable[str]] = [
        (
            msg("track {track} {within}", track=track, within=_within(start, end))
            for track, start, end in side.stretches.tolist()
        ),
        _rows(side.rows),
        _track_labels(side.labels.tracks, other.labels.tracks),
        *_other_labels(side.labels),
    ]
    return joined("; ", (text for group in groups for text in _few(list(group)))) or NOTHING


def _within(start: int, end: int) -> str:
    """The frames of a stretch: what the edit reaches, which a track may end or begin inside."""
    if end == start + 1:
        return scope_text(start, end)
    return msg("within frames {start} to {last}", start=start, last=end - 1)


def _rows(rows: Columns) -> Iterator[str]:
    """How many rows of each track, and where; where one alone is, its box and place too."""
    if len(rows["frame"]) == 1:
        yield _single(rows)
        return
    for track in np.unique(rows["track"]).tolist():
        frames = rows["frame"][rows["track"] == track]
        yield count_msg(
            len(frames),
            "track {track}: {n} box {where}",
            "track {track}: {n} boxes {where}",
            track=track,
            where=scope_text(int(frames.min()), int(frames.max()) + 1),
        )


def _single(rows: Columns) -> str:
    numbers = [float(rows[name][0]) for name in ("left", "top", "width", "height")]
    left, top, width, height = (f"{number:.1f}" for number in numbers)
    text = msg(
        "track {track}: box {width} x {height} px at {left}, {top}",
        track=rows["track"][0],
        width=width,
        height=height,
        left=left,
        top=top,
    )
    if np.isfinite(rows["x"][0]) and np.isfinite(rows["y"][0]):
        text += msg(", on the floor at {x:.2f}, {y:.2f} m", x=rows["x"][0], y=rows["y"][0])
    return msg("{text} in frame {frame}", text=text, frame=rows["frame"][0])


def _track_labels(own: Mapping[int, TrackLabel], other: Mapping[int, TrackLabel]) -> Iterator[str]:
    for track, label in own.items():
        fields = _differing(label, other.get(track, TrackLabel()))
        if fields:
            yield msg("track {track}: {fields}", track=track, fields=joined(", ", fields))


def _differing(own: TrackLabel, other: TrackLabel) -> list[str]:
    """The fields of a label in words that the other label says otherwise."""
    said: list[str] = []
    if own.name != other.name:
        said.append(msg("name {name}", name=own.name) if own.name else msg("no name"))
    for key in sorted({*own.attributes, *other.attributes}):
        value = own.attributes.get(key)
        if value != other.attributes.get(key):
            said.append(
                msg("no {key}", key=key)
                if value is None
                else msg("{key} = {value}", key=key, value=value)
            )
    if own.notes != other.notes:
        said.append(
            msg("notes {notes}", notes=" ".join(own.notes.split()))
            if own.notes
            else msg("no notes")
        )
    return said


def _other_labels(labels: LabelState) -> Iterator[Iterable[str]]:
    yield (
        msg(
            "track {track} reviewed {where}" if seen.track else "everybody reviewed {where}",
            track=seen.track,
            where=scope_text(seen.start, seen.end),
        )
        for seen in labels.reviewed
    )
    yield (
        msg(
            "{kind} of {what} in frame {frame}: {decision}",
            kind=said.kind,
            what=tracks_text(said.tracks) if said.tracks else msg("nobody"),
            frame=said.frame,
            decision=said.decision,
        )
        for said in labels.verdicts
    )
    yield (_drawn(msg("occluder"), one) for one in labels.occluders)
    yield (msg("counting line {name}", name=line.name) for line in labels.lines)
    yield (_drawn(msg("region"), one) for one in labels.regions)
    yield (_part(label) for label in labels.parts)
    names = some_of([one.name for one in labels.schema or ()], _MOST_NAMED)
    yield [msg("attributes of people: {names}", names=names)] if labels.schema else []


def _drawn(what: str, one: Occluder | Region) -> str:
    return msg(
        "{what} {name} with {count} corners", what=what, name=one.name, count=len(one.polygon)
    )


def _part(label: PartLabel) -> str:
    return msg(
        "{part} of {track} in frame {frame}: {said}",
        part=msg(PART_NAMES[label.part]),
        track=label.track,
        frame=label.frame,
        said=SAID_OF_PART[label.on_part],
    )


def _few(words: Sequence[str]) -> Sequence[str]:
    if len(words) <= _MOST_NAMED:
        return words
    return [*words[:_MOST_NAMED], msg("{n} more", n=len(words) - _MOST_NAMED)]

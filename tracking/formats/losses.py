"""What of some tracks a format does not hold, told when they are written."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from tracking.formats.label_text import CLASS
from tracking.formats.track_format import Content, TrackFormat
from tracking.formats.track_writer import ROWS_AT_ONCE, Exported
from tracking.tracks import Source, TrackLabel, missing_values, unfit_values
from tracking.translation import count_msg, joined, msg, some_of

_COLUMNS = {
    Content.BOXES: "left",
    Content.PLACES: "x",
    Content.VELOCITIES: "vx",
    Content.CONFIDENCE: "confidence",
    Content.VISIBILITY: "visibility",
    Content.SOURCES: "source",
    Content.PREDICTED: "predicted",
}
_SURE = (Content.CONFIDENCE, Content.VISIBILITY)
"""Where all that is known is 1, nothing is said."""
_ONE = {Content.BOXES: msg("box"), Content.PLACES: msg("place on the floor")}
_NAMED = 6
_TOLD = 40
"""Letters of an attribute's key in a note."""
_IS_RESULT = msg(
    "written as a result, with confidence; ground truth is what is written to gt/gt.txt, "
    "label_02/ or truth.txt"
)


def losses(kind: TrackFormat, exported: Exported, path: Path) -> tuple[str, ...]:
    """What a file of that format lacks of the tracks, a line each; none where it holds them all.

    Args:
        path: of the file: it says whether that is ground truth.
    """
    truth = exported.is_ground_truth(path)
    there = {each for each in Content if _is_there(exported, each, truth=truth)}
    notes = [
        _rows_lost(kind, exported),
        _contents_lost(kind, exported, there, truth=truth),
        _labels_changed(kind, exported),
        *_unfit(kind, exported),
    ]
    confidence = Content.CONFIDENCE in there and kind.confidence_in_results
    if confidence and exported.corrected and not truth:
        notes.append(_IS_RESULT)
    return tuple(filter(None, notes))


def _rows_lost(kind: TrackFormat, exported: Exported) -> str:
    """How many rows are not written; "" where all are."""
    if kind.needs is None:
        return ""
    rows, column = len(exported), _COLUMNS[kind.needs]
    lost = rows - sum(int(np.isfinite(piece).sum()) for piece in _pieces(exported, column))
    return (
        count_msg(
            lost,
            "{n} of {rows} rows has no {one} and is left out",
            "{n} of {rows} rows have no {one} and are left out",
            rows=rows,
            one=_ONE[kind.needs],
        )
        if lost
        else ""
    )


def _contents_lost(
    kind: TrackFormat, exported: Exported, there: set[Content], *, truth: bool
) -> str:
    """What of all rows is not written; "" where everything is."""
    no_view = kind.in_camera and exported.view is None
    unheld = {Content.PLACES} if no_view else set()
    unheld |= {Content.CONFIDENCE} if kind.confidence_in_results and truth else set()
    lost = [each for each in Content if each in there and each not in kind.holds - unheld]
    if not lost:
        return ""
    told = msg(
        "left out, as {title} has none: {lost}",
        title=msg(kind.title),
        lost=joined(", ", map(msg, lost)),
    )
    reason = msg(
        "; places need the recording's camera and floor, which are not known or out of reach"
    )
    return told + reason if no_view and Content.PLACES in lost else told


def _unfit(kind: TrackFormat, exported: Exported) -> Iterator[str]:
    """What of the attributes that are written does not suit their schema."""
    schema = exported.schema
    if not schema or Content.NAMES not in kind.holds:
        return
    yield from unfit_values(schema, exported.labels)
    required = [one.name for one in schema if one.required]
    if required:
        yield from missing_values(schema, exported.labels, exported.track_ids)
    if required and Content.SCHEMA in kind.holds:
        yield msg(
            "{title} does not say that an attribute is required, as {names} here",
            title=msg(kind.title),
            names=some_of(required, _NAMED),
        )


def _labels_changed(kind: TrackFormat, exported: Exported) -> str:
    """How many labels do not come back as they are, and the first of them; "" where all do."""
    if kind.label_as_read is None:
        return ""
    changed = [
        (track, what)
        for track, label in sorted(exported.labels.items())
        if (what := _difference(label, kind.label_as_read(label)))
    ]
    if not changed:
        return ""
    track, what = changed[0]
    others = (
        msg(", as do those of {count} others", count=len(changed) - 1) if len(changed) > 1 else ""
    )
    return msg(
        "{what} of track {track} comes back changed or not at all{others}",
        what=what,
        track=track,
        others=others,
    )


def _difference(label: TrackLabel, back: TrackLabel) -> str:
    """What is another in a label that comes back, as messages name it; "" where nothing is."""
    if label.name != back.name:
        return msg("the name")
    there, after = dict(label.attributes), dict(back.attributes)
    keys = [key for key in (*there, *after) if there.get(key) != after.get(key)]
    return msg("the attribute {keys!r}", keys=keys[0][:_TOLD]) if keys else ""


def _is_there(exported: Exported, content: Content, *, truth: bool) -> bool:
    """Whether the tracks have it; ground truth says of rows itself that they do not count."""
    if content is Content.SCHEMA:
        return bool(exported.schema)
    if content not in _COLUMNS:
        return any(_says(label, content) for label in exported.labels.values())
    for piece in _pieces(exported, _COLUMNS[content]):
        known = np.isfinite(piece)
        if content in _SURE:
            known &= piece != 1
        elif content in (Content.SOURCES, Content.PREDICTED):
            known &= piece != Source.TRACKER
        if content is Content.CONFIDENCE and truth and exported.dont_cares:
            known &= piece != 0
        if known.any():
            return True
    return False


def _says(label: TrackLabel, content: Content) -> bool:
    if content is Content.CLASSES:
        return CLASS in label.attributes
    if content is Content.NOTES:
        return bool(label.notes)
    return bool(label.name or set(label.attributes) - {CLASS})


def _pieces(exported: Exported, name: str) -> Iterator[NDArray[np.float64]]:
    column = exported.rows[name]
    for start in range(0, len(exported), ROWS_AT_ONCE):
        yield np.asarray(column[start : start + ROWS_AT_ONCE], np.float64)

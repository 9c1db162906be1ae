"""What is worth labelling: the parts of a session of which the detector is least sure."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from app.presenters.labelling.labelling_scene import Suggested
from app.presenters.palette import colour_of_track
from app.presenters.parts.history import parts_behind
from app.presenters.parts.picturing import part_name
from app.presenters.words import time_text, tr
from tracking.errors import EditError
from tracking.tracks import Columns, Labels, Run, TrackTable

_NAMES = ("frame", "track", "left", "top", "x", "y")
_APART_S = 1.0
_MOST = 1000


def parts_by_now(table: TrackTable, run: Run | None) -> Columns:
    """`PART_COLUMNS` of a run under the ids that people have by now, by frame."""
    rows = table.by_track(_NAMES)
    return parts_behind(rows, run)


def suggestions_for(
    table: TrackTable, run: Run | None, labels: Labels, fps: float
) -> tuple[Suggested, ...]:
    """The parts nearest to the detector's threshold, the nearest first.

    Of one part of a person at most one a second is given: frames that follow each other teach
    the same. What is labelled already is left out.

    Raises EditError where no part was judged.
    """
    parts = parts_by_now(table, run)
    judged = np.flatnonzero(np.isfinite(parts["score"]) & ~parts["occluded"])
    if not len(judged):
        raise EditError(
            tr("No detector has judged the parts: track with three-part and a detector (Ctrl+T)")
        )
    rows = _apart(parts, judged, max(1, round(_APART_S * fps)))
    keys = zip(*(parts[name][rows].tolist() for name in ("frame", "track", "part")), strict=True)
    scores = parts["score"][rows].tolist()
    found = [
        Suggested(
            key=(frame, track, part),
            reason=f"detector unsure: score {score:+.2f}",
            title=part_name(part),
            label=labels.title(track),
            colour=colour_of_track(track),
            when=time_text(frame / fps),
        )
        for (frame, track, part), score in zip(keys, scores, strict=True)
        if (frame, track, part) not in labels.parts
    ]
    return tuple(found[:_MOST])


def _apart(parts: Columns, rows: NDArray[np.int64], frames: int) -> NDArray[np.int64]:
    """Of each part of a person the least sure row in every stretch of so many frames."""
    doubt = np.abs(parts["score"][rows])
    bins = [parts[name][rows] for name in ("track", "part")] + [parts["frame"][rows] // frames]
    order = np.lexsort((doubt, *bins))
    ordered = np.stack([one[order] for one in bins]).astype(np.int64)
    begins = np.append(True, (np.diff(ordered) != 0).any(axis=0))
    best = order[begins]
    return np.asarray(rows[best[np.argsort(doubt[best], kind="stable")]])

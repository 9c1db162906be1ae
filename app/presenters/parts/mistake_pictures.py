"""Pieces of pictures around parts that were judged wrongly."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from contextlib import contextmanager

import numpy as np
from numpy.typing import NDArray

from app.presenters.document.document import Document
from app.presenters.files.opening import open_path
from app.presenters.labelling.parts import parts_of
from app.presenters.parts.training import Source
from app.presenters.parts.training_result import MistakeItem
from tracking.errors import TrackwrightError
from tracking.progress import Progress
from tracking.tracks import Box

Cut = tuple[NDArray[np.uint8], Box]
"""A piece of a picture, (h, w, 3) BGR, and the part's rectangle in it: left, top, width, height."""
Cuts = dict[MistakeItem, Cut | None]
_AROUND = 1.2
"""How much is seen around the part, in its larger side."""
_LEAST_PX = 48


def cut_outs(document: Document | None, items: Sequence[MistakeItem], report: Progress) -> Cuts:
    """The surroundings of parts; None where a recording is not found, or the person is gone.

    Args:
        document: the open one; others are opened for as long as their pictures are read.
        report: told how many are done; raises where they are not wanted any more.
    """
    found: Cuts = {}
    for source in {id(one.source): one.source for one in items}.values():
        own = [one for one in items if one.source is source]
        with _opened(document, source, own[0].recording) as there:
            for one in own:
                report(len(found), len(items))
                found[one] = None if there is None else cut_out(there, one)
    return found


@contextmanager
def _opened(document: Document | None, source: Source, recording: str) -> Iterator[Document | None]:
    """The document a source's labels are of; None where it, or its recording, is not found."""
    if document is not None and is_of(document, source, recording):
        yield document
        return
    if source.path is None or not source.fps:
        yield None
        return
    try:
        opened = open_path(source.path)
    except TrackwrightError:
        yield None
        return
    try:
        yield opened.document
    finally:
        opened.close()


def is_of(document: Document, source: Source, recording: str) -> bool:
    """Whether a source's labels are of a document.

    A table names its recording; the session that was open while it was trained has no file.
    """
    session = document.session
    if source.path is None or not source.fps:
        return document.recording.name == recording
    return session is not None and session.path == source.path


def cut_out(document: Document, item: MistakeItem) -> Cut | None:
    """The surroundings of a part of a document, and the part's rectangle in them."""
    session, recording = document.session, document.recording
    if session is None or not 0 <= item.frame < recording.frame_count:
        return None
    run = session.corrected_run
    there = parts_of(session.labels, session.tracks, run, item.track, item.frame)
    if item.part not in there:
        return None
    picture = recording.read(item.frame).left
    return cut_around(picture, there[item.part][0].box)


def cut_around(picture: NDArray[np.uint8], box: Box) -> Cut | None:
    """A square of the picture around a box, cut off at its edges; None far beside it."""
    left, top, width, height = box
    side = max((1 + 2 * _AROUND) * max(width, height), _LEAST_PX)
    across, down = left + width / 2 - side / 2, top + height / 2 - side / 2
    rows, columns = picture.shape[:2]
    first, last = max(0, round(across)), min(columns, round(across + side))
    upper, lower = max(0, round(down)), min(rows, round(down + side))
    if last <= first or lower <= upper:
        return None
    piece = np.ascontiguousarray(picture[upper:lower, first:last])
    return piece, (left - first, top - upper, width, height)

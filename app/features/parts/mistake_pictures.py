"""Pieces of pictures around parts that were judged wrongly."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from contextlib import closing, contextmanager
from dataclasses import dataclass
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from app.features.parts.training_result import MistakeItem
from app.features.parts.training_set import Source, box_or_none
from tracking.errors import CancelledError, TrackwrightError
from tracking.progress import Progress
from tracking.recording import Recording
from tracking.session import KnownRecordings, Session, boxes_of, parts_by_now
from tracking.tracks import Box, Labels, Run, TrackTable

Cut = tuple[NDArray[np.uint8], Box]
"""A piece of a picture, (h, w, 3) BGR, and the part's rectangle in it: left, top, width, height."""
Cuts = dict[MistakeItem, Cut | None]
_AROUND = 1.2
"""How much is seen around the part, in its larger side."""
_LEAST_PX = 48


@dataclass(frozen=True, slots=True, eq=False)
class Here:
    """What is open in the window, as it was when pictures were asked for.

    Attributes:
        path: of its session; None where it has none. labels, tracks, run: of it; they are asked
            for the rectangles of tables, which have none.
    """

    recording: Recording
    path: Path | None
    labels: Labels
    tracks: TrackTable
    run: Run | None

    @classmethod
    def of(cls, recording: Recording, session: Session) -> Here:
        """The state of now; later edits change nothing of it."""
        tracks = session.tracks.snapshot()
        return cls(recording, session.path, session.labels, tracks, session.corrected_run)

    def box_of(self, item: MistakeItem) -> Box | None:
        """The rectangle that a mistake is about; None where the person is gone."""
        one = item.mistake
        parts = parts_by_now(self.tracks, self.run, [one.track], (one.frame, one.frame + 1))
        # The detector is wrong: what it calls failed was labelled on its part.
        place = ((one.frame, one.track, one.part), one.failed)
        return box_or_none(boxes_of([place], self.labels.parts, parts)[0])


@dataclass(frozen=True, slots=True, eq=False)
class Search:
    """How recordings that are not open are found.

    Attributes:
        known: remembers where they stand. allow_outside: outside of their session's folder, too.
        missed: told why there are no pictures of a source.
    """

    known: KnownRecordings | None = None
    allow_outside: bool = False
    missed: Callable[[Source, TrackwrightError], None] = lambda *_: None


def crop_surroundings(
    here: Here | None, search: Search, items: Sequence[MistakeItem], report: Progress
) -> Cuts:
    """The surroundings of parts; None where a recording is not found, or the person is gone.

    Args:
        here: what is open; other recordings are opened for as long as their pictures are read,
            and their sessions stay free for others.
        report: told how many are done; raises where they are not wanted any more.
    """
    found: Cuts = dict.fromkeys(items)
    done = 0
    for source in {id(one.source): one.source for one in items}.values():
        own = sorted((one for one in items if one.source is source), key=lambda one: one.frame)
        try:
            with _footage(here, search, own[0]) as recording:
                for number, one in enumerate(own):
                    report(done + number, len(items))
                    found[one] = None if recording is None else _cut_out(recording, here, one)
        except CancelledError:
            raise
        except TrackwrightError as error:
            search.missed(source, error)
        done += len(own)
    return found


@contextmanager
def _footage(here: Here | None, search: Search, item: MistakeItem) -> Iterator[Recording | None]:
    """The recording of a mistake; None for a table whose recording is not open.

    Raises SessionError or FormatError where the session or the recording cannot be read.
    """
    path = item.source.path
    if here is not None and is_of(here.recording, here.path, item):
        yield here.recording
    elif path is None or not item.source.fps:
        yield None
    else:
        with (
            closing(Session.look_into(path)) as session,
            session.open_recording(
                known=search.known, allow_outside=search.allow_outside
            ) as recording,
        ):
            yield recording


def is_of(recording: Recording, path: Path | None, item: MistakeItem) -> bool:
    """Whether a mistake is of a recording whose session has a path.

    A table names its recording; the session that was open while it was trained has no file.
    """
    source = item.source
    if source.path is None or not source.fps:
        return recording.name == item.recording
    return path == source.path


def _cut_out(recording: Recording, here: Here | None, item: MistakeItem) -> Cut | None:
    """The surroundings of the rectangle that a mistake is about."""
    box = item.box
    if box is None and here is not None:
        box = here.box_of(item)
    if box is None or not 0 <= item.frame < recording.frame_count:
        return None
    return crop_around(recording.read(item.frame).left, box)


def crop_around(picture: NDArray[np.uint8], box: Box) -> Cut:
    """A square of the picture around a box, moved so that it lies in the picture."""
    left, top, width, height = box
    rows, columns = picture.shape[:2]
    around = round((1 + 2 * _AROUND) * max(width, height))
    side = min(max(around, _LEAST_PX), rows, columns)
    first, upper = (
        min(max(round(middle - side / 2), 0), length - side)
        for middle, length in ((left + width / 2, columns), (top + height / 2, rows))
    )
    piece = np.ascontiguousarray(picture[upper : upper + side, first : first + side])
    return piece, (left - first, top - upper, width, height)

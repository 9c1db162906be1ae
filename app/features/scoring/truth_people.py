"""The people of a truth and what goes wrong with them, as pictures and floor draw them."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import Final

import numpy as np

from app.core.colours.track_colours import TrackColours
from app.core.i18n import tr
from app.core.projection.extent import extent, reach_m
from app.core.projection.other_people import OtherPeople
from app.core.projection.right_image import boxes_in_right_image
from app.core.scenes import LegendEntry, Side
from app.core.scenes.ground_truth import (
    ERROR_COLOURS,
    TRUTH_COLOUR,
    ErrorsOf,
    FlooredTruth,
    PicturedTruth,
    TruthMark,
    TruthPlace,
)
from app.core.tracks.frame_state import FrameState
from app.core.tracks.session_tracks import rows_of_frame
from tracking.recording import Recording
from tracking.scoring import ErrorKind, ErrorTable
from tracking.tracks import Columns, Run, TrackTable

_SIDE = ("left", "top", "width", "height")


@dataclass(frozen=True, slots=True)
class Scored:
    """Whose errors are shown.

    Attributes:
        version: of the two that are compared. name: of it, "" where none are compared.
        run: whose people the dashed version are.
    """

    version: ErrorsOf = ErrorsOf.SOLID
    name: str = ""
    run: Run | None = None

    def rows(self, state: FrameState) -> Columns:
        """The people that were scored, in the frame that is shown."""
        if self.run is not None:
            return rows_of_frame(self.run.tracks, state.frame)
        return state.tracks.of_frame(state.frame)


IN_VIEW: Final = Scored()


class TruthPeople:
    """Makes the marks of one truth beside one result.

    Args:
        people: of the truth that count. errors: of the result, by frame.
    """

    def __init__(self, recording: Recording, people: TrackTable, errors: ErrorTable) -> None:
        self._recording, self._errors = recording, errors
        self._people = OtherPeople(recording, people, TrackColours().of)
        self._bounds = extent(people.by_track(("x", "y")), reach_m(recording))

    def picture(self, side: Side, state: FrameState, scored: Scored = IN_VIEW) -> PicturedTruth:
        """Everybody of the truth in one camera, and which of the result's are nobody."""
        missed, alarms = self._wrong(state.frame, scored)
        people = tuple(
            TruthMark(one.box, _label(one.label), _if_missed(one.label, missed))
            for one in self._people.picture(side, state.frame)
        )
        told = legend(scored) if side is Side.LEFT else ()
        rows = _of_tracks(scored.rows(state), alarms)
        return PicturedTruth(people, self._alarms(side, rows), told, errors_of=scored.version)

    def floor(self, state: FrameState, scored: Scored = IN_VIEW) -> FlooredTruth:
        """The same on the floor."""
        missed, alarms = self._wrong(state.frame, scored)
        people = tuple(
            TruthPlace(one.trail, _label(one.label), _if_missed(one.label, missed))
            for one in self._people.floor(state.frame)
        )
        rows = _of_tracks(scored.rows(state), alarms)
        xy = np.column_stack((rows["x"], rows["y"])).astype(np.float64)
        xy = xy[np.isfinite(xy).all(axis=1)]
        found = tuple(TruthPlace(place[None], "", ErrorKind.FALSE_ALARM) for place in xy)
        return FlooredTruth(people, found, legend(scored), self._bounds)

    def rows(self, frame: int) -> Columns:
        """Everybody of the truth, as rows of tracks."""
        return self._people.rows(frame)

    def _wrong(self, frame: int, scored: Scored) -> tuple[set[int], set[int]]:
        """Who is missed in a frame, and which tracks are nobody there."""
        if scored.version is ErrorsOf.NEITHER:
            return set(), set()
        first, stop = np.searchsorted(self._errors.frame, (frame, frame + 1)).tolist()
        kind = self._errors.kind[first:stop]
        missed = self._errors.truth[first:stop][kind == ErrorKind.MISS]
        alarms = self._errors.result[first:stop][kind == ErrorKind.FALSE_ALARM]
        return set(missed.tolist()), set(alarms.tolist())

    def _alarms(self, side: Side, rows: Columns) -> tuple[TruthMark, ...]:
        boxes = np.column_stack([rows[name] for name in _SIDE]).astype(np.float64)
        rectification = self._recording.rectification
        if side is Side.RIGHT and len(boxes):
            if rectification is None or self._recording.ground is None:
                return ()
            boxes = boxes_in_right_image(
                rectification, boxes, np.column_stack((rows["x"], rows["y"]))
            )
        return tuple(
            TruthMark((left, top, width, height), "", ErrorKind.FALSE_ALARM)
            for left, top, width, height in boxes.tolist()
            if math.isfinite(left + top + width + height)
        )


def legend(scored: Scored = IN_VIEW) -> tuple[LegendEntry, ...]:
    """What the marks mean, and whose errors these are where two versions are compared."""
    truth = LegendEntry(TRUTH_COLOUR, tr("ground truth: T and its number"))
    missed, alarm = tr("missed"), tr("false alarm")
    if scored.version is ErrorsOf.NEITHER:
        said = tr("errors are not shown: scored is {version}, not compared", version=scored.name)
        return truth, LegendEntry(ERROR_COLOURS[ErrorKind.MISS], said)
    if scored.name:
        missed = tr("missed by {version}", version=scored.name)
        alarm = tr("false alarm of {version}", version=scored.name)
    return (
        truth,
        LegendEntry(ERROR_COLOURS[ErrorKind.MISS], missed),
        LegendEntry(ERROR_COLOURS[ErrorKind.FALSE_ALARM], alarm),
    )


def _of_tracks(rows: Columns, tracks: set[int]) -> Columns:
    chosen = np.isin(rows["track"], sorted(tracks))
    return {name: column[chosen] for name, column in rows.items()}


def _label(track: str) -> str:
    return f"T{track}"


def _if_missed(track: str, missed: set[int]) -> ErrorKind | None:
    return ErrorKind.MISS if int(track) in missed else None

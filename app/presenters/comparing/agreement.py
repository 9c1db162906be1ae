"""Another person's session of the same recording beside the open one."""

from __future__ import annotations

import math
from collections.abc import Callable
from contextlib import closing
from dataclasses import dataclass
from pathlib import Path

import numpy as np

from app.presenters.comparing.agreement_scene import (
    AgreementScene,
    DisagreementRow,
    OtherMark,
    OtherPlace,
)
from app.presenters.palette import colour_of_track
from app.presenters.pictures.right_eye import boxes_in_right_eye
from app.presenters.scenes import Eye
from app.presenters.words import time_text, tr
from tracking.errors import SessionError
from tracking.recording import Recording
from tracking.scoring import Agreement, Disagreement, ScoringTable, agreement
from tracking.session import RecordingReference, Session
from tracking.tracks import TrackTable

Report = Callable[[int, int], None]
_STEPS = 4
_GAP_S = 0.5
"""Disagreements of the same two tracks that lie closer together are one stretch."""
_TRAIL_S = 2.0


@dataclass(frozen=True, slots=True)
class OtherSession:
    """What another person made of the recording, and how far it agrees.

    Attributes:
        name: of the file. tracks: its corrected tracks. agreement: the open session is a.
        revision: of the open session's tracks when it was compared.
    """

    name: str
    tracks: TrackTable
    agreement: Agreement
    revision: int


def refuse_other_recording(one: RecordingReference, other: RecordingReference, named: str) -> None:
    """Two sessions can be compared where they were made from the same sources.

    Args:
        one, other: what the sessions say of their recordings.
        named: the other session, as the user knows it.

    Raises:
        SessionError: the recordings differ.
    """
    here = [(part.size_bytes, part.sha256) for part in one.sources], one.frame_count
    there = [(part.size_bytes, part.sha256) for part in other.sources], other.frame_count
    if here != there:
        raise SessionError(
            f"{named} is of another recording ({other.name}, not {one.name}); "
            "choose a session of the same one"
        )


def read_other(path: Path, own: Session, snapshot: TrackTable, report: Report) -> OtherSession:
    """Read another session and compare it; for a thread of its own.

    Args:
        path: the other session; it is let go again before this returns.
        own: the open session; only what does not change of it is looked at.
        snapshot: its tracks.

    Raises:
        SessionError: it cannot be read, is the open one itself or is of another recording.
        CancelledError: by `report`.
    """
    if own.path is not None and path.resolve() == own.path.resolve():
        raise SessionError(f"{path.name} is the open session itself; choose another person's")
    report(0, _STEPS)
    with closing(Session.open(path)) as session:
        refuse_other_recording(own.recording, session.recording, path.name)
        tracks = session.tracks.snapshot()
    report(1, _STEPS)
    return OtherSession(
        path.name, tracks, _compared(own, snapshot, tracks, report), snapshot.revision
    )


def compared_again(
    other: OtherSession, own: Session, snapshot: TrackTable, report: Report
) -> OtherSession:
    """The same session compared with the open one as it is by now."""
    found = _compared(own, snapshot, other.tracks, report)
    return OtherSession(other.name, other.tracks, found, snapshot.revision)


def _compared(own: Session, a: TrackTable, b: TrackTable, report: Report) -> Agreement:
    table_a = ScoringTable.from_columns(a.columns())
    report(2, _STEPS)
    table_b = ScoringTable.from_columns(b.columns())
    report(3, _STEPS)
    found = agreement(table_a, table_b, gap=round(_GAP_S * own.recording.fps))
    report(4, _STEPS)
    return found


class AgreementPresenter:
    """Makes the scenes of another session beside the open one."""

    def __init__(self, recording: Recording, other: OtherSession) -> None:
        self._recording = recording
        self.other = other
        self._own_of = {b: a for a, b in other.agreement.same}
        self._rows = tuple(self._row(one) for one in other.agreement.disagreements)

    def panel(self, revision: int) -> AgreementScene:
        """The panel; revision: of the open session's tracks now."""
        found = self.other.agreement
        figures = tr(
            "IDF1 {idf1}, kappa {kappa} over {rows} rows",
            idf1=_share(found.idf1),
            kappa=_share(found.kappa),
            rows=found.rows,
        )
        return AgreementScene(
            tr("Compared with {name}", name=self.other.name),
            figures,
            self._rows,
            revision != self.other.revision,
        )

    def picture(self, eye: Eye, frame: int) -> tuple[OtherMark, ...]:
        """The other session's people in one eye."""
        rows = self.other.tracks.of_frame(frame)
        boxes = np.column_stack([rows[name] for name in ("left", "top", "width", "height")])
        if eye is Eye.RIGHT and len(boxes):
            rectification = self._recording.rectification
            if rectification is None or self._recording.ground is None:
                return ()
            boxes = boxes_in_right_eye(
                rectification, boxes, np.column_stack((rows["x"], rows["y"]))
            )
        return tuple(
            OtherMark((left, top, width, height), str(track), self._colour(track))
            for track, (left, top, width, height) in zip(
                rows["track"].tolist(), boxes.tolist(), strict=True
            )
            if math.isfinite(left + top + width + height)
        )

    def floor(self, frame: int) -> tuple[OtherPlace, ...]:
        """Where they come from on the floor."""
        start = max(0, frame - round(_TRAIL_S * self._recording.fps))
        places = []
        for track in self.other.tracks.of_frame(frame)["track"].tolist():
            rows = self.other.tracks.of_track(track, start, frame + 1)
            trail = np.column_stack((rows["x"], rows["y"])).astype(np.float64)
            trail = trail[np.isfinite(trail).all(axis=1)]
            if len(trail):
                places.append(OtherPlace(trail, str(track), self._colour(track)))
        return tuple(places)

    def _colour(self, track: int) -> tuple[int, int, int]:
        return colour_of_track(self._own_of.get(track, track))

    def _row(self, one: Disagreement) -> DisagreementRow:
        if one.kind == "only a":
            text = tr("{a} here, nobody there", a=one.track_a)
        elif one.kind == "only b":
            text = tr("nobody here, {b} there", b=one.track_b)
        else:
            own = self._own_of.get(one.track_b)
            there = tr("{b} (your {own})", b=one.track_b, own=own) if own else str(one.track_b)
            text = tr("{a} here, {there} there", a=one.track_a, there=there)
        first, last = self._recording.time_s(one.start), self._recording.time_s(one.end - 1)
        when = tr("{first} to {last}", first=time_text(first), last=time_text(last))
        return DisagreementRow(text, when, one.start, one.track_a)


def _share(value: float) -> str:
    return "\u2013" if math.isnan(value) else f"{value:.3f}"

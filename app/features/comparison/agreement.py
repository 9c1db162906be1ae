"""Another person's session of the same recording beside the open one."""

from __future__ import annotations

import math
from contextlib import closing
from dataclasses import dataclass
from pathlib import Path

from app.core.colours.track_colours import ColourOf
from app.core.document.recording_match import refuse_other_recording
from app.core.i18n import span_text, tr
from app.core.projection.other_people import OtherPeople
from app.features.comparison.scene import AgreementScene, DisagreementRow
from tracking.editing import Change, plan_take_range
from tracking.editing.tracking_again.counterparts import Places, counterparts
from tracking.errors import SessionError
from tracking.progress import Progress
from tracking.recording import Recording
from tracking.scoring import Agreement, Disagreement, ScoringTable, agreement, stretch_gap
from tracking.session import Session
from tracking.tracks import Columns, TrackTable, next_track

_STEPS = 4


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


def read_other(path: Path, own: Session, snapshot: TrackTable, report: Progress) -> OtherSession:
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
        raise SessionError(
            "{name} is the open session itself; choose another person's", name=path.name
        )
    report(0, _STEPS)
    with closing(Session.open(path)) as session:
        refuse_other_recording(own.recording, session.recording, path.name)
        tracks = session.tracks.snapshot()
    report(1, _STEPS)
    return OtherSession(
        path.name, tracks, _compared(own, snapshot, tracks, report), snapshot.revision
    )


def compare_again(
    other: OtherSession, own: Session, snapshot: TrackTable, report: Progress
) -> OtherSession:
    """The same session compared with the open one as it is by now."""
    found = _compared(own, snapshot, other.tracks, report)
    return OtherSession(other.name, other.tracks, found, snapshot.revision)


def _compared(own: Session, a: TrackTable, b: TrackTable, report: Progress) -> Agreement:
    table_a = ScoringTable.from_columns(a.columns())
    report(2, _STEPS)
    table_b = ScoringTable.from_columns(b.columns())
    report(3, _STEPS)
    found = agreement(table_a, table_b, gap=stretch_gap(own.recording.fps))
    report(4, _STEPS)
    return found


class AgreementPresenter:
    """Makes the scenes of another session beside the open one.

    Attributes:
        people: the other session's people, each in the colour of who they are taken for.
    """

    def __init__(self, recording: Recording, other: OtherSession, colour_of: ColourOf) -> None:
        self._recording, self._colour_of = recording, colour_of
        self.other = other
        self._own_of = {b: a for a, b in other.agreement.same}
        self.people = OtherPeople(recording, other.tracks, self._colour)
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

    def plan_theirs(self, number: int, table: TrackTable) -> Change:
        """The edit that takes the other person's word in one of the disagreements.

        In its range both people it is about stand as they have them, under the open session's ids
        or a new one; whom they see nowhere there stands nowhere, and so does whom they see where
        the open session has somebody else, who stays.

        Raises EditError where nothing would change.
        """
        one = self.other.agreement.disagreements[number]
        own = self._own_of.get(one.track_b, next_track(table)) if one.track_b else 0
        same = dict(self.other.agreement.same)
        asked = {one.track_a: same.get(one.track_a, 0), own: one.track_b}
        others = [track for track in table.track_ids if track not in asked]
        there = Places.of(table.of_tracks(others, one.start, one.end))
        taken: dict[int, Columns] = {}
        for track, b in asked.items():
            rows = self.other.tracks.of_track(b, one.start, one.end)
            free = counterparts(Places.of(rows), there) < 0
            taken[track] = {name: column[free] for name, column in rows.items()}
        taken.pop(0, None)
        return plan_take_range(table, taken, one.start, one.end, self.other.name)

    def _colour(self, track: int) -> tuple[int, int, int]:
        return self._colour_of(self._own_of.get(track, track))

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
        return DisagreementRow(text, span_text(first, last), one.start, one.track_a)


def _share(value: float) -> str:
    return "\u2013" if math.isnan(value) else f"{value:.3f}"

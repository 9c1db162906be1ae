"""Scoring in the open recording: what is asked for, what came of it, what the views show."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, field, replace
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from app.core.document.document import Document
from app.core.document.track_sources import SHOWN, capture_rows, list_track_sources, version_of
from app.core.error_messages import explain
from app.core.i18n import N_, tr
from app.core.keymap import in_brackets
from app.core.projection.concern import CONCERNED, Concern
from app.core.scenes import HistoryItem
from app.core.scenes.error_events import ErrorEvents
from app.core.scenes.ground_truth import ERROR_COLOURS, ErrorLane, ErrorLanes, ErrorsOf
from app.core.scenes.score_figures import ScoreRow, rows_of
from app.features.scoring.moves import Moves, edits_not_undone
from app.features.scoring.scene import ErrorChoice, ScoreScene
from app.features.scoring.subject import (
    MatchingRule,
    Range,
    ScoreResult,
    ScoreSubject,
    ScoringInput,
)
from app.features.scoring.truth_people import IN_VIEW, Scored, TruthPeople
from app.features.scoring.truths import TruthKind, TruthSource, capture_truth, name_of, refuse_own
from tracking.scoring import ErrorKind
from tracking.tracks import Columns

_NAMES = {
    ErrorKind.SWITCH: N_("Switches"),
    ErrorKind.FRAGMENTATION: N_("Fragmentations"),
    ErrorKind.MISS: N_("Misses"),
    ErrorKind.FALSE_ALARM: N_("False alarms"),
}


@dataclass(slots=True)
class ScoringChoice:
    """What the user has chosen.

    Attributes:
        source: of the truth; None: that beside the recording. files: chosen before.
        track_source: `SHOWN` or a run's number. matching: how rows are paired.
        kinds: of the errors that are shown.
    """

    source: TruthSource | None = None
    files: list[TruthSource] = field(default_factory=list)
    track_source: int = SHOWN
    matching: MatchingRule = field(default_factory=MatchingRule)
    kinds: set[ErrorKind] = field(default_factory=lambda: set(ErrorKind))


class ScoringPresenter:
    """Says what is to be scored and makes the scenes of what was.

    Attributes:
        visible: the half-open range of frames that the timeline shows.
    """

    def __init__(self, document: Document) -> None:
        self._document = document
        self.choice = ScoringChoice()
        self.visible: Range = (0, document.recording.frame_count)
        self.scored: ScoreResult | None = None
        self._refused: tuple[ScoreSubject, str] | None = None
        self._moves = Moves()
        self._people: tuple[ScoreResult | None, TruthPeople | None] = (None, None)
        self._lanes: tuple[object, ErrorLanes | None] = (None, None)

    # what is chosen

    @property
    def sources(self) -> tuple[TruthSource, ...]:
        """The truths there are: beside the recording, files that were chosen, runs."""
        beside, session = self._document.recording.truth_path, self._document.session
        found = [TruthSource.of_file(beside, TruthKind.BESIDE)] if beside is not None else []
        runs = range(len(session.runs) if session is not None else 0)
        own = self.track_source
        return (
            *found,
            *self.choice.files,
            *(TruthSource(TruthKind.RUN, run=run) for run in runs if run != own),
        )

    @property
    def source(self) -> TruthSource | None:
        """The truth that is chosen; None: there is none yet."""
        chosen, sources = self.choice.source, self.sources
        if chosen is not None:
            same = (one for one in sources if (one.kind, one.path, one.run) == _key(chosen))
            if (found := next(same, None)) is not None:
                return found
        return next((one for one in sources if not one.is_run), None)

    def choose_file(self, path: Path) -> None:
        """Take a file as truth.

        Raises:
            SessionError: it is the open session.
        """
        if self._document.session is not None:
            refuse_own(path, self._document.session)
        source = TruthSource.of_file(path)
        others = [one for one in self.choice.files if one.path != path]
        self.choice.files = [*others, source]
        self.choice.source = source

    def choose_floor(self, on_floor: bool) -> None:
        """Pair by distance on the floor, or by overlap of boxes."""
        self.choice.matching = replace(self.choice.matching, on_floor=on_floor)

    def choose_threshold(self, value: float) -> None:
        """Pair from another overlap or distance on."""
        self.choice.matching = self.choice.matching.with_threshold(value)

    def show_kind(self, kind: ErrorKind, shown: bool) -> None:
        """Show errors of a kind, or leave them out."""
        (self.choice.kinds.add if shown else self.choice.kinds.discard)(kind)

    @property
    def track_source(self) -> int:
        """`SHOWN` or the number of the run that is scored; a run that is gone is none."""
        session, track_source = self._document.session, self.choice.track_source
        return SHOWN if session is None or track_source >= len(session.runs) else track_source

    # what is scored

    def current_subject(self) -> ScoreSubject | None:
        """What is to be scored now; None: there is nothing, or no truth."""
        source = self.source
        if source is None or not self._document.tracks.ids:
            return None
        version = version_of(self._document, self.track_source)
        frames = self._frames
        if self._document.is_live and self.track_source == SHOWN:
            frames = self._whole_seconds(frames)
        visible = max(self.visible[0], frames[0]), min(self.visible[1], frames[1])
        return ScoreSubject(
            source=source,
            track_source=self.track_source,
            version=version,
            matching=self.choice.matching,
            frames=frames,
            visible=visible if visible[0] < visible[1] else frames,
        )

    def _whole_seconds(self, frames: Range) -> Range:
        """What a tracker at work has been through, told anew once for each second of it."""
        fps = self._document.recording.fps
        seconds = int((frames[1] - frames[0]) / fps)
        return frames[0], frames[0] + max(1, round(seconds * fps))

    def capture(self, subject: ScoreSubject) -> ScoringInput:
        """Takes hold of what scoring a subject needs."""
        document = self._document
        session = document.session
        read = capture_truth(subject.source, document.recording, session)
        edits: tuple[int, ...] = ()
        if session is not None and subject.track_source == SHOWN:
            edits = edits_not_undone(session.history)
        return ScoringInput(capture_rows(document, subject.track_source), read, edits)

    @property
    def _frames(self) -> Range:
        """The frames that the tracks go over."""
        session, track_source = self._document.session, self.track_source
        if track_source != SHOWN and session is not None:
            return session.runs[track_source].frames
        return self._document.tracks.frames

    def take(self, scored: ScoreResult) -> None:
        """Show what was scored."""
        self.scored, self._refused = scored, None
        if not self._document.is_live:
            self._moves.take(scored)

    def refuse(self, subject: ScoreSubject, error: Exception) -> None:
        """This cannot be scored, and why."""
        self.scored = None
        self._refused = (subject, explain(error))

    # errors

    @property
    def events(self) -> ErrorEvents | None:
        """The errors of the kinds that are shown, as stretches; None while nothing is scored."""
        return self.scored.events.of_kinds(self.choice.kinds) if self.scored is not None else None

    @property
    def people(self) -> TruthPeople | None:
        """The people of the truth; None while it is not read."""
        if self._people[0] is not self.scored:
            scored = self.scored
            made = None
            if scored is not None:
                made = TruthPeople(self._document.recording, scored.truth.people, scored.errors)
            self._people = (scored, made)
        return self._people[1]

    @property
    def scored_version(self) -> Scored:
        """Whose errors are shown, where two versions are compared."""
        two, session = self._document.comparison, self._document.session
        if two is None or session is None:
            return IN_VIEW
        own = self.track_source
        name = list_track_sources(self._document)[own + 1]
        if own == (SHOWN if two.base is None else two.base):
            return Scored(ErrorsOf.SOLID, name)
        if own == two.run:
            return Scored(ErrorsOf.DASHED, name, session.runs[own])
        return Scored(ErrorsOf.NEITHER, name)

    def concern_at(self, frame: int) -> Concern | None:
        """Who the errors that begin in a frame are about, in the truth and in the result."""
        events, people = self.events, self.people
        if events is None or people is None:
            return None
        errors = events.beginning_at(frame)
        found = [_rows_of(people.rows(frame), errors.truth.tolist())]
        if self.track_source == SHOWN:
            found.append(_rows_of(self._document.tracks.of_frame(frame), errors.tracks))
        rows = {name: np.concatenate([part[name] for part in found]) for name in CONCERNED}
        return Concern(rows, frame, frame + 1)

    def annotate_edits(self, items: tuple[HistoryItem, ...]) -> tuple[HistoryItem, ...]:
        """The edits with how each of them moved the score, where that is known."""
        moved = self._moves.by_edit
        if not any(moved.values()):
            return items
        return tuple(
            replace(item, moved=moved[item.edit]) if moved.get(item.edit) else item
            for item in items
        )

    def lanes(self) -> ErrorLanes | None:
        """The lanes of errors; None while nothing was scored. The very same while they stay."""
        events = self.scored.events if self.scored is not None else None
        key = (events, frozenset(self.choice.kinds))
        if self._lanes[0] != key:
            self._lanes = (key, None if events is None else self._made_lanes(events))
        return self._lanes[1]

    def _made_lanes(self, events: ErrorEvents) -> ErrorLanes:
        recording = self._document.recording
        lanes = []
        for kind in ERROR_COLOURS:
            if kind in self.choice.kinds:
                own = events.of_kinds([kind])
                density = _at_once(own, recording.frame_count)
                count = int((own.end - own.start).sum())
                lanes.append(ErrorLane(kind, tr(_NAMES[kind]), count, density, own))
        return ErrorLanes(tuple(lanes), recording.fps)

    # the panel

    def scene(self, doing: str) -> ScoreScene:
        """The panel."""
        scored, sources, source = self.scored, self.sources, self.source
        session = self._document.session
        names = [name_of(one, session) for one in sources]
        matching = self.choice.matching
        return ScoreScene(
            truths=(*names, tr("Choose a file...")),
            truth=sources.index(source) if source is not None else -1,
            results=list_track_sources(self._document),
            result=self.track_source + 1,
            on_floor=matching.on_floor,
            threshold=matching.threshold,
            rows=self._rows(),
            whole=self._range_text(scored.subject.frames) if scored is not None else "",
            visible=self._range_text(scored.subject.visible) if scored is not None else "",
            moved=self._moves.words(session.history if session is not None else None),
            errors=self._choices(),
            doing=doing,
            message=self.why_nothing,
            notes=self._notes(),
        )

    def _notes(self) -> tuple[str, ...]:
        """What the user should know of the truth; that nobody is in it as on the command line."""
        scored = self.scored
        if scored is None or scored.whole.truth_people:
            return scored.truth.notes if scored is not None else ()
        name = name_of(scored.truth.source, self._document.session)
        said = tr(
            "{truth} has nobody in these frames: everybody tracked counts as a false alarm, and "
            "shares of the ground truth are 0",
            truth=name,
        )
        return (*scored.truth.notes, said)

    def _rows(self) -> tuple[ScoreRow, ...]:
        scored = self.scored
        if scored is None:
            return ()
        return rows_of(scored.whole, scored.visible, self._moves.before)

    def _choices(self) -> tuple[ErrorChoice, ...]:
        errors = self.scored.errors if self.scored is not None else None
        return tuple(
            ErrorChoice(
                kind,
                tr(_NAMES[kind]),
                errors.count(kind) if errors is not None else -1,
                kind in self.choice.kinds,
            )
            for kind in ERROR_COLOURS
        )

    @property
    def why_nothing(self) -> str:
        """Why nothing is scored, and what to do; "" where something is, or will be."""
        if not self._document.tracks.ids:
            if self._document.at_work:
                return self._words_at_work
            return tr(
                "Track the recording first{key}: its tracks are scored then.",
                key=in_brackets("tracks.track"),
            )
        if self.source is None:
            return tr(
                "There is no truth.txt beside the recording: choose a file with ground truth, or "
                "another run."
            )
        if self._refused is not None and self.scored is None:
            return self._refused[1]
        return ""

    @property
    def _words_at_work(self) -> str:
        """What is said until a tracker at work has its first tracks."""
        if self.scored is None:
            return tr("A tracker is running: its tracks are scored once there are some.")
        return tr(
            "A tracker is running: these figures are of the tracks before, until it has its own."
        )

    @staticmethod
    def _range_text(frames: Range) -> str:
        return tr("{first} to {last}", first=frames[0], last=frames[1] - 1)


def _key(source: TruthSource) -> tuple[TruthKind, Path | None, int]:
    return source.kind, source.path, source.run


def _rows_of(rows: Columns, tracks: Sequence[int]) -> Columns:
    kept = np.isin(rows["track"], tracks)
    return {name: rows[name][kept] for name in CONCERNED}


def _at_once(events: ErrorEvents, frame_count: int) -> NDArray[np.uint16]:
    """(frames,) in how many of the stretches each frame lies."""
    steps = np.zeros(frame_count + 1, np.int64)
    np.add.at(steps, np.minimum(events.start, frame_count), 1)
    np.add.at(steps, np.minimum(events.end, frame_count), -1)
    return np.minimum(np.cumsum(steps)[:-1], np.iinfo(np.uint16).max).astype(np.uint16)

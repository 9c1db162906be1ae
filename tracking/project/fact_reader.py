"""Reads what a project tells of a recording and of a session; neither is claimed or written to."""

from __future__ import annotations

from collections.abc import Sequence
from contextlib import closing
from dataclasses import replace
from pathlib import Path

import cv2
import numpy as np

from tracking.batch.results import draw_thumbnail, thumbnail_of, truth_table
from tracking.errors import TrackwrightError
from tracking.project.facts import RecordingFacts, SessionFacts
from tracking.project.readings import ReadFacts, Reading
from tracking.recording import Recording, open_recording
from tracking.review import ReviewItemFinder, review_state, reviewed_share
from tracking.scoring import ScoringTable, score
from tracking.session import Session
from tracking.session.hand_made import is_hand_made
from tracking.synthesis.video import is_clip
from tracking.tracks import TRACK_COLUMNS, Run, TrackTable, empty
from tracking.translation import message_of, msg


def read_facts(reading: Reading) -> ReadFacts:
    """What a recording or a session tells; one that cannot be read tells why."""
    kind = SessionFacts if reading.of_session else RecordingFacts
    try:
        if reading.of_session:
            return _read_session(reading.path, reading.recording)
        return _read_recording(reading.path)
    except TrackwrightError as error:
        return ReadFacts(kind(problem=error.message))
    except (OSError, MemoryError, ValueError, LookupError, cv2.error) as error:
        return ReadFacts(kind(problem=message_of(error) or msg("it cannot be read")))


def _read_recording(path: Path) -> ReadFacts:
    """Raises RecordingError where it cannot be opened."""
    with open_recording(path) as recording:
        facts = RecordingFacts(
            name=recording.name,
            frames=recording.frame_count,
            fps=float(recording.fps or 0.0),
            footage=footage_of(recording),
            cameras=2 if recording.is_stereo else 1,
            has_truth=recording.truth_path is not None,
            is_clip=is_clip(path),
        )
        frame = recording.frame_count // 2
        image = draw_thumbnail(recording.read(frame).left, empty(TRACK_COLUMNS), frame)
        return ReadFacts(facts, image)


def footage_of(recording: Recording) -> str:
    """What the images are known by, as in `RecordingReference`."""
    return " ".join(part.sha256 for part in recording.fingerprints())


def _read_session(path: Path, place: Path | None) -> ReadFacts:
    """Raises SessionError where it cannot be read."""
    with closing(Session.look_into(path)) as session:
        facts = _facts_of(session)
        if place is None:
            return ReadFacts(facts)
        try:
            with open_recording(place) as recording:
                if footage_of(recording) != facts.footage:
                    return ReadFacts(facts)
                image = thumbnail_of(recording, session)
                return ReadFacts(_with_score(facts, recording, session.tracks), image)
        except TrackwrightError:  # the row of the recording tells
            return ReadFacts(facts)


def _facts_of(session: Session) -> SessionFacts:
    seen, table, run = session.recording, session.tracks, session.corrected_run
    entries = [entry for entry in session.history if not entry.undone]
    facts = SessionFacts(
        name=seen.name,
        frames=seen.frame_count,
        fps=float(seen.fps or 0.0),
        footage=seen.footage,
        place=seen.path,
        tracker="" if run is None else run.tracker,
        people=len(table.track_ids),
        rows=len(table),
        frames_done=frames_done(table, run),
        reviewed_rows=reviewed_share(table, session.labels),
        hand_made=is_hand_made(run),
        edits=len(entries),
        authors=_authors([entry.author for entry in entries]),
        part_labels=len(session.labels.parts),
    )
    return facts if facts.hand_made or not seen.fps else _with_review(facts, session)


def _authors(names: Sequence[str]) -> tuple[str, ...]:
    """Each name once, in the order of their latest edits."""
    return tuple(dict.fromkeys(name for name in reversed(names) if name))[::-1]


def _with_review(facts: SessionFacts, session: Session) -> SessionFacts:
    """The facts with what is left to review."""
    table, labels, fps = session.tracks, session.labels, session.recording.fps
    finding = ReviewItemFinder().find(
        table, session.corrected_run, fps, labels, size=session.recording.size
    )
    state = review_state(finding, labels, table, fps)
    return replace(
        facts,
        reviewed_rows=state.reviewed,
        decided=state.decided,
        items_left=len(state.left),
        errors_left=state.errors.mean,
        errors_low=state.errors.low,
        errors_high=state.errors.high,
        errors_at_items=state.errors.at_items,
        minutes_left=state.minutes_left,
    )


def frames_done(table: TrackTable, run: Run | None) -> int:
    """Frames that a tracker went through, or that have rows."""
    frames = np.unique(table.columns()["frame"])
    if run is None or is_hand_made(run):
        return len(frames)
    start, stop = run.frames
    return stop - start + int(np.count_nonzero((frames < start) | (frames >= stop)))


def _with_score(facts: SessionFacts, recording: Recording, table: TrackTable) -> SessionFacts:
    """The facts with the score, where there is ground truth."""
    place = recording.truth_path
    if place is None:
        return facts
    try:
        truth = truth_table(place)
        found = ScoringTable.from_columns(table.columns())
        figures = score(truth, found, frames=recording.frame_count).as_json()
    except TrackwrightError as error:
        return replace(facts, not_scored=error.message)
    return replace(facts, idf1=_number(figures["IDF1"]), mota=_number(figures["MOTA"]))


def _number(value: object) -> float | None:
    return float(value) if isinstance(value, (int, float)) else None

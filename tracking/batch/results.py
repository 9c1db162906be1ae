"""What is made of a session in a batch: counts, an image, a score, files of other tools."""

from __future__ import annotations

import hashlib
import math
from collections.abc import Mapping
from dataclasses import replace
from pathlib import Path
from typing import Any

import cv2
import numpy as np

from tracking.batch.outcome import Outcome
from tracking.batch.publication import score_page
from tracking.batch.task import Task
from tracking.errors import OutputError, TrackwrightError
from tracking.formats import FORMATS, Exported, Filmed, measurable
from tracking.recording import Image, Recording
from tracking.review import find_review_items
from tracking.scoring import ScoringTable
from tracking.scoring.report import (
    Footage,
    Source,
    Subject,
    Yardstick,
    finding_of,
    report_of,
    shown_of,
    write_score_report,
)
from tracking.session import Session
from tracking.tracks import Columns
from tracking.tracks.columns import boxes_of
from tracking.translation import Message, msg

_WIDTH_PX = 240
_QUALITY = 80
_INK = (60, 200, 255)
"""Of boxes, BGR."""
_LEFT_OUT = ("curves", "track_map", "passages")
"""Of a score, which take much room and no table shows."""


def look_through(outcome: Outcome, session: Session) -> Outcome:
    """The outcome with how many people there are, and which share of rows is likely wrong."""
    table, run, footage = session.tracks, session.corrected_run, session.recording
    rows = table.columns()
    people = len(np.unique(rows["track"]))
    count = len(rows["frame"])
    items = find_review_items(table, run, footage.fps, session.labels, size=footage.size)
    wrong = sum(item.worth for item in items)
    return counted(outcome, people, min(1.0, wrong / count) if count else None)


def counted(outcome: Outcome, people: int, review_rows: float | None) -> Outcome:
    """The outcome with so many people, and this share of rows that is likely wrong."""
    notes = outcome.notes if people else (*outcome.notes, msg("nobody was found"))
    return replace(outcome, people=people, review_rows=review_rows, notes=notes)


def thumbnail_of(recording: Recording, session: Session) -> bytes:
    """A small JPEG image of the frame with the most people, and their boxes.

    Raises RecordingError where that frame cannot be read.
    """
    rows = session.tracks.columns()
    frame = recording.frame_count // 2
    if len(rows["frame"]):
        frame = int(np.argmax(np.bincount(rows["frame"])))
    return draw_thumbnail(recording.read(frame).left, rows, frame)


def draw_thumbnail(picture: Image, rows: Columns, frame: int) -> bytes:
    """A small JPEG image of a picture, with the boxes that rows have in a frame."""
    scale = _WIDTH_PX / picture.shape[1]
    small = cv2.resize(picture, None, fx=scale, fy=scale, interpolation=cv2.INTER_AREA)
    small = cv2.cvtColor(small, cv2.COLOR_GRAY2BGR) if small.ndim == len(("y", "x")) else small
    for left, top, width, height in scale * boxes_of(rows, rows["frame"] == frame):
        if np.isfinite([left, top, width, height]).all():
            first, last = (round(left), round(top)), (round(left + width), round(top + height))
            cv2.rectangle(small, first, last, _INK, 1)
    packed = cv2.imencode(".jpg", small, [cv2.IMWRITE_JPEG_QUALITY, _QUALITY])[1]
    return bytes(packed.tobytes())


def truth_digest(recording: Recording) -> str:
    """A digest of the ground truth beside a recording; "": there is none."""
    place = recording.truth_path
    return "" if place is None else hashlib.sha256(place.read_bytes()).hexdigest()


def score_result(
    outcome: Outcome, task: Task, recording: Recording, session: Session, known: Outcome | None
) -> Outcome:
    """The outcome with its score where there is ground truth; the page on it is written.

    A truth that cannot be read is told in a note: the tracks are done all the same. Raises
    OutputError where the page cannot be written.

    Args:
        known: what became of the same session before; a score against the same truth holds.
    """
    digest = truth_digest(recording)
    if not digest:
        return outcome
    outcome = replace(outcome, truth=digest)
    try:
        assert recording.truth_path is not None, "it has a digest"
        truth = truth_table(recording.truth_path)
        outcome = replace(outcome, notes=(*outcome.notes, *_outlasting(truth, recording)))
        if known is not None and (held := _held_score(task, known, digest)):
            score, page = held
        else:
            score, page = _scored(task, recording, session, truth)
    except OutputError:  # of the disk, not of the truth
        raise
    except TrackwrightError as error:
        note = msg("it is not scored: {why}", why=error)
        return replace(outcome, notes=(*outcome.notes, note))
    return replace(outcome, score=score, page=page)


def _held_score(task: Task, known: Outcome, digest: str) -> tuple[Mapping[str, Any], bool] | None:
    """The score of before and whether its page is there, if nothing is to be made anew."""
    if known.score is None or known.truth != digest:
        return None
    page = known.page and score_page(task.out, task.name).is_file()
    return (known.score, page) if page or not task.order.report else None


def _outlasting(truth: ScoringTable, recording: Recording) -> tuple[Message, ...]:
    """What to note where people count as missed in frames that the recording does not have."""
    frames, end = recording.frame_count, _end_of(truth)
    if end <= frames:
        return ()
    note = msg(
        "the ground truth goes on to frame {end}, the recording has {frames}, and all are "
        "scored; to score the recording's, use trackwright score with --frames 0:{frames}",
        end=end,
        frames=frames,
    )
    return (note,)


def _scored(
    task: Task, recording: Recording, session: Session, truth: ScoringTable
) -> tuple[Mapping[str, Any], bool]:
    """The score, and whether a page was written. Raises OutputError."""
    subject = _subject(task, recording, session, truth)
    finding = finding_of(subject, task.name, Yardstick())
    score = {
        name: _plain(value)
        for name, value in finding.score.as_json().items()
        if name not in _LEFT_OUT
    }
    if not task.order.report:
        return score, False
    none = msg("the boxes of people in the images are unknown")
    shown = {finding: shown_of(finding, 1, lambda *_: None, none)}
    write_score_report(task.workplace.page, report_of([finding], Yardstick()), shown)
    return score, True


def truth_table(place: Path) -> ScoringTable:
    """Ground truth in MOT text, to score against. Raises FormatError where a row is invalid."""
    truth = measurable(place, FORMATS["mot"], Filmed()).all_of(place)
    return ScoringTable.from_columns(truth.columns, dont_cares=truth.dont_cares)


def _end_of(table: ScoringTable) -> int:
    """The frame after the last one that has a row."""
    return int(table.frame.max(initial=-1)) + 1


def _subject(task: Task, recording: Recording, session: Session, true: ScoringTable) -> Subject:
    place = recording.truth_path
    assert place is not None
    found = ScoringTable.from_columns(session.tracks.columns())
    run = session.corrected_run
    source = Source(
        f"{task.name}.h5",
        recording.name,
        recording.frame_count,
        recording.fps,
        "" if run is None else run.tracker,
    )
    return Subject(
        task.name,
        true,
        {task.name: found},
        0,
        max(_end_of(true), _end_of(found), recording.frame_count),
        Footage(recording.fps, recording.size, recording.view, recording),
        Source(place.name, recording.name, fps=recording.fps),
        {task.name: source},
    )


def _plain(value: Any) -> Any:
    """Numbers as JSON holds them."""
    if isinstance(value, Mapping):
        return {name: _plain(each) for name, each in value.items()}
    if isinstance(value, (np.integer, np.floating)):
        value = value.item()
    return None if isinstance(value, float) and not math.isfinite(value) else value


def export_result(
    outcome: Outcome, task: Task, recording: Recording, session: Session, known: Outcome | None
) -> Outcome:
    """The outcome with the files of other tools that were asked for.

    A format that cannot hold the tracks is told; the others are written all the same.

    Args:
        known: what became of the same session before: formats written then stay.
    """
    exports: dict[str, tuple[str, ...]] = {}
    problems: dict[str, Message] = {}
    before = (known.exports if known is not None else None) or {}
    for name in task.order.exports:
        if name in before and all((task.out / file).exists() for file in before[name]):
            exports[name] = before[name]
            continue
        try:
            exports[name] = _exported(name, task, recording, session)
        except OutputError:
            raise
        except TrackwrightError as error:
            problems[name] = error.message
    notes = (
        *outcome.notes,
        *(msg("no {format}: {why}", format=name, why=why) for name, why in problems.items()),
    )
    return replace(outcome, exports=exports, export_problems=problems, notes=notes)


def _exported(name: str, task: Task, recording: Recording, session: Session) -> tuple[str, ...]:
    """The files that were made, as they stand in the output folder in the end."""
    wanted = FORMATS[name]
    assert wanted.write is not None
    footage = session.recording
    tracks = Exported.of_table(
        session.tracks,
        frames=footage.frame_count,
        fps=footage.fps,
        size_px=footage.size,
        name=footage.name,
        labels=dict(session.labels.tracks),
        view=recording.view if wanted.in_camera else None,
        corrected=True,
    )
    folder = task.workplace.exports / name
    folder.mkdir(parents=True, exist_ok=True)
    ending = "" if wanted.is_folder else wanted.extensions[0]
    made = wanted.write(folder / f"{task.name}{ending}", tracks, lambda *_: None)
    top = task.workplace.exports
    return tuple(str(Path("export") / file.relative_to(top)) for file in made)

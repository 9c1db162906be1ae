"""`track`: a tracker over a recording, into a session."""

from __future__ import annotations

import time
from collections.abc import Callable, Iterator, Sequence
from contextlib import closing, contextmanager
from dataclasses import replace
from itertools import chain, count
from pathlib import Path
from typing import Any

from app.cli.destination import check_file, is_session, read_file_kind
from app.cli.failure import EndedEarlyError
from app.cli.option_groups import Bare, Order
from app.cli.output import print_json, print_line, progress, say
from app.cli.part_options import refuse_missing_detector, settings_texts
from app.cli.ranges import parse_range
from app.cli.recordings import open_with_options
from app.cli.setting_texts import pairs_of
from app.core.document.document_loader import remember_place
from tracking.errors import (
    OutputError,
    SessionError,
    TrackwrightError,
    told_by_system,
)
from tracking.formats.schema_files import schema_of_project
from tracking.pipeline import Tracking, track
from tracking.pipeline.nobody_found import why_nobody
from tracking.recording import Recording
from tracking.session import IMPORTED, Session
from tracking.trackers import TrackerSpec, best_tracker, parse_settings, tracker_named
from tracking.trackers.step_watch import limited_steps
from tracking.tracks import Labels, Run
from tracking.translation import all_of, count_msg, message_of, msg

BYTES_A_FRAME = 64 << 10
"""Of a session and what is put aside while it is made, with ten people all the time."""


def run_track(
    path: Path | None, bare: Bare, out: Path, order: Order, *, force: bool, as_json: bool
) -> None:
    """Track and print where the session is."""
    if order.tracker is not None:  # a wrong name or setting is told before anything is opened
        settings_of(tracker_named(order.tracker), order)
    with open_with_options(path, bare, msg("go on from it with track --again")) as recording:
        check_file(out, recording.frame_count * BYTES_A_FRAME)
        refuse_to_lose(out, force=force)
        for note in recording.notes:
            say(msg("note: {note}", note=note))
        if order.tracker is None and (unused := _unused(recording)):
            say(msg("note: {unused}", unused=unused))
        began_s = time.perf_counter()
        with save_partial_run(recording, out):
            run = track_recording(recording, order, out.parent)
        rate = (run.frames[1] - run.frames[0]) / (time.perf_counter() - began_s)
        save_session(recording, run, out)
    people = len(set(run.tracks["track"].tolist()))
    if as_json:
        facts = {"tracker": run.tracker, "tracks": people, "frames": list(run.frames)}
        print_json({"session": str(out), **facts, "frames_a_second": rate})
    else:
        tracks = count_msg(people, "{n} track", "{n} tracks")
        say(
            msg(
                "{tracker}: {tracks}, {rate:.1f} frames per second",
                tracker=run.tracker,
                tracks=tracks,
                rate=rate,
            )
        )
        if not people and not set(run.notes).difference(recording.notes):
            say(msg("note: {why}", why=why_nobody(recording, run.tracker)))
        print_line(out)


def _unused(recording: Recording) -> str:
    """What of a recording is left unused for want of a calibration or a floor; "": nothing."""
    if recording.calibration is not None and recording.ground is not None:
        return ""
    missing = (
        msg("calibration")
        if recording.calibration is None
        else msg("height and tilt of the camera")
    )
    unused = [msg("the right camera")] if recording.is_stereo else []
    unused += [msg("height"), msg("tilt")] if recording.ground is not None else []
    if not unused:
        return ""
    which = (
        msg("{several} are", several=all_of(unused))
        if len(unused) > 1
        else msg("{one} is", one=unused[0])
    )
    tracker = best_tracker(recording)
    return msg(
        "no {missing}: {tracker} tracks people with the left camera; {which} not used",
        missing=missing,
        tracker=tracker,
        which=which,
    )


def track_recording(recording: Recording, order: Order, spool: Path) -> Run:
    """The run of a tracker over the recording, with a progress bar.

    What turned out odd on the way is told in the end.

    Args:
        spool: the folder for particles that are too many for the memory.

    Raises:
        SettingsError: unknown tracker or setting, or a wrong range.
        RecordingError, CalibrationError: the tracker cannot work on this recording.
    """
    spec = tracker_named(order.tracker or best_tracker(recording))
    settings = settings_of(spec, order)
    frames = parse_range(order.frames, recording.frame_count)
    with track(recording, spec.name, settings, order.seed, frames, spool=spool) as work:
        return run_to_end(work, recording, msg("tracking with {tracker}", tracker=spec.name))


def run_to_end(work: Tracking, recording: Recording, what: str) -> Run:
    """The run of a tracker at work, to its end, with a progress bar; what is odd is told.

    Raises TrackerEndedError where it could not go on after some frames, from what went wrong.
    """
    told = recording.notes
    try:
        _track_all(work, what)
        run = work.run()
    except Exception as error:
        if (run_so_far := work.run_so_far()) is None:
            raise
        raise TrackerEndedError(run_so_far, work.frames) from error
    notes = tuple(note for note in (*work.notes, *recording.notes) if note not in told)
    for note in notes:
        if note != work.doubt:
            say(msg("note: {note}", note=note))
    return replace(run, notes=notes)


def _track_all(work: Tracking, what: str) -> None:
    """Let a tracker work to its end; before its first frame the background is learnt."""
    start, stop = work.frames
    with limited_steps(work.tracker) as limited:
        with progress(msg("learning the background")) as learning:
            work.learning = learning
            result = limited(lambda: next(work, None))
        if work.doubt:  # at once: the rest may be in vain
            say(msg("note: {doubt}", doubt=work.doubt))
        with progress(what) as advance:
            while result is not None:
                advance(result.frame + 1 - start, stop - start)
                result = limited(lambda: next(work, None))


class TrackerEndedError(EndedEarlyError):
    """A tracker that could not go on; its cause says why.

    Attributes:
        run: over the frames until then; a note in it tells that it ended.
    """

    def __init__(self, run: Run, asked: tuple[int, int]) -> None:
        """asked: the half-open range of frames that was to be tracked."""
        (first, end), (start, stop) = run.frames, asked
        super().__init__(
            "{tracker} ended after {n} of {asked} frames",
            tracker=run.tracker,
            n=end - first,
            asked=stop - start,
        )
        self.run = replace(run, notes=(message_of(self),))


@contextmanager
def save_partial_run(
    recording: Recording, out: Path, save: Callable[[Run, Path], None] | None = None
) -> Iterator[None]:
    """Keep the frames that were tracked where the tracker within cannot go on.

    Args:
        out: the session that was to be made. What is kept stands beside it under a free name, so
            that nobody takes a part for the whole.
        save: makes a session of the run at a place; None: a new one of it alone.

    Raises EndedEarlyError, which says where it is kept, from what went wrong.
    """
    try:
        yield
    except TrackerEndedError as problem:
        try:
            place = _free_name(out)
            if save is None:
                save_session(recording, problem.run, place)
            else:
                save(problem.run, place)
        except (TrackwrightError, OSError) as error:
            why = told_by_system(error) or error
            kept = msg("what it tracked could not be kept: {why}", why=why)
        else:
            first, end = problem.run.frames
            kept = msg(
                "frames {first}:{end} are kept in {place}", first=first, end=end, place=place
            )
        raise EndedEarlyError(message_of(problem), kept) from problem.__cause__


def _free_name(out: Path) -> Path:
    """Beside a session that was to be made, a name that nothing has."""
    numbers = chain([""], (f"-{number}" for number in count(2)))
    places = (out.with_name(f"{out.stem}-partial{number}{out.suffix}") for number in numbers)
    return next(place for place in places if not place.exists())


def save_session(recording: Recording, run: Run, out: Path) -> None:
    """A new session of one run, in place of what stood there; it will find its recording.

    Whoever has not tracked it here has to allow a recording outside of the session's folder.
    """
    project = schema_of_project(recording.folder, out.parent)
    for note in project.notes:
        say(msg("note: {note}", note=note))
    labels = Labels(schema=project.schema)
    with closing(Session.create(recording, [run], out, labels=labels)) as session:
        remember_place(session, recording)
        if not session.recording.is_inside:
            say(
                msg(
                    "note: on another computer: trackwright open {name} --recording PATH "
                    "(the recording is in another folder)",
                    name=out.name,
                )
            )


def refuse_to_lose(out: Path, *, force: bool) -> None:
    """Refuse to replace what a tracker could not make again.

    A session nobody has worked on may be replaced: tracking again brings it back.

    Raises:
        OutputError: another file, or a session with somebody's work in it; a link to anything
            but a session, even with `force`.
    """
    if out.is_symlink() and not (out.is_file() and read_file_kind(out) is not None):
        raise OutputError(
            "cannot write {out}: it is a link that leads to no session",
            "name the file it leads to, or remove the link",
            out=out,
        )
    if force or not out.exists():
        return
    if lost := _lost_with(out):
        raise OutputError(
            "{out} is there: {lost} would be lost; choose another name or add --force",
            out=out,
            lost=lost,
        )


def _lost_with(out: Path) -> str:
    """What of a file no tracker brings back; "": it is a session nobody has worked on."""
    if not is_session(out):
        return msg("a file that is no session")
    try:
        with closing(Session.look_into(out)) as session:
            if has_work(session):
                return msg("what somebody did in it")
            if session.damage:
                return msg("what somebody may have done in it (it is damaged)")
            if any(session.runs.tracker_of(run) == IMPORTED for run in range(len(session.runs))):
                return msg("the tracks that were imported")
            return msg("one of its runs") if len(session.runs) > 1 else ""
    except SessionError:
        return msg("a file that cannot be read as a session")


def has_work(session: Session) -> bool:
    """Whether somebody corrected or labelled something in the session."""
    return len(session.history) > 0


def settings_of(spec: TrackerSpec, order: Order) -> Any:
    """The tracker's settings as the order has them.

    Raises SettingsError: there is no such setting or value, or no such file of a detector;
    FormatError, SessionError: a file that is named cannot be read.
    """
    return read_settings(spec, settings_texts(spec, order))


def read_settings(spec: TrackerSpec, texts: Sequence[str]) -> Any:
    """The tracker's settings with those typed as KEY=VALUE; raises `SettingsError`."""
    pairs = pairs_of(texts)
    refuse_missing_detector(pairs.get("detector", ""))
    return parse_settings(spec, pairs)

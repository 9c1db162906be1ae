"""`track --again`: from a frame of a corrected session on, with the people as corrected."""

from __future__ import annotations

import time
from collections.abc import Iterator, Mapping, Sequence
from contextlib import closing, contextmanager
from dataclasses import asdict, dataclass, fields
from pathlib import Path
from typing import Any

import typer

from app.cli.destination import check_file
from app.cli.option_groups import Bare, Onward, Order
from app.cli.output import print_json, print_line, say
from app.cli.part_options import settings_texts
from app.cli.track import (
    BYTES_A_FRAME,
    read_settings,
    refuse_to_lose,
    run_to_end,
    save_partial_run,
    settings_of,
)
from app.core.document.document_loader import open_path, remember_place
from tracking.detections import outside
from tracking.editing import Change, Difference, differences, plan_take
from tracking.errors import EditError, RecordingError, SessionError, SettingsError
from tracking.pipeline import track
from tracking.recording import OpenOptions, Recording
from tracking.session import RecordingMissing, Session
from tracking.session.notes import tell
from tracking.trackers import (
    TRACKERS,
    Resume,
    best_tracker,
    settings_from,
    settings_values,
    tracker_named,
)
from tracking.tracks import Run
from tracking.translation import msg


@dataclass(frozen=True, slots=True)
class TrackAgainRequest:
    """What is to be tracked again.

    Attributes:
        session: whose corrected tracks to go on from. recording: where it is by now, if it moved.
        start, until: half-open range of frames; until None: to the end.
        out: the session to make; None: the same one, where anything is kept.
        accept: take what changes. allow_outside: follow paths out of the recording's folder.
    """

    session: Path
    start: int
    until: int | None = None
    recording: Path | None = None
    out: Path | None = None
    accept: bool = False
    allow_outside: bool = False


def parse_request(
    onward: Onward, recording: Path | None, out: Path | None, bare: Bare
) -> TrackAgainRequest | None:
    """What the options ask for; None where they do not ask to track again.

    Raises:
        typer.BadParameter: some of them are missing, or say nothing to a session.
    """
    if onward.again is None:
        given = {"--from": onward.start is not None, "--until": onward.until is not None}
        given["--accept"] = onward.accept
        if any(given.values()):
            named = next(name for name, is_given in given.items() if is_given)
            raise typer.BadParameter(msg("it needs a session, --again NAME.h5"), param_hint=named)
        return None
    if onward.start is None:
        raise typer.BadParameter(msg("name the first frame to track again"), param_hint="--from")
    _refuse_bare_options(bare, recording)
    place = recording or bare.left
    return TrackAgainRequest(
        onward.again, onward.start, onward.until, place, out, onward.accept, bare.allow_outside
    )


def _refuse_bare_options(bare: Bare, recording: Path | None) -> None:
    """A session knows its recording; `--left` may name where that is by now, as RECORDING may."""
    known = {"allow_outside"} if recording is not None else {"allow_outside", "left"}
    for option in (field.name for field in fields(bare) if field.name not in known):
        if getattr(bare, option) is not None:
            raise typer.BadParameter(
                msg("the session of --again says what its recording is; leave it out"),
                param_hint=f"--{option}",
            )


def run_track_again(
    request: TrackAgainRequest, order: Order, *, force: bool, as_json: bool
) -> None:
    """Track again, print what would change, and with `accept` take it."""
    if order.frames is not None:
        raise typer.BadParameter(
            msg("tracking again takes --from and --until"), param_hint="--frames"
        )
    if order.tracker is not None:  # a wrong name or setting is told before anything is opened
        settings_of(tracker_named(order.tracker), order)
    with _opened(request) as (session, recording):
        _check_place(session, recording, request, force=force)
        began_s = time.perf_counter()
        with _keeping(session, recording, request):
            run = _tracked_again(session, recording, request, order)
        rate = (run.frames[1] - run.frames[0]) / (time.perf_counter() - began_s)
        found = differences(
            session.tracks, session.labels, session.history, run, run.frames, fps=recording.fps
        )
        change = _taken(session, recording, run) if request.accept else None
        kept = _keep(session, recording, run, change, request)
    if as_json:
        print_json(_as_json(run, rate, found, change, kept))
    else:
        _tell(run, rate, found, change, kept)


@contextmanager
def _opened(request: TrackAgainRequest) -> Iterator[tuple[Session, Recording]]:
    if request.session.suffix.lower() != ".h5":
        raise SessionError(
            "{session} is no session; make one with track -o NAME.h5 first", session=request.session
        )
    if request.recording is not None and not request.recording.exists():
        raise RecordingError(
            "there is nothing at {recording}; check the path", recording=request.recording
        )
    options = OpenOptions(allow_outside=request.allow_outside)
    try:
        opening = open_path(request.session, request.recording, options)
    except RecordingMissing as missing:
        raise missing.advising("name its place (track RECORDING --again ...)") from missing
    with closing(opening) as opened:
        session = opened.document.session
        assert session is not None
        _check_named(session, opened.document.recording, request)
        for note in session.notes:
            tell(note)  # also that it is for reading only; what was told already is not repeated
        yield session, opened.document.recording


def _check_named(session: Session, recording: Recording, request: TrackAgainRequest) -> None:
    """Refuse a named recording that is not the session's own, which was found elsewhere then."""
    named = request.recording
    if named is None:
        return
    folder = recording.folder.resolve()
    # As where a moved one is looked for: itself, the folder it stands in, or a file of it.
    meant = {named.resolve(), (named / folder.name).resolve()}
    files = [folder / "recording.toml", *(source.resolve() for source in recording.sources)]
    if folder not in meant and named.resolve() not in files:
        raise RecordingMissing(
            '{named} is not the recording of {session} ("{name}"); name that one or leave it out',
            named=named,
            session=request.session,
            name=session.recording.name,
        )


def _check_place(
    session: Session, recording: Recording, request: TrackAgainRequest, *, force: bool
) -> None:
    """Refuse before the work what could not be saved after it."""
    if request.out is not None and request.out.resolve() == request.session.resolve():
        raise typer.BadParameter(msg("leave it out to keep the same session"), param_hint="--out")
    if request.out is not None:
        check_file(request.out, recording.frame_count * BYTES_A_FRAME)
        refuse_to_lose(request.out, force=force)
    elif request.accept and session.read_only:
        raise SessionError(
            "{session} is open for reading only, so no changes can be applied to it; name "
            "another session with -o",
            session=request.session,
        )


def _tracked_again(
    session: Session, recording: Recording, request: TrackAgainRequest, order: Order
) -> Run:
    """The new run: by default the same tracker with the settings of the run that was corrected."""
    if not 0 <= request.start < recording.frame_count:
        raise SettingsError(
            "frame {start}: tracking again goes on from one of the frames 0 to {last}; choose "
            "--from there",
            start=request.start,
            last=recording.frame_count - 1,
        )
    name, settings = _tracker(session, recording, request, order)
    stop = recording.frame_count if request.until is None else request.until
    resume = None
    if request.start:
        given = session.detections_input
        resume = Resume.of(session.tracks, request.start, recording.fps, detections_input=given)
    asked = (name, settings, order.seed, (request.start, stop), resume)
    spool = (request.out or request.session).parent
    with track(recording, *asked, spool=spool) as work:
        return run_to_end(
            work,
            recording,
            msg("tracking again from frame {start} with {name}", start=request.start, name=name),
        )


def _tracker(
    session: Session, recording: Recording, request: TrackAgainRequest, order: Order
) -> tuple[str, Any]:
    """The tracker's name and settings: those of the run that was corrected, but for what is typed.

    Where that run is not one of a tracker that is built, as an imported one: the best tracker.
    """
    before = session.runs[session.adopted_run or 0] if len(session.runs) else None
    known = before if before is not None and before.tracker in TRACKERS else None
    spec = tracker_named(order.tracker or (known.tracker if known else best_tracker(recording)))
    texts = settings_texts(spec, order)
    typed = read_settings(spec, texts)
    if known is None or known.tracker != spec.name:
        return spec.name, typed
    named = {text.partition("=")[0].strip() for text in texts}
    values = {k: v for k, v in settings_values(typed).items() if k in named}
    if not request.allow_outside:
        _refuse_outside({k: v for k, v in known.settings.items() if k not in named})
    return spec.name, settings_from(spec.settings_type, {**known.settings, **values})


def _refuse_outside(settings: Mapping[str, Any]) -> None:
    """Refuse detections that a session, not the user, names outside of the recording's folder."""
    if named := outside(settings):
        raise SettingsError(
            "{named}: these detections, which the tracks were made with, are not in the folder "
            "of the recording: name them (--detections), or add --allow-outside",
            named=named,
        )


def _taken(session: Session, recording: Recording, run: Run) -> Change | None:
    """What taking the run changes; None: nothing."""
    try:
        return plan_take(
            session.tracks, session.labels, session.history, run, run.frames, fps=recording.fps
        )
    except EditError as nothing:
        say(msg("note: {nothing}", nothing=nothing))
        return None


def _keep(
    session: Session,
    recording: Recording,
    run: Run,
    change: Change | None,
    request: TrackAgainRequest,
) -> Path | None:
    """Save the run and what is taken of it; gives where, None where nothing is to be kept.

    With a place of its own the session tracked from stays as it is, its journal too.
    """
    if request.out is not None:
        _copy(session, request.out)
        with closing(Session.open(request.out)) as copy:
            return _saved(copy, recording, run, change)
    return _saved(session, recording, run, change) if request.accept else None


@contextmanager
def _keeping(session: Session, recording: Recording, request: TrackAgainRequest) -> Iterator[None]:
    """Where the tracker cannot go on: its run beside the others in a copy of the session.

    The session tracked from stays as it is; where nothing was to be kept, nothing is.
    """
    if request.out is None and not request.accept:
        yield
        return

    def save(run: Run, place: Path) -> None:
        _copy(session, place)
        with closing(Session.open(place)) as copy:
            _saved(copy, recording, run, None)

    with save_partial_run(recording, request.out or request.session, save):
        yield


def _saved(session: Session, recording: Recording, run: Run, change: Change | None) -> Path:
    session.add_run(run, adopt=False)
    if change is not None:
        session.apply(change)
    place = session.save()
    remember_place(session, recording)
    return place


def _copy(session: Session, out: Path) -> None:
    """The session as it is now, under another name."""
    pending = session.begin_save(out)
    try:
        pending.write()
    finally:
        session.abandon_save(pending)


def _as_json(
    run: Run,
    rate: float,
    found: Sequence[Difference],
    change: Change | None,
    kept: Path | None,
) -> dict[str, Any]:
    return {
        "session": None if kept is None else str(kept),
        "tracker": run.tracker,
        "frames": list(run.frames),
        "frames_a_second": rate,
        "tracks": len(set(run.tracks["track"].tolist())),
        "taken": None if change is None else change.text,
        "differences": [asdict(each) for each in found],
    }


def _tell(
    run: Run,
    rate: float,
    found: Sequence[Difference],
    change: Change | None,
    kept: Path | None,
) -> None:
    tracked = msg("frames {first} to {last}", first=run.frames[0], last=run.frames[1] - 1)
    say(
        msg(
            "{tracker}: {tracked}, {rate:.1f} frames per second",
            tracker=run.tracker,
            tracked=tracked,
            rate=rate,
        )
    )
    for each in found:
        stays = msg("  (protected, stays as it is)") if each.protected else ""
        print_line(
            msg(
                "frames {start} to {last}: {text}{stays}",
                start=each.start,
                last=each.end - 1,
                text=each.text,
                stays=stays,
            )
        )
    if not found:
        say(msg("nothing would change") if change is None else msg("nothing changes by much"))
    if change is not None:
        say(change.text)
    elif found and kept is None:
        say(msg("nothing is kept; add --accept to apply this, or -o OUT to keep the run beside it"))
    if kept is not None:
        say(msg("saved in {kept}", kept=kept))

"""The recording a score is of, for the pictures in its report."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from contextlib import ExitStack, contextmanager
from dataclasses import replace
from pathlib import Path

from app.cli.destination import is_session
from app.cli.score_inputs import LoadedSequence
from tracking.errors import TrackwrightError
from tracking.recording import MANIFEST_NAME, Recording, open_recording
from tracking.scoring.report import Footage, Subject
from tracking.translation import msg

_PICTURES = "img1"
"""Where MOTChallenge keeps the frames of a sequence."""


@contextmanager
def open_recording_of(one: LoadedSequence, *, allow_outside: bool) -> Iterator[tuple[Subject, str]]:
    """A sequence with its recording open for as long as the block runs, and why it is not.

    Args:
        allow_outside: a recording outside of its session's folder may be opened.
    """
    with ExitStack() as stack:
        reason: str = msg("no recording stands beside the ground truth or belongs to a session")
        for opened in _ways(one, allow_outside=allow_outside):
            try:
                recording = opened(stack)
            except TrackwrightError as error:
                reason = _advised(error, allow_outside=allow_outside)
                continue
            yield replace(one.subject, footage=_footage(recording, one.subject.footage)), ""
            return
        yield one.subject, reason


def _ways(
    one: LoadedSequence, *, allow_outside: bool
) -> Iterator[Callable[[ExitStack], Recording]]:
    """Where the recording may be: beside the truth, or where a session says."""
    truth = one.truth.path
    if (truth.parent / MANIFEST_NAME).is_file():
        yield lambda stack: stack.enter_context(open_recording(truth.parent))
    pictures = truth.parent.parent / _PICTURES
    if truth.parent.name == "gt" and pictures.is_dir():
        yield lambda stack: stack.enter_context(open_recording(pictures))
    for tracks in (one.truth, *one.results.values()):
        if not tracks.is_text and is_session(tracks.path):
            yield _of_session(tracks.path, allow_outside=allow_outside)


def _of_session(path: Path, *, allow_outside: bool) -> Callable[[ExitStack], Recording]:
    from tracking.session import Session

    def opened(stack: ExitStack) -> Recording:
        session = Session.look_into(path)
        stack.callback(session.close)
        return stack.enter_context(session.open_recording(allow_outside=allow_outside))

    return opened


def _advised(error: TrackwrightError, *, allow_outside: bool) -> str:
    """Why there is no recording, and what can be done about it here."""
    from app.cli.training_set import with_advice  # brings sessions, too

    return with_advice(error, allow_outside)


def _footage(recording: Recording, told: Footage) -> Footage:
    """What the recording tells; the files' own rate of frames counts before that of pictures."""
    return Footage(told.fps or recording.fps, recording.size, recording.view, recording)

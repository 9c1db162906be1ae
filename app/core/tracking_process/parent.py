"""The parent's end of a tracker in a process of its own."""

from __future__ import annotations

import contextlib
import subprocess
import threading
from collections.abc import Iterator
from typing import IO

from app.core.tracking_process.messages import (
    Kind,
    receive,
    unpacked_error,
    unpacked_input,
    unpacked_learning,
    unpacked_notes,
    unpacked_steps,
)
from app.core.tracking_process.request import TrackingRequest
from app.core.tracking_process.step_watch import StepWatch
from tracking import child_program
from tracking.errors import TrackwrightError
from tracking.plugins.time_limit import overdue
from tracking.progress import Progress, no_progress
from tracking.trackers import TRACKERS, StepResult, tracker_named
from tracking.tracks import DetectionsInput
from tracking.translation import Message

_GRACE_S = 3.0


class TrackerProcess:
    """Runs a tracker in a child process.

    `batches` belongs to one thread and waits; `stop` and `kill` may be called from any other one
    and never wait. The child ends with this process, also where that is killed.

    Attributes:
        notes: what the user should be told of the tracking, a line each; known at its end.
        detections_input: files of another program's detections it was given; known at its end.
    """

    def __init__(self, request: TrackingRequest, learning: Progress = no_progress) -> None:
        """learning: told, by the thread that waits, how much of the background is read."""
        self._learning = learning
        self.notes: tuple[Message, ...] = ()
        self.detections_input: tuple[DetectionsInput, ...] = ()
        self._request = request
        self._offer = TRACKERS.offer(request.tracker)
        self._watch: StepWatch | None = None
        self._lock = threading.Lock()
        self._child: subprocess.Popen[bytes] | None = None
        self._stopping = threading.Event()
        self._overdue = threading.Timer(_GRACE_S, self.kill)

    @property
    def pid(self) -> int:
        """The child's number; 0 before it has begun."""
        return self._child.pid if self._child is not None else 0

    def batches(self) -> Iterator[tuple[StepResult, ...]]:
        """Start the child; its results in order, as they come.

        Raises:
            TrackwrightError: what the tracker told, or the child has died.
            TrackerBug: anything else that went wrong in the child.
        """
        child = self._begin()
        if child is None:
            return
        assert child.stdout is not None
        try:
            while (message := self._next(child.stdout)) is not None:
                kind, payload = message
                if kind is Kind.STEPS:
                    yield unpacked_steps(payload)
                elif kind is Kind.LEARNING:
                    self._learning(*unpacked_learning(payload))
                elif kind is Kind.ERROR:
                    raise unpacked_error(payload)
                elif kind is Kind.NOTES:
                    self.notes = unpacked_notes(payload)
                elif kind is Kind.DETECTIONS_INPUT:
                    self.detections_input = unpacked_input(payload)
                else:
                    return
            self._check_death(child)
        finally:
            self._end(child)

    def _next(self, answers: IO[bytes]) -> tuple[Kind, bytes] | None:
        """The child's next message; a plug-in's is waited for as long as its entry says."""
        if self._watch is None:
            return receive(answers)
        self._watch.begin()
        try:
            return receive(answers)
        finally:
            self._watch.pause()

    def stop(self) -> None:
        """Ask for the end after the frame in work; who does not obey in time is killed."""
        with self._lock:
            if self._stopping.is_set():
                return
            self._stopping.set()
            if self._child is not None and self._child.stdin is not None:
                with contextlib.suppress(OSError, ValueError):
                    self._child.stdin.write(b"stop\n")
                    self._child.stdin.flush()
                self._overdue.start()

    def kill(self) -> None:
        """End the child at once; it has nothing to put in order."""
        with self._lock:
            self._stopping.set()
            if self._child is not None:
                self._child.kill()

    def _begin(self) -> subprocess.Popen[bytes] | None:
        """The child, at work; None where its end was asked for before it began."""
        with self._lock:
            if self._stopping.is_set():
                return None
            self._child = child_program.begin("-m", "app.core.tracking_process.child")
        if self._offer is not None and not self._offer.built_in:
            limit_s = tracker_named(self._request.tracker).step_limit_s
            self._watch = StepWatch(limit_s, self.kill)
        assert self._child.stdin is not None
        with contextlib.suppress(OSError):  # died at once: told when its answers are read
            self._child.stdin.write(self._request.as_line())
            self._child.stdin.flush()
        return self._child

    def _check_death(self, child: subprocess.Popen[bytes]) -> None:
        if self._watch is not None and self._watch.is_overdue and self._offer is not None:
            raise overdue(self._offer, tracker_named(self._request.tracker).step_limit_s)
        if not self._stopping.is_set():
            raise TrackwrightError(
                "{tracker} ended by itself (status {status}), perhaps for want of "
                "memory; track a shorter range, or again",
                tracker=self._request.tracker if self._offer is None else self._offer.words,
                status=child.wait(),
            )

    def _end(self, child: subprocess.Popen[bytes]) -> None:
        self.kill()
        if self._watch is not None:
            self._watch.end()
        self._overdue.cancel()
        if self._overdue.is_alive():
            self._overdue.join()
        child_program.end(child)

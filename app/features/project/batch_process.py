"""A batch that the window starts: `trackwright batch` in a process that the window may outlive."""

from __future__ import annotations

import os
import subprocess
import tempfile
from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path

from app.core.i18n import tr
from tracking import child_program
from tracking.translation import language_environment

DONE, NONE_DONE, SOME_FAILED, INTERRUPTED = 0, 1, 3, 130
_LONGEST_LINE = 4000


@dataclass(frozen=True, slots=True)
class BatchWish:
    """What is to be tracked.

    Attributes:
        recordings: their paths. out: the output folder. tracker: its name; "": the best for each.
    """

    recordings: tuple[Path, ...]
    out: Path
    tracker: str = ""


class BatchProcess:
    """The command at work; a window that closes leaves it going, unless it is stopped."""

    def __init__(self, wish: BatchWish) -> None:
        """Start it. Raises OSError where it cannot be."""
        self.wish = wish
        self._errors = tempfile.TemporaryFile()  # noqa: SIM115 - closed by `close`
        self._child = _started(command_of(wish), self._errors.fileno())

    @property
    def status(self) -> int | None:
        """The exit status; None: it works."""
        return self._child.poll()

    def stop(self) -> None:
        """Ask it to end, which it does as after Ctrl-C: nothing half-done is kept."""
        if self.status is None:
            self._child.terminate()

    def wait(self, patience_s: float) -> bool:
        """Wait until it has ended; False where it did not within that time."""
        try:
            self._child.wait(patience_s)
        except subprocess.TimeoutExpired:
            return False
        return True

    def told(self) -> str:
        """What it says in the end, in a sentence."""
        status = self.status
        if status == DONE:
            return tr("The batch is done.")
        if status == SOME_FAILED:
            return tr("The batch is done; some recordings failed: the list says why.")
        if status in (INTERRUPTED, -15):
            return tr("The batch was stopped. Started again, it goes on from here.")
        why = self._last_line()
        if status == NONE_DONE and not why:
            return tr("The batch tracked no recording: the list says why.")
        return tr("The batch ended early: {why}", why=why or tr("it does not say why"))

    def close(self) -> None:
        """Let go of it; it goes on by itself."""
        self._errors.close()

    def _last_line(self) -> str:
        """The last thing it said of what is wrong."""
        size = self._errors.seek(0, os.SEEK_END)
        self._errors.seek(max(0, size - _LONGEST_LINE))
        lines = self._errors.read().decode("utf-8", "replace").splitlines()
        own = [line for line in lines if line.startswith("trackwright: ")]
        return own[-1].removeprefix("trackwright: ") if own else ""


def command_of(wish: BatchWish) -> list[str]:
    """What is run, after the interpreter and its options."""
    tracker = ["--tracker", wish.tracker] if wish.tracker else []
    paths = [os.path.abspath(path) for path in wish.recordings]  # noqa: PTH100 - links stay
    return ["-m", "app", "batch", "-o", str(wish.out), *tracker, "--", *paths]


def _started(words: Sequence[str], errors: int) -> subprocess.Popen[bytes]:
    """A process of a session of its own: what ends the window's terminal does not end it."""
    return subprocess.Popen(
        child_program.command(*words),
        env=child_program.environment(language_environment()),
        stdin=subprocess.DEVNULL,
        stdout=subprocess.DEVNULL,
        stderr=errors,
        start_new_session=True,
        creationflags=getattr(subprocess, "CREATE_NO_WINDOW", 0),
    )

"""The built-in recording, which the command `demo` and the window's first page show."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path

from app.core.document.document_loader import own_folder
from tracking.errors import OutputError, TrackwrightError
from tracking.recording import open_recording
from tracking.synthesis import render_recording

SCENE, SECONDS, PEOPLE, SEED = "plaza", 20.0, 8, 4


@dataclass(frozen=True, slots=True)
class Demonstration:
    """A folder with the built-in recording and what is made of it."""

    folder: Path

    @classmethod
    def of_user(cls) -> Demonstration:
        """The one in the user's own data folder."""
        return cls(own_folder() / "demonstration")

    @property
    def recording(self) -> Path:
        """The recording's folder."""
        return self.folder / "recording"

    @property
    def session(self) -> Path:
        """Where its session is kept."""
        return self.folder / "session.h5"

    @property
    def picture(self) -> Path:
        """Where the picture of the window goes."""
        return self.folder / "window.png"

    def make(self, report: Callable[[int, int], None]) -> Path:
        """The recording, rendered where it is not there yet.

        Raises:
            OutputError: it cannot be written, or what is there is damaged.
        """
        if not self.recording.exists():
            return render_recording(self.recording, SCENE, SECONDS, PEOPLE, SEED, progress=report)
        try:
            open_recording(self.recording).close()
        except TrackwrightError as error:
            raise OutputError(
                "{error}; remove {recording} and it is made anew",
                error=error,
                recording=self.recording,
            ) from error
        return self.recording

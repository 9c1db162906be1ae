"""What a command does to the open recording."""

from __future__ import annotations

from collections.abc import Callable

from app.shell.recording_controller import RecordingController

RecordingHandler = Callable[[RecordingController], object]
"""Done to the controller of the open recording; what it gives is not looked at."""

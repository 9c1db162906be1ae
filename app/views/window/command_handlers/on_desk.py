"""What a command does to the open recording."""

from __future__ import annotations

from collections.abc import Callable

from app.views.desk.recording_controller import RecordingController

OnDesk = Callable[[RecordingController], object]
"""Done to the desk of the open recording; what it gives is not looked at."""

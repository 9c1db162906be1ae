"""Where a session's recording is: as the session file says it, and where it was found."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from pathlib import Path
from typing import TYPE_CHECKING

from tracking.session.known_recordings import KnownRecordings
from tracking.session.recording_lookup import find_recording
from tracking.session.reference import RecordingReference, relative

if TYPE_CHECKING:
    from tracking.recording import Recording


class Whereabouts:
    """A reference to a recording, and its folder once that is known.

    Attributes:
        reference: what the session says of the recording.
        place: its folder; None until it was found.
    """

    def __init__(self, reference: RecordingReference, place: Path | None = None) -> None:
        """A reference as it stands in a session file."""
        self.reference = reference
        self.place = place

    def open(
        self,
        folder: Path,
        search: Sequence[Path],
        known: KnownRecordings | None,
        *,
        allow_outside: bool,
    ) -> tuple[Recording, tuple[str, ...]]:
        """The recording of a session in that folder, and what has changed, a line each.

        Its place is remembered here and in known. Raises RecordingMissing.
        """
        before, last = self.reference, self.place
        if last is None and known is not None:
            last = known.find(before)
        found = find_recording(before, folder, search, last, allow_outside=allow_outside)
        self.place = found.recording.folder
        self.reference = before.relocated_to(found.recording, folder)
        if known is not None:
            known.remember(before, found.place)
            known.remember(self.reference, self.place)
        return found.recording, tuple(found.notes)

    def reference_from(self, folder: Path, session: Path | None) -> RecordingReference:
        """The reference for a session file in that folder; session: where it stood so far."""
        place = self.place
        if place is None and session is not None:
            place = session.parent / self.reference.path
        path = self.reference.path if place is None else relative(place, folder)
        return replace(self.reference, path=path)

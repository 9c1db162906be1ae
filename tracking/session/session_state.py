"""What an open session holds, to look at."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import replace
from pathlib import Path
from typing import TYPE_CHECKING

from tracking.editing import History
from tracking.session.backups import Backup, list_backups
from tracking.session.edited_tracks import EditedTracks
from tracking.session.image import Snapshot, Stamps
from tracking.session.known_recordings import KnownRecordings
from tracking.session.pending_save import PendingSave
from tracking.session.recording_lookup import find_recording
from tracking.session.reference import RecordingReference, relative
from tracking.session.runs import Runs
from tracking.session.samples import KeptSamples
from tracking.session.store import Store
from tracking.stamps import resolve_author
from tracking.tracks import Labels, Run, TrackTable
from tracking.translation import Message

if TYPE_CHECKING:
    from tracking.recording import Recording


class SessionState:
    """The state of a session that is open; only `Session` changes it.

    Attributes:
        colours: place in the window's palette by track, so that people look the same at every
            opening. Whoever shows the session may set it; it goes into the file at the next save.
    """

    def __init__(self, snapshot: Snapshot, path: Path | None, author: str) -> None:
        """Use `create` or `open`."""
        self._stamps = snapshot.stamps
        self._whereabouts = Whereabouts(snapshot.recording)
        self._edited = EditedTracks(snapshot.tracks, snapshot.labels, snapshot.history())
        self._adopted = snapshot.adopted
        self.colours: Mapping[int, int] = snapshot.colours
        self._runs = Runs(snapshot.runs)
        self._path = path
        self.author = author
        self._store: Store | None = None
        self._pending: PendingSave | None = None
        self._samples = KeptSamples()
        self._damage = list(snapshot.damage)
        self._findings = list(snapshot.findings)
        # The place of the finding of which the file is still as it was found.
        self._unkept = len(snapshot.findings) - 1 if snapshot.changed else None
        self._notes = list(self._damage)
        self._why_read_only = ""
        self._recovered = 0
        # What changed is counted; saved says which count the file holds, base which one the
        # journal builds on.
        self._content = self._saved = self._base = 0

    @property
    def path(self) -> Path | None:
        """The file; None where it was never saved."""
        return self._path

    @property
    def recording(self) -> RecordingReference:
        """The recording it is about."""
        return self._whereabouts.reference

    @property
    def tracks(self) -> TrackTable:
        """The corrected table; it changes in place, and only by `apply`, `undo` and `redo`."""
        return self._edited.tracks

    @property
    def labels(self) -> Labels:
        """What people said; a frozen value, another one after each edit that touches it."""
        return self._edited.labels

    @property
    def runs(self) -> Runs:
        """What trackers found, by number; never changed by edits."""
        return self._runs

    @property
    def adopted_run(self) -> int | None:
        """The number of the run the corrected table began as; None: of none."""
        return self._adopted

    @property
    def corrected_run(self) -> Run | None:
        """The run the corrected table began as; None where it began with nothing.

        Raises SessionError where it is still in the file and that cannot be read.
        """
        return None if self._adopted is None else self._runs[self._adopted]

    @property
    def is_untouched(self) -> bool:
        """Whether nothing was tracked or edited; it may have begun with labels."""
        return not (len(self._runs) or len(self.history) or len(self.tracks))

    def covers_corrected(self, run: Run) -> bool:
        """Whether a run is of all frames of the one the corrected table began as."""
        if self._adopted is None:
            return True
        start, stop = self._runs[self._adopted].frames
        return run.frames[0] <= start and stop <= run.frames[1]

    @property
    def history(self) -> History:
        """The log of edits."""
        return self._edited.history

    @property
    def created(self) -> str:
        """When it was made: UTC, ISO 8601."""
        return self._stamps.created

    @property
    def modified(self) -> str:
        """When it was saved last: UTC, ISO 8601."""
        return self._stamps.modified

    @property
    def author(self) -> str:
        """Who the log says made the edits from now on; may be set to another name at any time."""
        return self._author

    @author.setter
    def author(self, name: str) -> None:
        self._author = resolve_author(name)

    @property
    def dirty(self) -> bool:
        """Whether the session file misses something (the journal misses no edit)."""
        return self._content != self._saved

    @property
    def read_only(self) -> bool:
        """Whether it cannot be saved under its name; `notes` says why."""
        return self._path is not None and self._store is None

    @property
    def why_read_only(self) -> str:
        """Why it is open for reading only, in a line; "" where it is not."""
        return self._why_read_only if self.read_only else ""

    @property
    def recovered(self) -> int:
        """How many steps made after the last save were taken from the journal on opening."""
        return self._recovered

    @property
    def notes(self) -> tuple[Message, ...]:
        """What the user should be told of opening, a line each."""
        return tuple(self._notes)

    @property
    def damage(self) -> tuple[Message, ...]:
        """Those of the notes that say what of it is damaged or may be missing."""
        return tuple(self._damage)

    def list_backups(self) -> tuple[Backup, ...]:
        """What was saved before and is kept, the newest first: quick, no table is read."""
        return () if self._path is None else list_backups(self._path)

    def _as_it_is(self, stamps: Stamps, recording: RecordingReference) -> Snapshot:
        """All of it at this moment, to be saved."""
        return Snapshot(
            stamps=stamps,
            recording=recording,
            runs=self._runs.held(),
            tracks=self.tracks.snapshot(),
            adopted=self._adopted,
            labels=self.labels,
            edits=self.history.entries,
            touched=self.history.touches,
            began_as=self._runs.in_memory(self._adopted),
            samples=self._samples,
            colours=dict(self.colours),
            findings=tuple(self._findings),
        )


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
    ) -> tuple[Recording, tuple[Message, ...]]:
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

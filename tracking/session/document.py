"""The document: runs, corrected tracks, labels and the log of edits, safe on disk."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import replace
from pathlib import Path
from typing import TYPE_CHECKING

from tracking.editing import Change, Entry, StoredChange, plan_undo_alone, with_parts_carried
from tracking.errors import EditError, OutputError, SessionError
from tracking.owned_files import real_path
from tracking.session.backups import read_backup, with_runs_from
from tracking.session.image import Snapshot, Stamps, empty_snapshot
from tracking.session.journal import Act
from tracking.session.known_recordings import KnownRecordings
from tracking.session.notes import tell
from tracking.session.on_disk import OnDisk
from tracking.session.pending_edits import read_with_waiting
from tracking.session.pending_save import PendingSave, next_stamps
from tracking.session.reference import refer_to
from tracking.session.session_reader import read_session
from tracking.session.session_writer import UNLIMITED, file_state, find_backups, keep_damaged
from tracking.session.store import Store
from tracking.stamps import make_id, now, resolve_author, software
from tracking.tracks import DetectionsInput, Labels, Run, TrackTable
from tracking.translation import msg

if TYPE_CHECKING:
    from tracking.recording import Recording


class Session(OnDisk):
    """One recording's tracks as trackers found them and as people put them right.

    Used from one thread; only `PendingSave.write` may run on another. With a path, every edit is
    in the journal on disk before `apply` returns. Edits are logged under `author`, which may be
    set to another name at any time.
    """

    # Making and opening

    @classmethod
    def create(
        cls,
        recording: Recording,
        runs: Sequence[Run] = (),
        path: Path | None = None,
        *,
        author: str | None = None,
        colours: Mapping[int, int] | None = None,
        labels: Labels | None = None,
    ) -> Session:
        """A new session on a recording; with a path it is saved there at once.

        The corrected table begins as the first run's tracks, in these colours (see `Held`).
        Labels that it begins with, such as occluders, are no edits: a run is still begun with.
        Without a path nothing is on disk until `save` names one.
        Raises OutputError where it cannot be saved, SessionError where another program has it.
        """
        folder = path.parent if path is not None else recording.folder
        made = now()
        stamps = Stamps(make_id(), "", "", 0, made, made, software())
        empty = empty_snapshot(stamps, refer_to(recording, folder))
        session = cls(replace(empty, labels=labels or Labels()), None, resolve_author(author))
        for run in runs:
            session.add_run(run)
        session.colours = colours or {}
        session._whereabouts.place = recording.folder
        if path is not None:
            session.save(path)
        return session

    @classmethod
    def open(cls, path: Path, *, author: str | None = None) -> Session:
        """Open a session file, with the edits that were made after it was saved last.

        Read-only where another program has it, its folder cannot be written to, or a newer
        trackwright made it; `notes` says so, as it does when edits were recovered.
        Raises SessionError where the file is missing, no session, damaged, hostile or too new.
        """
        path = real_path(path)
        before = file_state(path)
        snapshot = read_session(path)
        session = cls(snapshot, path, resolve_author(author))
        try:
            if snapshot.newer:
                raise SessionError("made by a newer trackwright; saving would lose what it added")
            session._store = Store.claim(path)
            if file_state(path) != before:  # another program saved it a moment ago
                session.close()
                return cls.open(path, author=author)
            if session._store.has_files_of_journal:
                session._recover(session._store)
            session._tell_of_kept(path)
            session._begin_journal()
        except (SessionError, OutputError) as why:
            session._give_up_writing(str(why))
        except BaseException:
            session._let_go(keep_journal=True)
            raise
        return session

    @classmethod
    def look_into(cls, path: Path) -> Session:
        """A session file to be read only, with the edits that wait in its journal.

        Nothing beside it is claimed or written: whoever has it open, or opens it meanwhile, may
        write it. Raises SessionError as `open`.
        """
        path = real_path(path)
        read = read_with_waiting(path)
        session = cls(read.snapshot, path, resolve_author(None))
        session._edited, session._recovered = read.edited, read.waiting
        session._damage += read.damage
        session._notes += read.damage
        session._tell_of_kept(path)
        session._why_read_only = msg("it was opened to be read only")
        return session

    def close(self, *, discard: bool = False) -> None:
        """Let go of the file. Edits not saved stay in the journal unless they are discarded.

        Where the journal has vanished meanwhile, they are saved. Raises OutputError or SessionError
        where that is not possible, once all is let go of.
        """
        try:
            if self.dirty and not discard:
                self._keep_unsaved()
        finally:
            self._let_go(keep_journal=self.dirty and not discard)

    # Changing

    def apply(self, change: Change, written: StoredChange | None = None) -> Entry:
        """Make an edit; it is on disk when this returns. written: it, where that is at hand.

        Raises EditError where it does not apply, OutputError where it cannot be put on disk
        (nothing is changed then), SessionError for a session open for reading only.
        """
        change = with_parts_carried(change, self.labels)
        entry = self.history.draft(change, now(), self.author, written=written)
        return self._do("apply", entry, change)

    def undo(self) -> Entry:
        """Take the last edit back. Raises EditError where there is none, and as `apply`."""
        entry = self._edited.next("undo")
        return self._do("undo", entry, entry.change)

    def redo(self) -> Entry:
        """Make the edit taken back last again. Raises EditError where there is none."""
        entry = self._edited.next("redo")
        return self._do("redo", entry, entry.change)

    def undo_alone(self, number: int) -> Entry:
        """Take one older edit back and leave what was done after it; an edit of its own.

        Raises EditError that names the later edit which stands on it, and as `apply`.
        """
        change = plan_undo_alone(self.history, self.labels, number)
        entry = self.history.draft(change, now(), self.author, undoes=number)
        return self._do("apply", entry, change)

    @property
    def detections_input(self) -> tuple[DetectionsInput, ...]:
        """Detections of another program that the corrected tracks were made with; none if none."""
        return () if self._adopted is None else self._runs.detections_input_of(self._adopted)

    def add_run(self, run: Run, *, adopt: bool = True) -> int:
        """Add a tracker's result; gives its number.

        With adopt, and as long as nobody has edited anything, the corrected table becomes the
        run's tracks, unless they are of fewer frames than those it holds: of a tracking that was
        stopped, or begun in the middle. The run is on disk after the next `save`; the next edit
        sees to that itself.
        Raises EditError where the run's tracks are no table.
        """
        self._refuse_read_only()
        adopts = adopt and not len(self.history) and self.covers_corrected(run)
        table = self._table_of(run) if adopts else None
        number = self._runs.add(run)
        if table is not None:
            self._edited.tracks, self._adopted, self.colours = table, number, {}
        self._content += 1
        self._base = self._content
        return number

    def adopt_run(self, number: int) -> None:
        """Begin the corrected table anew as another run's tracks; on disk as after `add_run`.

        Raises EditError where somebody has edited: the edits are those of the table there is; and
        where the run is of fewer frames than the one begun with: people outside of them would go.
        """
        self._refuse_read_only()
        run = self._runs[number]
        if len(self.history):
            raise EditError(
                "run {number} cannot be begun with: the tracks have been edited; take from the "
                "run what it says otherwise",
                number=number,
            )
        if not self.covers_corrected(run):
            raise EditError(
                "run {number} cannot be begun with: it is of frames {first} to {last} alone; "
                "take from the run what it says otherwise",
                number=number,
                first=run.frames[0],
                last=run.frames[1] - 1,
            )
        self._edited.tracks, self._adopted, self.colours = self._table_of(run), number, {}
        self._content += 1
        self._base = self._content

    def _table_of(self, run: Run) -> TrackTable:
        """The run's tracks as a corrected table; ids that were ever given stay used."""
        return TrackTable(run.tracks, highest_track=self.tracks.highest_track)

    def drop_run(self, number: int) -> None:
        """Forget the last run. Raises EditError for another one, and for the one adopted."""
        self._refuse_read_only()
        self._runs.drop(number, self._adopted, saving=self._pending is not None)
        self._content += 1

    def _do(self, act: Act, entry: Entry, change: Change) -> Entry:
        self._refuse_read_only()
        if self._store is not None:
            self._make_sure(self._store)
            if self._saved < self._base:
                self._put_base_on_disk()
        known = 0 if self._store is None else self._store.steps
        try:
            logged = self._edited.do(act, entry, change, self._keep)
        except BaseException:
            if self._store is not None:
                self._store.take_back(known)
            raise
        self._content += 1
        return logged

    # Backups

    def restore(self, number: int) -> Session:
        """Have a backup back; gives that session, and this one is closed.

        Nothing is lost: what this session is now, with the edits that are not saved yet, is the
        newest backup then, and no backup is dropped before the next save.
        Raises SessionError where there is no such backup, it cannot be read, or this session
        is open for reading only; OutputError, with everything as it was, where saving fails.
        """
        self._refuse_read_only()
        path, store = self._path, self._store
        if path is None or store is None:
            raise SessionError("the session was never saved; there is nothing older to restore")
        file, older = read_backup(path, number)
        known = file_state(file)
        if self.dirty:
            self._write(replace(self.begin_save(), most=UNLIMITED))
        found = [kept for kept in find_backups(path) if file_state(kept) == known]
        if known is None or not found:
            raise SessionError(
                "{path}: backup {number} was deleted meanwhile", path=path, number=number
            )
        file = found[0]
        stamps = next_stamps(older.stamps, self._stamps, store)
        recording = self._whereabouts.reference
        if older.changed:
            older = _with_damaged_kept(older, keep_damaged(path, file).name)
        snapshot = replace(with_runs_from(older, file), stamps=stamps, recording=recording)
        pending = PendingSave(snapshot, path, 0, store, UNLIMITED)
        try:
            pending.write()
        except BaseException:
            if not self._is_own_file():  # the backup is in place: no edit of this one fits it
                self._saved, self._base = -1, self._content
            raise
        restored = Session(with_runs_from(snapshot, path), path, self.author)
        restored._whereabouts.place = self._whereabouts.place
        restored._store, self._store = store, None
        store.rebase(stamps.session, stamps.save, stamps.included)
        return restored

    def accept_damage(self) -> int:
        """Take the session as it is: damage that was found of it is told no more once it is saved.

        Gives how much there was; that it was found, and when accepted, stays in the file.
        Raises SessionError for a session open for reading only.
        """
        self._refuse_read_only()
        open_ones = [one for one in self._findings if not one.accepted]
        if open_ones:
            at = now()
            self._findings = [
                one if one.accepted else replace(one, accepted=at) for one in self._findings
            ]
            self._content += 1
        return len(open_ones)

    # The recording

    def open_recording(
        self,
        search: Sequence[Path] = (),
        known: KnownRecordings | None = None,
        *,
        allow_outside: bool = False,
    ) -> Recording:
        """The recording, found where it stands now and opened as the session saw it.

        See `find_recording` for where it is looked for and what counts. Its place is remembered in
        known, and in the session file when it is saved next; what has changed is in `notes`.
        Raises RecordingMissing, which says where it was and how to name its place.
        """
        folder = Path() if self._path is None else self._path.parent
        recording, notes = self._whereabouts.open(
            folder, search, known, allow_outside=allow_outside
        )
        self._notes += [tell(note) for note in notes if note not in self._notes]
        return recording


def _with_damaged_kept(older: Snapshot, kept: str) -> Snapshot:
    """A backup that was changed on being read; kept: the file that holds it as it was."""
    findings = (*older.findings[:-1], replace(older.findings[-1], kept=kept))
    return replace(older, findings=findings, changed=False)

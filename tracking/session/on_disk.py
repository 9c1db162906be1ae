"""An open session on disk: its file, and the journal of what was done since it was saved."""

from __future__ import annotations

import os
from dataclasses import replace
from pathlib import Path

from tracking.editing import Entry
from tracking.errors import OutputError, SessionError
from tracking.owned_files import real_path
from tracking.session.findings import Finding
from tracking.session.journal import Act
from tracking.session.notes import tell, tell_damage
from tracking.session.pending_edits import edits_wait, notes_on_kept
from tracking.session.pending_save import PendingSave, next_stamps
from tracking.session.recovery import recover
from tracking.session.session_reader import read_save
from tracking.session.session_state import SessionState
from tracking.session.session_writer import companions, keep_damaged
from tracking.session.store import Store
from tracking.stamps import now
from tracking.translation import msg


class OnDisk(SessionState):
    """Saves a session in three steps, keeps each edit in the journal, and finds both again."""

    def _make_sure(self, store: Store) -> None:
        """See to it that the session's folder is there, and is the one this session knows."""
        if not store.make_sure(self._is_own_file):
            self._saved, self._base = -1, self._content  # what no journal holds goes into the file
        if store.others_aside is not None:
            what = msg(
                "another program edited this session meanwhile; its edits are kept "
                "aside as {aside}",
                aside=store.others_aside,
            )
            self._findings.append(Finding(now(), self._without_folder(what)))
            raise SessionError(
                "{path}: {what}", "do it again to go on without them", path=self._path, what=what
            )

    def _is_own_file(self) -> bool:
        """Whether the file under the session's name is what this session saved last."""
        path, stamps = self._path, self._stamps
        return path is not None and read_save(path) == (stamps.session, stamps.save)

    def _put_base_on_disk(self) -> None:
        """See to it that the file holds the run that is edited: the journal builds on it."""
        pending = self._pending
        if pending is None:
            self.save()
        elif pending.store is self._store and pending.content >= self._base > self._saved >= 0:
            pending.written.result()
        else:
            raise SessionError(
                "{path} is being saved; edit again when that is done", path=self._path
            )

    def _keep(self, act: Act, entry: Entry) -> None:
        """Put a step into the journal; a session that was never saved has none."""
        if self._store is not None:
            self._store.keep(act, entry, self._stamps.session, self._stamps.save)

    def _begin_journal(self) -> None:
        """Have a journal ready before the first edit is made."""
        if self._store is not None:
            self._store.begin_journal(self._stamps.session, self._stamps.save)

    def _recover(self, store: Store) -> None:
        found = recover(self._edited, store, self._stamps)
        self._recovered = self._content = found.steps
        self._notes += (*map(tell, found.notes), *map(tell_damage, found.damage))
        self._damage += found.damage
        self._findings += [Finding(now(), self._without_folder(note)) for note in found.damage]
        if found.failed is not None:
            raise found.failed

    def _tell_of_kept(self, path: Path) -> None:
        """Tell of edits that this session lacks, which journals kept aside still hold."""
        said = "\n".join(self._notes)
        notes = notes_on_kept(path, self._stamps, self._edited.history)
        self._notes += [tell(note) for kept, note in notes.items() if str(kept) not in said]

    def _without_folder(self, note: str) -> str:
        """A note with names of files beside the session alone: the session travels."""
        return note if self._path is None else note.replace(f"{companions(self._path)}{os.sep}", "")

    def _keep_as_found(self, path: Path) -> None:
        """Before the first save: it would seal what is damaged anew."""
        if self._unkept is not None:
            found, kept = self._findings[self._unkept], keep_damaged(path).name
            self._findings[self._unkept] = replace(found, kept=kept)
            self._unkept = None

    def _keep_unsaved(self) -> None:
        """Save edits that were put into a journal which is there no more."""
        store = self._store
        if store is None or self._pending is not None:
            return
        if self._saved >= 0 and store.has_its_journal:
            return
        try:
            if not store.make_sure(self._is_own_file):
                self._saved, self._base = -1, self._content
            if self._saved < 0:
                self.save()
        except (OutputError, SessionError) as why:
            lost = msg(
                "edits made after {path} was saved last may be lost: {reason}",
                path=self._path,
                reason=why.reason,
            )
            raise type(why)(lost, why.to_do) from why
        if store.others_aside is not None:
            tell(
                msg("edits of another program are kept aside as {aside}", aside=store.others_aside)
            )

    def _refuse_read_only(self) -> None:
        if self.read_only:
            raise SessionError(
                "{path} is open for reading only; save it under another name", path=self._path
            )

    def _let_go(self, *, keep_journal: bool) -> None:
        """Give the right to write the file back."""
        if self._store is not None:
            self._store.release(keep_journal=keep_journal)
            self._store = None

    def _give_up_writing(self, why: str) -> None:
        """Stay open for reading only."""
        self._let_go(keep_journal=True)
        self._why_read_only = why
        self._notes.append(msg("Open for reading only: {why}", why=why))
        if not self._recovered and self._path is not None and edits_wait(self._path):
            self._notes.append(msg("edits made after it was saved last are not shown here"))

    # Saving

    def save(self, path: Path | str | None = None) -> Path:
        """Save, there or under its own name; afterwards this is the session of that file.

        Raises OutputError, with the old file byte for byte as it was, where that fails; where it
        is only not certain that the new file lasts, it is in its place, and the journal keeps the
        edits until another save succeeds.
        SessionError where another program has the file or no path was ever named.
        """
        return self._write(self.begin_save(None if path is None else Path(path)))

    def _write(self, pending: PendingSave) -> Path:
        try:
            pending.write()
            return self.finish_save(pending)
        except BaseException:
            self.abandon_save(pending)
            raise

    def begin_save(self, path: Path | None = None) -> PendingSave:
        """The first of three steps of `save`: quick. `write` of what it gives may take long.

        One save at a time: raises SessionError while another one is on its way.
        """
        if self._pending is not None:
            raise SessionError(
                "{path} is being saved; wait until that is done", path=self._pending.path
            )
        target = path if path is not None else self._path
        if target is None:
            raise SessionError("the session has no file yet; name one to save it in")
        target = real_path(target)
        own = self._path is not None and target.resolve() == self._path.resolve()
        if own:
            self._refuse_read_only()
            if self._store is not None:
                self._make_sure(self._store)
            self._keep_as_found(target)
        store = self._store if own and self._store is not None else Store.claim(target)
        try:
            stamps = next_stamps(self._stamps, self._stamps, store if own else None)
            place = self._whereabouts.reference_from(target.parent, self._path)
            snapshot = self._as_it_is(stamps, place)
        except BaseException:
            if store is not self._store:
                store.release(keep_journal=True)
            raise
        self._pending = PendingSave(snapshot, target, self._content, store)
        return self._pending

    def finish_save(self, pending: PendingSave) -> Path:
        """The last step, after `write`: from now on the journal builds on the new file."""
        stamps, own = pending.snapshot.stamps, pending.store is self._store
        if own:
            pending.store.rebase(stamps.session, stamps.save, stamps.included)
        else:
            pending.store.clear_journal()  # of the session that was there before
        left = None if own else self._store
        self._store, self._path = pending.store, pending.path
        self._stamps, self._whereabouts.reference = stamps, pending.snapshot.recording
        self._runs.note_stored_in(pending.path, len(pending.snapshot.runs))
        self._saved, self._pending, self._unkept = pending.content, None, None
        self._begin_journal()
        try:
            if self.dirty and not own:  # edits made meanwhile are in no journal of this file
                self._base = self._content
                self.save()
        finally:
            if left is not None:
                left.release(keep_journal=self.dirty)
        return pending.path

    def abandon_save(self, pending: PendingSave) -> None:
        """Instead of `finish_save`, where `write` failed or was not called."""
        self._pending = None
        if pending.store is not self._store:
            pending.store.release(keep_journal=True)

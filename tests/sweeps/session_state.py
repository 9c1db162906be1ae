"""What a session is like, as a short text, and whether a file holds what a program said last."""

from __future__ import annotations

import hashlib
from contextlib import closing
from dataclasses import dataclass
from pathlib import Path

from tracking.editing import apply_change
from tracking.errors import TrackwrightError
from tracking.session import Session, find_backups
from tracking.tracks import Labels, TrackTable


@dataclass(frozen=True, slots=True)
class Said:
    """What a program said before it ended.

    Attributes:
        last: the state after the last step it acknowledged.
        coming: the state that a restore it had begun leads to; "" where none had begun.
    """

    last: str
    coming: str = ""

    @classmethod
    def of_lines(cls, lines: list[str]) -> Said:
        """From what it said, a line each: `= STATE` for a step done, `~ STATE` for one coming."""
        done = [at for at, line in enumerate(lines) if line.startswith("= ")]
        coming = lines[-1][2:] if lines[-1].startswith("~ ") else ""
        return cls(lines[done[-1]][2:], coming)


def digest(tracks: TrackTable, labels: Labels) -> str:
    """What edits can change, as a short text: equal for equal tracks and labels."""
    seen = hashlib.sha256()
    for name, column in tracks.columns().items():
        seen.update(name.encode())
        seen.update(column.tobytes())
    said = (labels.occluders, labels.reviewed, labels.lines, labels.regions)
    kept = (labels.tracks, labels.verdicts, labels.parts)
    seen.update(repr((said, [[(key, of[key]) for key in sorted(of)] for of in kept])).encode())
    return seen.hexdigest()


def state(session: Session) -> str:
    """The digest, and how many steps the log holds and how many of them are undone."""
    undone = sum(entry.undone for entry in session.history)
    return f"{digest(session.tracks, session.labels)} {len(session.history)} {undone}"


def look(path: Path, said: Said | None) -> tuple[str, str]:
    """What is wrong with a session on the disk, and what it is like now.

    Nothing is wrong where it is as said, or one step further, or where nothing was said.
    """
    try:
        session = Session.open(path)
    except TrackwrightError as error:
        return f"unreadable: {error}", ""
    with closing(session):
        return _problem(session, path, said) if said else "", state(session)


def _problem(session: Session, path: Path, said: Said) -> str:
    if session.read_only:
        return f"read only: {session.notes}"
    if not follows_from_its_log(session):
        return "the log, done again, gives other tracks"
    found = state(session)
    if found == said.last or one_step_further(session, said.last):
        return ""
    if found == said.coming:
        return _kept(path, said.last)
    return f"an acknowledged step is lost: {said} but {found} {session.notes}"


def _kept(path: Path, last: str) -> str:
    """What was there before a restore is the newest of the older ones."""
    older = find_backups(path)
    if older:
        session = Session.look_into(older[0])
        if state(session) == last or one_step_further(session, last):
            return ""
    return "restored, but what was there before is not kept"


def follows_from_its_log(session: Session) -> bool:
    """Whether the run with the edits in force done again is the corrected table."""
    if session.adopted_run is None:
        return True
    table, labels = TrackTable(session.runs[session.adopted_run].tracks), Labels()
    for entry in session.history:
        if not entry.undone:
            labels = apply_change(table, labels, entry.change)
    now, again = session.tracks.columns(), table.columns()
    same = all(now[name].tobytes() == again[name].tobytes() for name in now)
    return same and labels == session.labels


def one_step_further(session: Session, said: str) -> bool:
    """Whether the session is what was said and one step more: an edit, an undo or a redo."""
    then, entries, undone = said.split()
    history = session.history
    now = len(history), sum(entry.undone for entry in history)
    steps = [(history.next_undo, True, (1, 0)), (history.next_undo, True, (0, -1))]
    steps.append((history.next_redo, False, (0, 1)))
    for entry, back, (more, more_undone) in steps:
        if entry is None or now != (int(entries) + more, int(undone) + more_undone):
            continue
        table, change = session.tracks.snapshot(), entry.change
        labels = apply_change(table, session.labels, change.inverse if back else change)
        if digest(table, labels) == then:
            return True
    return False

"""The edits of a journal that a session file does not hold yet."""

from __future__ import annotations

from dataclasses import dataclass

from tracking.errors import EditError, SessionError
from tracking.session.edited import Edited
from tracking.session.image import Stamps
from tracking.session.journal import Journal, Step
from tracking.session.store import Store


@dataclass(frozen=True, slots=True)
class Recovery:
    """What came of it.

    Attributes:
        steps: how many steps were made again.
        notes: lines for the user.
    """

    steps: int = 0
    notes: tuple[str, ...] = ()


def recover(edited: Edited, store: Store, stamps: Stamps) -> Recovery:
    """Make the journal's edits again that the file misses; then the journal builds on this file.

    A journal, or the end of one, that does not fit the file is kept aside and told, never thrown
    away. Raises OutputError where the journal cannot be read or written for want of room or rights.
    """
    try:
        journal = store.journal()
        steps = missing_steps(journal, stamps)
    except SessionError as why:
        return Recovery(notes=(f"{why}; it was kept aside as {store.set_journal_aside()}",))
    made = 0
    try:
        for step in steps:
            edited.replay(step.act, step.entry)
            made += 1
    except EditError as why:
        aside = store.set_journal_aside()
        _begin(store.journal(), stamps, steps[:made])
        left = len({step.entry.id for step in steps[made:]})
        do = "does" if left == 1 else "do"
        rest = f"{_edits(left)} {do} not fit ({why}); kept aside as {aside}"
        return Recovery(made, (*_told(steps[:made]), rest))
    journal.start_over(stamps.session, stamps.save, journal.last - len(steps))
    return Recovery(made, _told(steps))


def missing_steps(journal: Journal, stamps: Stamps) -> list[Step]:
    """The journal's steps that were made after the file was saved, in order.

    The journal builds on this save, or on the one before it where the program ended between
    putting the new file in its place and trimming the journal.
    Raises SessionError where it belongs to another file, so that replaying it would be wrong.
    """
    origin = journal.origin
    if origin is None or not journal.last:
        return []  # begun by a program that died before its first edit: whatever it built on
    if origin == (stamps.session, stamps.save):
        return list(journal.steps())
    if stamps.previous_save and origin == (stamps.session, stamps.previous_save):
        return [step for step in journal.steps() if step.number > stamps.included]
    raise SessionError("the journal belongs to another session or to another save of this one")


def _begin(journal: Journal, stamps: Stamps, steps: list[Step]) -> None:
    journal.start_over(stamps.session, stamps.save)
    for step in steps:
        journal.append(step.act, step.entry)


def _told(steps: list[Step]) -> tuple[str, ...]:
    """How many edits were made again, undone and redone: each recovered edit is told once."""
    last = {step.entry.id: step.act for step in steps}
    made = {step.entry.id for step in steps if step.act == "apply"}
    undone = {edit for edit, act in last.items() if act == "undo"}
    which = f", {len(made & undone)} of them undone again" if made & undone else ""
    told = {
        f"made after the session was saved last{which}": made,
        "undone after the session was saved last": undone - made,
        "redone after the session was saved last": last.keys() - made - undone,
    }
    return tuple(f"Recovered: {_edits(len(some))} {how}" for how, some in told.items() if some)


def _edits(number: int) -> str:
    return "1 edit" if number == 1 else f"{number} edits"

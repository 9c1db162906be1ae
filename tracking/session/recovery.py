"""The edits of a journal that a session file does not hold yet."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from functools import partial
from pathlib import Path

from tracking.errors import EditError, OutputError, SessionError
from tracking.session.edited_tracks import EditedTracks
from tracking.session.image import Stamps
from tracking.session.journal import Journal, Step
from tracking.session.notes import MAY_MISS
from tracking.session.store import Store
from tracking.translation import Message, count_msg, msg


@dataclass(frozen=True, slots=True)
class Recovery:
    """What came of it.

    Attributes:
        steps: how many steps were made again.
        notes: lines for the user.
        damage: those on what is damaged or does not fit, which come after the notes.
        failed: why the journal, which was read, cannot be written; nothing in it was changed.
    """

    steps: int = 0
    notes: tuple[Message, ...] = ()
    damage: tuple[Message, ...] = ()
    failed: OutputError | None = None


@dataclass(frozen=True, slots=True)
class MissingSteps:
    """What a journal holds that a session file misses.

    Attributes:
        steps: those that are as they were written, in order.
        problem: why there may have been more; "" where there were not.
    """

    steps: tuple[Step, ...] = ()
    problem: str = ""


def recover(edited: EditedTracks, store: Store, stamps: Stamps) -> Recovery:
    """Make the journal's edits again that the file misses; then the journal builds on this file.

    A journal, or the end of one, that is damaged or does not fit the file is kept aside and told,
    never thrown away. Raises OutputError where the journal cannot be read for want of room or
    rights.
    """
    try:
        journal = store.take_over()
        missing = find_missing_steps(journal, stamps)
    except SessionError as why:
        reason = why.reason
        return _replaced(
            store,
            stamps,
            (),
            lambda kept: msg(
                "{reason}; it was {kept}: {may_miss}", reason=reason, kept=kept, may_miss=MAY_MISS
            ),
        )
    steps, made, misfit = missing.steps, 0, Message()
    try:
        for step in steps:
            edited.replay(step.act, step.entry)
            made += 1
    except EditError as why:
        misfit = why.message
    if not (misfit or missing.problem):
        return _gone_on_with(journal, stamps, steps, store.kept_aside)

    damage = partial(_damage_of, misfit, missing.problem, steps[made:])
    return _replaced(store, stamps, steps[:made], damage)


def _damage_of(misfit: Message, problem: str, left: Sequence[Step], kept: Message) -> Message:
    """What is wrong with a journal: the steps that are left do not fit, or else its problem."""
    if misfit:
        return msg("{edits} ({why}); {kept}", edits=explain_misfit(left), why=misfit, kept=kept)
    return msg(
        "the journal of edits is damaged ({problem}); it was {kept}: {may_miss}",
        problem=problem,
        kept=kept,
        may_miss=MAY_MISS,
    )


def _gone_on_with(
    journal: Journal, stamps: Stamps, steps: Sequence[Step], aside: Path | None
) -> Recovery:
    """Let a sound journal build on the file. aside: see `Store.kept_aside`."""
    cut_short = msg(
        "a journal was kept aside as {aside} when the session was opened before: {may_miss}",
        aside=aside,
        may_miss=MAY_MISS,
    )
    failed = None
    try:
        journal.start_over(stamps.session, stamps.save, journal.last - len(steps))
    except OutputError as why:
        failed = why
    return Recovery(len(steps), _told(steps), () if aside is None else (cut_short,), failed)


def _replaced(
    store: Store, stamps: Stamps, steps: Sequence[Step], damage: Callable[[Message], Message]
) -> Recovery:
    """Keep the journal aside and go on with one that has what is sound of it.

    damage: what is wrong with it, in a line that says, too, what was done with it.
    """
    failed: OutputError | None = None
    try:
        kept = msg(
            "kept aside as {place}", place=store.replace_journal(stamps.session, stamps.save, steps)
        )
    except OutputError as why:
        kept, failed = msg("left where it is"), why
    return Recovery(len(steps), _told(steps), (damage(kept),), failed)


def explain_misfit(steps: Sequence[Step]) -> str:
    """How many edits these are, and that they do not fit the session."""
    left = len({step.entry.id for step in steps})
    return count_msg(left, "{n} edit does not fit", "{n} edits do not fit")


def find_missing_steps(journal: Journal, stamps: Stamps) -> MissingSteps:
    """The journal's steps that were made after the file was saved, in order.

    The journal builds on this save, or on the one before it where the program ended between
    putting the new file in its place and trimming the journal.
    Raises SessionError where it belongs to another file, so that replaying it would be wrong.
    """
    origin, own = journal.origin, (stamps.session, stamps.save)
    if origin is None or not journal.may_have_steps:
        # Begun by a program that died before its first edit, whatever it built on; or it has lost
        # them all.
        return MissingSteps(problem=_lost(journal.count_acknowledged(*own), 0))
    if origin == own:
        included = 0
    elif stamps.previous_save and origin == (stamps.session, stamps.previous_save):
        included = stamps.included
    else:
        raise SessionError("the journal belongs to another session or to another save of this one")
    contents = journal.contents()
    steps = tuple(step for step in contents.steps if step.number > included)
    there = max(len(contents.steps), included)
    return MissingSteps(
        steps, contents.problem or _lost(journal.count_acknowledged(*origin), there)
    )


def _lost(acknowledged: int, there: int) -> str:
    return (
        msg("{there} of {acknowledged} steps are left", there=there, acknowledged=acknowledged)
        if acknowledged > there
        else ""
    )


def _told(steps: Sequence[Step]) -> tuple[Message, ...]:
    """How many edits were made again, undone and redone: each recovered edit is told once."""
    last = {step.entry.id: step.act for step in steps}
    made = {step.entry.id for step in steps if step.act == "apply"}
    undone = {edit for edit, act in last.items() if act == "undo"}
    which = msg(", {count} of them undone again", count=len(made & undone)) if made & undone else ""
    told = {
        msg("made after the session was saved last{which}", which=which): made,
        msg("undone after the session was saved last"): undone - made,
        msg("redone after the session was saved last"): last.keys() - made - undone,
    }
    return tuple(
        msg("Recovered: {edits} {how}", edits=_edits(len(some)), how=how)
        for how, some in told.items()
        if some
    )


def _edits(number: int) -> Message:
    return count_msg(number, "{n} edit", "{n} edits")

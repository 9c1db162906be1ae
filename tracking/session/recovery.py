"""Which steps of a journal a session file does not hold yet."""

from __future__ import annotations

from tracking.errors import SessionError
from tracking.session.image import Stamps
from tracking.session.journal import Journal, Step


def missing_steps(journal: Journal, stamps: Stamps) -> list[Step]:
    """The journal's steps that were made after the file was saved, in order.

    The journal builds on this save, or on the one before it where the program ended between
    putting the new file in its place and trimming the journal.
    Raises SessionError where it belongs to another file, so that replaying it would be wrong.
    """
    origin = journal.origin
    if origin is None:
        return []
    if origin == (stamps.session, stamps.save):
        return list(journal.steps())
    if stamps.previous_save and origin == (stamps.session, stamps.previous_save):
        return [step for step in journal.steps() if step.number > stamps.included]
    raise SessionError("the journal belongs to another session or to another save of this one")

"""Which recording of a project is reviewed next."""

from __future__ import annotations

from collections.abc import Iterable

from tracking.project.pairing import ProjectRow

_OPENING_MINUTES = 0.5
"""What it takes to open a recording and to see who is who; else tiny reviews would come first."""


def worth_of(row: ProjectRow) -> float | None:
    """Identity errors that a review is expected to find for each minute of it.

    The errors expected at the review items left, divided by the minutes of footage that these
    show and half a minute for opening the recording. None where nothing is left to review, or
    nothing was tracked.
    """
    facts = row.session.facts if row.session is not None else None
    if facts is None or facts.problem or facts.hand_made or not facts.items_left:
        return None
    return facts.errors_at_items / (facts.minutes_left + _OPENING_MINUTES)


def next_to_review(rows: Iterable[ProjectRow], leave_out: str = "") -> ProjectRow | None:
    """The row of the most worth that nobody has open; None: there is none.

    leave_out: the name of a row that does not count, such as the one that is open.
    """
    best: ProjectRow | None = None
    most = 0.0
    for row in rows:
        worth = worth_of(row)
        held = row.session is not None and row.session.holder
        if worth is not None and worth > most and not held and row.name != leave_out:
            best, most = row, worth
    return best

"""`import-labels`: labels of body parts made elsewhere, into a session."""

from __future__ import annotations

from contextlib import closing
from pathlib import Path

from app.cli.output import print_json, print_line
from app.cli.sessions import refuse_read_only
from tracking.editing import plan_label_part
from tracking.formats import read_part_labels
from tracking.session import Session, place_labels
from tracking.translation import msg


def run_import_labels(path: Path, into: Path, author: str | None, *, as_json: bool) -> None:
    """Take a table of labels into a session as one edit, and save it.

    Raises FormatError with the line of an invalid label, SessionError where the
    session cannot be changed.
    """
    with closing(Session.open(into)) as session:
        refuse_read_only(session, into)
        given = read_part_labels(path, author if author is not None else session.author)
        labels = place_labels(session, given)
        new = [label for label in labels if session.labels.parts.get(label.key) != label]
        if new:
            session.apply(plan_label_part(session.labels, new))
            session.save()
    counts = {"read": len(given), "new": len(new), "session": str(into)}
    if as_json:
        print_json(counts)
    else:
        print_line(
            msg("{count} new labels of {all} in {into}", count=len(new), all=len(given), into=into)
        )

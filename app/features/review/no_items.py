"""What the review queue says where it lists nothing, and whether it was looked for at all."""

from __future__ import annotations

from app.core.i18n import tr
from app.core.keymap import key_or_title
from tracking.session import Session


def waiting_words(session: Session) -> tuple[str, str]:
    """What is said of tracks made by hand until somebody asks: a title, and a text."""
    imported = session.adopted_run is not None
    title = tr("Imported labels") if imported else tr("Labelled by hand")
    return title, tr("Tracks that no tracker made are searched only if you ask for it.")


def empty_words(session: Session | None, *, live: bool, problem: str) -> tuple[str, str]:
    """What is said where nothing is listed: a title, "" for none, and a text.

    Args:
        live: the tracks of a tracker at work are shown. problem: why nothing could be found.
    """
    if session is None:
        return "", tr(
            "Review items are listed here once the recording is tracked, or labelled by hand: "
            "{draw} or {new} draws a person.",
            draw=key_or_title("tracks.draw"),
            new=key_or_title("tracks.new"),
        )
    if live:
        return "", tr("The search for review items starts when the tracker is done.")
    if problem:
        return tr("Not searched"), problem
    if not session.tracks.track_ids:
        return tr("Nobody is tracked"), tr(
            "There is nothing to review. Track again with other settings, or correct another "
            "run: {runs} lists them. {draw} or {new} draws a person.",
            runs=key_or_title("tracks.runs"),
            draw=key_or_title("tracks.draw"),
            new=key_or_title("tracks.new"),
        )
    return tr("No review items left"), tr(
        "Every review item is decided. Watch what is not reviewed yet, or score the tracks."
    )

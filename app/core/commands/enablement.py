"""Why a command cannot be done now, in words; "" where it can."""

from __future__ import annotations

from app.core.commands.command import CommandContext
from app.core.i18n import tr


def recording(now: CommandContext) -> str:
    """A recording must be open."""
    return "" if now.recording else tr("open a recording first")


def session(now: CommandContext) -> str:
    """A session must be there, and no other work going on."""
    if not now.session:
        return recording(now) or tr("track the recording first, or draw a person (Ins)")
    return tr("wait until the work in progress is done") if now.busy else ""


def savable(now: CommandContext) -> str:
    """A session must be there, or what a tracker found that could not be kept on disk."""
    return "" if now.unkept and not now.busy else session(now)


def read_only() -> str:
    """What is said where the session cannot be saved under its name."""
    return tr("the session is read only here: save it under another name first")


def editable(now: CommandContext) -> str:
    """The session must be open for changes."""
    if now.in_the_way:
        return now.in_the_way
    if now.read_only:
        return read_only()
    return session(now)


def replaceable(now: CommandContext) -> str:
    """The session must be open for changes, and no tracker at work that would end in it."""
    return tr("stop tracking first (Ctrl+Shift+T)") if now.live else editable(now)


def selected(now: CommandContext) -> str:
    """A person of an editable session must be selected."""
    return editable(now) or ("" if now.selected else tr("select a person first"))


def on_floor(now: CommandContext) -> str:
    """A person must be selected, and the floor be known."""
    return selected(now) or floor(now)


def drawable(now: CommandContext) -> str:
    """A recording must be open for changes; the first box that is drawn makes the session."""
    if now.session:
        return editable(now)
    if now.in_the_way:
        return now.in_the_way
    if now.busy:
        return tr("wait until the work in progress is done")
    if now.unkept:
        return tr("keep what was tracked first (Ctrl+S)")
    return recording(now)


def edit_waits() -> str:
    """What is said where an edit that waits is in the way."""
    return tr("an edit waits: do it (Enter) or leave it (Esc) first")


def live(now: CommandContext) -> str:
    """A tracker must be at work, with no edit of the tracks in view on its way."""
    if not now.live:
        return tr("no tracker is at work")
    return edit_waits() if now.editing else ""


def waiting(now: CommandContext) -> str:
    """An edit must wait for Enter."""
    return "" if now.editing else tr("no edit is waiting")


def reaching(now: CommandContext) -> str:
    """Something must be done whose reach can be chosen: an edit that waits, labels of parts."""
    return "" if now.saying else waiting(now)


def placing(now: CommandContext) -> str:
    """An edit of a box must wait for Enter."""
    return "" if now.placing else tr("no box is being moved")


def trackable(now: CommandContext) -> str:
    """A tracker must exist for the recording, and nothing else be going on."""
    if now.live:
        return tr("a tracker is at work: stop it first (Ctrl+Shift+T)")
    if now.busy:
        return tr("wait until the work in progress is done")
    if now.read_only:
        return read_only()
    return recording(now) or ("" if now.can_track else now.why_no_tracking)


def scored(now: CommandContext) -> str:
    """Tracks must have been compared with a truth."""
    return recording(now) or ("" if now.scored else tr("score against a truth first (Shift+S)"))


def reportable(now: CommandContext) -> str:
    """Tracks must have been compared with a truth, or one stand beside the recording.

    Not those that a tracker at work finds: they are others a moment later.
    """
    if now.busy:
        return tr("wait until the work in progress is done")
    if now.further:
        return tr("move the playhead to your own tracks, or stop tracking first (Ctrl+Shift+T)")
    if now.live and (now.in_the_way or not now.session):
        return tr("stop tracking first (Ctrl+Shift+T)")
    return "" if now.truth and now.tracks else scored(now)


def two_cameras(now: CommandContext) -> str:
    """The recording must have two cameras."""
    return recording(now) or ("" if now.stereo else tr("the recording has one camera"))


def floor(now: CommandContext) -> str:
    """The recording must say where the floor is."""
    said = tr("the recording does not say where the floor is")
    return recording(now) or ("" if now.calibrated else said)

"""Why a command cannot be done now, in words; "" where it can."""

from __future__ import annotations

from typing import Protocol, TypeVar

from app.core.document.document import Document
from app.core.i18n import tr
from app.core.keymap import in_brackets

ControllerT = TypeVar("ControllerT")


class WindowState(Protocol):
    """What most commands depend on."""

    @property
    def document(self) -> Document | None:
        """The open recording; None: none is open."""

    @property
    def busy(self) -> bool:
        """Whether long work other than tracking is going on."""

    @property
    def live(self) -> bool:
        """Whether a tracker is at work."""

    @property
    def unkept(self) -> bool:
        """Whether what a tracker found is in memory alone."""

    def of(self, kind: type[ControllerT]) -> ControllerT:
        """The controller of this kind of the open recording."""


def recording(now: WindowState) -> str:
    """A recording must be open."""
    return "" if now.document is not None else tr("open a recording first")


def _has_session(now: WindowState) -> bool:
    return now.document is not None and now.document.session is not None


def session(now: WindowState) -> str:
    """A session must be there, and no other work going on."""
    if not _has_session(now):
        return recording(now) or tr(
            "track the recording first, or draw a person{key}",
            key=in_brackets("tracks.new"),
        )
    return tr("wait until the work in progress is done") if now.busy else ""


def savable(now: WindowState) -> str:
    """A session must be there, or what a tracker found that could not be kept on disk."""
    return "" if now.unkept and not now.busy else session(now)


def in_the_way(now: WindowState) -> str:
    """What is to be done before tracks can be corrected, as a tracker's people are shown."""
    return now.document.in_the_way if now.document is not None else ""


def read_only() -> str:
    """What is said where the session cannot be saved under its name."""
    return tr("the session is read-only here: save it under another name first")


def _read_only(now: WindowState) -> str:
    """The session must be one that can be saved under its name."""
    if now.document is None or now.document.session is None or not now.document.session.read_only:
        return ""
    return read_only()


def editable(now: WindowState) -> str:
    """The session must be open for changes."""
    return in_the_way(now) or _read_only(now) or session(now)


def replaceable(now: WindowState) -> str:
    """The session must be open for changes, and no tracker at work that would end in it."""
    return (
        tr(
            "stop tracking first{key}",
            key=in_brackets("tracks.stop"),
        )
        if now.live
        else editable(now)
    )


def somebody(now: WindowState) -> str:
    """A person must be selected, also while a tracker is at work."""
    if now.document is not None and now.document.selection:
        return ""
    return tr("select a person first")


def selected(now: WindowState) -> str:
    """A person of an editable session must be selected."""
    return editable(now) or somebody(now)


def on_floor(now: WindowState) -> str:
    """A person must be selected, and the floor be known."""
    return selected(now) or floor(now)


def drawable(now: WindowState) -> str:
    """A recording must be open for changes; the first box that is drawn makes the session."""
    if _has_session(now):
        return editable(now)
    if in_the_way(now):
        return in_the_way(now)
    if now.busy:
        return tr("wait until the work in progress is done")
    if now.unkept:
        return tr(
            "save the tracker's result first{key}",
            key=in_brackets("file.save"),
        )
    return recording(now)


def edit_waits() -> str:
    """What is said where a pending edit is in the way."""
    return tr(
        "an edit is in preview: apply it{apply} or cancel it{cancel} first",
        apply=in_brackets("tracks.confirm"),
        cancel=in_brackets("tracks.none"),
    )


def live(now: WindowState) -> str:
    """A tracker must be at work, with no edit of the tracks in view on its way."""
    if not now.live:
        return tr("no tracker is running")
    return "" if pending(now) else edit_waits()


def pending(now: WindowState) -> str:
    """An edit must wait for Enter."""
    if now.document is not None and now.document.flow is not None:
        return ""
    return tr("no edit is in preview")


def placing(now: WindowState) -> str:
    """An edit of a box must wait for Enter."""
    flow = now.document.flow if now.document is not None else None
    return "" if flow is not None and flow.places else tr("no box is being moved")


def trackable(now: WindowState) -> str:
    """No other work may be going on in a recording whose session can be saved."""
    if now.live:
        return tr(
            "a tracker is running: stop it first{key}",
            key=in_brackets("tracks.stop"),
        )
    if now.busy:
        return tr("wait until the work in progress is done")
    return _read_only(now) or recording(now)


def two_cameras(now: WindowState) -> str:
    """The recording must have two cameras."""
    if now.document is None or now.document.recording.is_stereo:
        return recording(now)
    return tr("the recording has one camera")


def floor(now: WindowState) -> str:
    """The recording must say where the floor is."""
    if now.document is None or now.document.recording.view is not None:
        return recording(now)
    return tr("the recording does not state where the floor is")


def two_cameras_and_floor(now: WindowState) -> str:
    """Both."""
    return two_cameras(now) or floor(now)

"""Errors of sessions that callers tell apart."""

from __future__ import annotations

from tracking.errors import SessionError


class RecordingMissing(SessionError):  # noqa: N818 - reads as what it is, where it is caught
    """The recording a session was made from is not where it was.

    The session itself is whole: tracks, labels and edits are there, only pictures are not.
    """

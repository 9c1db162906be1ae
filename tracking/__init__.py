"""People tracked in recorded footage, as a library: no Qt anywhere below.

    import tracking

    session = tracking.track("lobby")                      # a folder, a video, a `Recording`
    print(tracking.score(session, "lobby").as_text())      # against the truth beside it
    tracking.edit(session, "swap", 1, 2, start=120)        # as in the window; undo with undo()
    session.save("lobby.h5")
    tracking.plot(session)                                 # a picture, in a notebook

What stands in `__all__` is the public face: names and parameters stay as they are within a major
version. Each name is imported as it is used, so that `import tracking` costs nothing. The packages
below are as public as docs/plugins.md says; everything else may change.
"""

from __future__ import annotations

import importlib

__version__ = "0.1.0"

__all__ = [
    "OpenOptions",
    "Recording",
    "Score",
    "Session",
    "TrackwrightError",
    "edit",
    "export",
    "open_recording",
    "plot",
    "read_session",
    "score",
    "to_pandas",
    "track",
]

_HOMES = {
    "OpenOptions": "tracking.recording",
    "Recording": "tracking.recording",
    "Score": "tracking.scoring",
    "Session": "tracking.session",
    "TrackwrightError": "tracking.errors",
    "edit": "tracking.library.edits",
    "export": "tracking.library.exports",
    "open_recording": "tracking.library.recordings",
    "plot": "tracking.library.pictures",
    "read_session": "tracking.library.sessions",
    "score": "tracking.library.scores",
    "to_pandas": "tracking.library.frames",
    "track": "tracking.library.runs",
}


def __getattr__(name: str) -> object:
    """What is public, imported as it is used."""
    if name not in _HOMES:
        raise AttributeError(f"module {__name__!r} has no attribute {name!r}")
    value: object = getattr(importlib.import_module(_HOMES[name]), name)
    globals()[name] = value
    return value


def __dir__() -> list[str]:
    """What is public, for completion."""
    return sorted({*globals(), *__all__})

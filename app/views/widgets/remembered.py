"""What the program remembers from one start to the next."""

from __future__ import annotations

import json
from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path

from PySide6.QtCore import QByteArray, QSettings

_RECENT = 12
_PLACES = 50


@dataclass(frozen=True, slots=True)
class Place:
    """Where somebody is in a document: the frame and the selected track, 0 for nobody."""

    frame: int = 0
    track: int = 0


class Remembered:
    """Window state, look and recently opened files, kept in Qt's settings."""

    def __init__(self, settings: QSettings | None = None) -> None:
        self._settings = settings or QSettings("trackwright", "trackwright")

    @property
    def recent(self) -> tuple[Path, ...]:
        """What was opened, the latest first."""
        value = self._settings.value("recent")
        texts = value if isinstance(value, list) else [value] if value else []
        return tuple(Path(str(text)) for text in texts)

    def add_recent(self, path: Path) -> None:
        """Put a path in front."""
        others = [one for one in self.recent if one != path]
        kept = [str(one) for one in [path, *others][:_RECENT]]
        self._settings.setValue("recent", kept)

    @property
    def left_open(self) -> tuple[Path, ...]:
        """What was open when the program ended without closing it.

        The session first, then the path it was opened by, where that is another one.
        """
        value = self._settings.value("open")
        texts = value if isinstance(value, list) else [value] if value else []
        return tuple(Path(str(text)) for text in texts)

    def note_open(self, paths: Sequence[Path], place: Place) -> None:
        """Note what is open and where in it the user is, on disk at once."""
        self._settings.setValue("open", [str(path) for path in paths])
        places = {text: pair for text, pair in self._places().items() if Path(text) not in paths}
        latest = {str(path): [place.frame, place.track] for path in paths}
        kept = list({**latest, **places}.items())[:_PLACES]
        self._settings.setValue("places", json.dumps(dict(kept)))
        self._settings.sync()

    def note_closed(self) -> None:
        """Nothing is open any more."""
        self._settings.remove("open")
        self._settings.sync()

    def place(self, path: Path) -> Place:
        """Where the user was when a session or recording was open last; its start if never."""
        match self._places().get(str(path)):
            case [int() as frame, int() as track]:
                return Place(frame, track)
        return Place()

    def _places(self) -> dict[str, object]:
        """By path, the latest first; whatever a damaged file says instead is forgotten."""
        try:
            places = json.loads(self.text("places", "{}"))
        except ValueError:
            return {}
        return places if isinstance(places, dict) else {}

    def text(self, key: str, default: str = "") -> str:
        """A remembered word."""
        return str(self._settings.value(key, default))

    def set_text(self, key: str, value: str) -> None:
        """Remember a word."""
        self._settings.setValue(key, value)

    def state(self, key: str) -> QByteArray | None:
        """The remembered state of a window or splitter."""
        value = self._settings.value(key)
        return value if isinstance(value, QByteArray) else None

    def set_state(self, key: str, value: QByteArray) -> None:
        """Remember a state."""
        self._settings.setValue(key, value)

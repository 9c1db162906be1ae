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


@dataclass(frozen=True, slots=True)
class LastFolder:
    """Where files of one kind were chosen last, so that the next is asked for there."""

    remembered: UserSettings
    kind: str

    @property
    def folder(self) -> Path | None:
        """None: none was chosen yet, or it has gone."""
        text = self.remembered.text(f"folders/{self.kind}")
        return Path(text) if text and Path(text).is_dir() else None

    def note(self, chosen: Path) -> None:
        """A file, or a folder among others, was chosen."""
        self.remembered.set_text(f"folders/{self.kind}", str(chosen.absolute().parent))


class UserSettings:
    """Window state, look and recently opened files, kept in Qt's settings."""

    def __init__(self, settings: QSettings | None = None) -> None:
        self._settings = settings or QSettings("trackwright", "trackwright")

    @property
    def recent(self) -> tuple[Path, ...]:
        """What was opened, the latest first."""
        value = self._settings.value("recent")
        texts = value if isinstance(value, list) else [value] if value else []
        return tuple(Path(str(text)) for text in texts)

    @property
    def recent_folder(self) -> Path | None:
        """The folder of what was opened last, which is what is open; None: there is none."""
        folders = (path.parent for path in self.recent)
        return next((folder for folder in folders if folder.is_dir()), None)

    def add_recent(self, path: Path, name: str = "", *, project: bool = False) -> None:
        """Put a path in front. name: of its recording, or of the folder of a `project`."""
        others = [one for one in self.recent if one != path]
        kept = [str(one) for one in [path, *others][:_RECENT]]
        self._settings.setValue("recent", kept)
        names = {**self._read("recent names"), str(path): name}
        known = {text: names[text] for text in kept if text in names}
        self._settings.setValue("recent names", json.dumps(known))
        kinds = {**self._read("recent projects"), str(path): project}
        projects = {text: True for text in kept if kinds.get(text)}
        self._settings.setValue("recent projects", json.dumps(projects))

    def recent_name(self, path: Path) -> str:
        """What the recording of something opened before is called; "" where that is not known."""
        name = self._read("recent names").get(str(path), "")
        return name if isinstance(name, str) else ""

    def is_recent_project(self, path: Path) -> bool:
        """Whether something opened before was opened as a project."""
        return self._read("recent projects").get(str(path)) is True

    def last_folder(self, kind: str) -> LastFolder:
        """Where files of a kind, "session" say, were chosen last."""
        return LastFolder(self, kind)

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
        places = {
            text: pair for text, pair in self._read("places").items() if Path(text) not in paths
        }
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
        match self._read("places").get(str(path)):
            case [int() as frame, int() as track]:
                return Place(frame, track)
        return Place()

    def _read(self, key: str) -> dict[str, object]:
        """What is kept by path; whatever a damaged file says instead is forgotten."""
        try:
            kept = json.loads(self.text(key, "{}"))
        except (ValueError, RecursionError):
            return {}
        return kept if isinstance(kept, dict) else {}

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

"""What the program remembers from one start to the next."""

from __future__ import annotations

from pathlib import Path

from PySide6.QtCore import QByteArray, QSettings

_RECENT = 12


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
    def left_open(self) -> tuple[Path, int] | None:
        """What was open, and at which frame, when the program ended without closing it."""
        path, frame = self.text("open/path"), self.text("open/frame", "0")
        return (Path(path), int(frame) if frame.isdigit() else 0) if path else None

    def note_open(self, path: Path, frame: int) -> None:
        """Note what is open, for a start after a crash."""
        self._settings.setValue("open/path", str(path))
        self._settings.setValue("open/frame", str(frame))

    def note_closed(self) -> None:
        """Nothing is open any more."""
        self._settings.remove("open")

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

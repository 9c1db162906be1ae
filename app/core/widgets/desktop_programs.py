"""The programs that the desktop has for files and folders."""

from __future__ import annotations

from pathlib import Path

from PySide6.QtCore import QUrl
from PySide6.QtGui import QDesktopServices


def open_place(path: Path) -> bool:
    """Open a file or a folder as a double click would; whether there is a program for it."""
    return QDesktopServices.openUrl(QUrl.fromLocalFile(str(path.resolve())))

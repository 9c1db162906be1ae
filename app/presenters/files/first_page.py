"""The first page: what was opened before, and what a crash left behind."""

from __future__ import annotations

from collections.abc import Iterable
from pathlib import Path

from app.presenters.files.opening import unsaved_folder
from app.presenters.scenes import RecentItem, WelcomeScene
from app.presenters.words import tr


def first_page(recent: Iterable[Path]) -> WelcomeScene:
    """Sessions that were never saved come first: nobody else would find them again."""
    folder = unsaved_folder()
    left = sorted(folder.glob("*.h5")) if folder.is_dir() else []
    never_saved = [_item(path, tr("never saved, kept for you")) for path in left]
    return WelcomeScene((*never_saved, *(_item(path) for path in recent)))


def _item(path: Path, detail: str = "") -> RecentItem:
    kind = tr("session") if path.suffix.lower() == ".h5" else tr("recording")
    return RecentItem(str(path), path.stem, detail or kind, path.exists())

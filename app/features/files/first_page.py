"""The first page: what was opened before, and what a crash left behind."""

from __future__ import annotations

from collections import Counter
from collections.abc import Collection, Mapping
from datetime import datetime
from pathlib import Path

from app.core.document.document_loader import unsaved_folder
from app.core.i18n import date_text, tr
from app.core.scenes import RecentItem, WelcomeScene


def first_page(recent: Mapping[Path, str], projects: Collection[Path] = ()) -> WelcomeScene:
    """Sessions that were never saved come first: nobody else would find them again.

    Args:
        recent: what was opened, the latest first, with the name of its recording; "": not known.
        projects: those of them that are folders of projects.
    """
    folder = unsaved_folder()
    left = sorted(folder.glob("*.h5")) if folder.is_dir() else []
    titles = Counter(_title(path, name) for path, name in recent.items())
    never_saved = [_item(path, path.stem, tr("never saved, kept for you")) for path in left]
    opened = (
        _item(path, _told_apart(path, name, titles), _kind(path, path in projects))
        for path, name in recent.items()
    )
    return WelcomeScene((*never_saved, *opened))


def _title(path: Path, name: str) -> str:
    return name or path.stem


def _told_apart(path: Path, name: str, titles: Counter[str]) -> str:
    """The recording's name; where several bear it, with the file's or the folder's own."""
    title = _title(path, name)
    if titles[title] == 1:
        return title
    own = path.stem if path.stem != title else path.parent.name
    return f"{title} \u2013 {own}"


def _kind(path: Path, is_project: bool) -> str:
    if is_project:
        return tr("project")
    return tr("session") if path.suffix.lower() == ".h5" else tr("recording")


def _item(path: Path, title: str, detail: str) -> RecentItem:
    try:
        changed = date_text(datetime.fromtimestamp(path.stat().st_mtime))
    except (OSError, ValueError, OverflowError):  # also a damaged path, a date that is none
        return RecentItem(str(path), title, detail, exists=False)
    return RecentItem(str(path), title, f"{detail}  \u00b7  {changed}")

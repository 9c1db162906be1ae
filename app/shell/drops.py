"""Files dropped on the window: told apart beside the window's thread, then opened or set up."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING

from PySide6.QtCore import QUrl

from app.core.controller import Controller
from app.core.jobs.latest_job import LatestJob
from app.core.widgets.work import Work
from app.features.files.track_import import holds_tracks_alone
from tracking.progress import Progress
from tracking.setup.files import is_document, may_be_camera, needs_setup

if TYPE_CHECKING:
    from app.shell.files import Files


@dataclass(frozen=True, slots=True)
class _Drop:
    """What was dropped. Attributes: number: a drop of the same files later on is another one."""

    number: int
    paths: tuple[Path, ...]


@dataclass(frozen=True, slots=True)
class _Told:
    """Attributes: to_set_up: cameras, or the folder with them; empty: it is opened as it is."""

    drop: _Drop
    to_set_up: tuple[Path, ...]


class Drops(Controller):
    """Takes drops; the newest counts. One that comes while a recording is opened waits for that."""

    def __init__(self, files: Files, work: Work) -> None:
        super().__init__(files)
        self._files, self._work = files, work
        self._count = 0
        self._waiting: _Told | None = None
        self._looks = LatestJob("dropped files", _look, self, listed=False)
        self._looks.found.connect(self._take)
        work.changed.connect(self._go_on)

    def take(self, urls: Sequence[QUrl]) -> None:
        """Open what was dropped: tracks go into the recording shown, several videos are set up."""
        paths = tuple(Path(url.toLocalFile()) for url in urls if url.isLocalFile())
        paths = tuple(path for path in paths if not self._is_for_reading(path)) or paths[:1]
        if paths and self._is_for_reading(paths[0]):
            self._files.refuse_dropped(paths[0].name)
        elif paths:
            self._count += 1
            self._looks.ask(_Drop(self._count, paths))

    def _is_for_reading(self, path: Path) -> bool:
        """Whether a file is a readme or the like; texts may be tracks where a recording is open."""
        tracks = self._files.controller is not None and holds_tracks_alone(path)
        return is_document(path) and not tracks

    def close(self) -> None:
        """The window closes."""
        self._looks.stop()
        self._waiting = None

    def _take(self, told: _Told) -> None:
        if told.drop.number != self._count:
            return
        if self._work.busy and self._files.opening:
            self._waiting = told
            return
        self._waiting = None
        first = told.drop.paths[0]
        if told.to_set_up:
            self._files.setup.begin(list(told.to_set_up))
        elif self._files.controller is not None and holds_tracks_alone(first):
            self._files.importing.read_dropped(first)
        else:
            self._files.open_path(first)

    def _go_on(self) -> None:
        if self._waiting is not None and not self._work.busy:
            self._take(self._waiting)


def _look(drop: _Drop) -> Callable[[Progress], _Told]:
    return lambda _: _told(drop)


def _told(drop: _Drop) -> _Told:
    cameras = tuple(path for path in drop.paths if may_be_camera(path))
    if len(cameras) > 1:
        return _Told(drop, cameras)
    alone = len(drop.paths) == 1 and needs_setup(drop.paths[0])
    return _Told(drop, drop.paths if alone else ())

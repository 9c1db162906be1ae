"""Somebody who corrects a session at random, without a window, and says each step that is done."""

from __future__ import annotations

import random
import sys
from collections.abc import Callable
from pathlib import Path

sys.path.insert(0, str(Path(__file__).parents[1] / "session"))

from made_up_sessions import FRAMES

from tests.sweeps.session_state import state
from tracking.editing import plan_delete, plan_draw_box, plan_rename, plan_split, plan_swap
from tracking.errors import EditError
from tracking.formats import FORMATS, Filmed
from tracking.session import (
    ImportOrigin,
    ImportWish,
    Session,
    find_backups,
    fit_to_recording,
    take_into,
)


class Corrector:
    """Edits, undoes, saves, imports, restores and opens anew; `tell` hears of each step.

    A line `= STATE` says that all before is done; `~ STATE` says before a restore what it leads to.
    """

    def __init__(self, path: Path, seed: int, tell: Callable[[str], None]) -> None:
        self._path, self._tell = path, tell
        self._chance = random.Random(seed)
        self._session = Session.open(path)

    def work(self, steps: int) -> None:
        """So many steps; each is said when it is done."""
        others = (self._save, self._save, self._open_anew, self._import, self._restore)
        for _ in range(steps):
            if self._chance.random() < 0.7:
                take_step(self._session, self._chance)
            else:
                self._chance.choice(others)()
            self._tell(f"= {state(self._session)}")

    def end(self) -> None:
        """Let go of the session."""
        self._session.close()

    def _save(self) -> None:
        self._session.save()

    def _open_anew(self) -> None:
        self._session.close()
        self._session = Session.open(self._path)

    def _import(self) -> None:
        """Take a file's tracks under new ids: one edit."""
        source = self._path.with_name("tracks.txt")
        read = FORMATS["mot"].read
        assert read is not None
        filmed = Filmed(FRAMES, 20.0, (640, 480))
        wish = ImportWish(as_new=True)
        rows = fit_to_recording(read(source, filmed), filmed, wish, self._session.tracks)
        take_into(self._session, rows, ImportOrigin.of(source, "mot"))

    def _restore(self) -> None:
        kept = find_backups(self._path)
        if kept:
            number = self._chance.randint(1, min(2, len(kept)))
            self._tell(f"~ {state(Session.look_into(kept[number - 1]))}")
            self._session = self._session.restore(number)


def take_step(session: Session, chance: random.Random) -> None:
    """One step of an editor's day, the same for the same state and chance."""
    a, b = chance.randint(1, 6), chance.randint(1, 6)
    frame, end = chance.randint(0, 40), chance.choice((None, 41))
    table = session.tracks
    steps = (
        lambda: session.apply(plan_swap(table, a, b, frame, end)),
        lambda: session.apply(plan_swap(table, a, b, frame, end)),
        lambda: session.apply(plan_split(table, a, frame)),
        lambda: session.apply(plan_delete(table, a, frame, frame + 1)),
        lambda: session.apply(plan_draw_box(table, a, frame, (1.0, 2.0, 3.0, 4.0))),
        lambda: session.apply(plan_rename(table, session.labels, a, f"person {frame}")),
        session.undo,
        session.redo,
    )
    try:
        chance.choice(steps)()
    except EditError:
        return

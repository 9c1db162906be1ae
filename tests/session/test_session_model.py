"""Whatever is edited, undone, saved, reopened and crashed: a plain list of states says the same."""

from __future__ import annotations

import shutil
import tempfile
from pathlib import Path

import pytest
from hypothesis import settings
from hypothesis import strategies as st
from hypothesis.stateful import (
    RuleBasedStateMachine,
    initialize,
    invariant,
    precondition,
    rule,
)
from made_up_sessions import make_recording, make_run, state_of

from tracking.editing import (
    Change,
    plan_delete,
    plan_draw_box,
    plan_merge,
    plan_rename,
    plan_split,
    plan_swap,
)
from tracking.errors import EditError
from tracking.session import Session, reading
from tracking.session.inspection import inspect
from tracking.session.saving import companions

TRACKS = st.integers(1, 4)
FRAMES = st.integers(0, 14)


class SessionAgainstStates(RuleBasedStateMachine):
    """`states` are the tables and labels after each edit in force; `undone` those taken back."""

    def __init__(self) -> None:
        super().__init__()
        self.patch = pytest.MonkeyPatch()
        self.patch.setattr(reading, "check_file", lambda path: inspect(path))
        self.folder = Path(tempfile.mkdtemp())
        self.crashes = 0

    @initialize()
    def begin(self) -> None:
        recording = make_recording(self.folder / "recording")
        run = make_run(tracks=3, frames=14, particles=1)
        self.session = Session.create(recording, [run], self.folder / "s.h5")
        self.states = [state_of(self.session)[:2]]
        self.undone: list[tuple[object, ...]] = []
        self.edits = 0

    @rule(kind=st.integers(0, 6), a=TRACKS, b=TRACKS, start=FRAMES, end=st.none() | FRAMES)
    def edit(self, kind: int, a: int, b: int, start: int, end: int | None) -> None:
        try:
            self.session.apply(self.planned(kind, a, b, start, end))
        except EditError:
            return
        self.states.append(state_of(self.session)[:2])
        self.undone.clear()
        self.edits += 1

    def planned(self, kind: int, a: int, b: int, start: int, end: int | None) -> Change:
        table, labels = self.session.tracks, self.session.labels
        plans = (
            lambda: plan_swap(table, a, b, start, end),
            lambda: plan_split(table, a, start),
            lambda: plan_merge(table, a, b, labels=labels),
            lambda: plan_delete(table, a, start, end),
            lambda: plan_draw_box(table, a, start, (1.0, 2.0, 3.0, 4.0)),
            lambda: plan_draw_box(table, None, start, (1.0, 2.0, 3.0, 4.0)),
            lambda: plan_rename(table, labels, a, f"person {b} of {start}"),
        )
        return plans[kind]()

    @precondition(lambda self: len(self.states) > 1)
    @rule()
    def undo(self) -> None:
        self.session.undo()
        self.undone.append(self.states.pop())

    @precondition(lambda self: self.undone)
    @rule()
    def redo(self) -> None:
        self.session.redo()
        self.states.append(self.undone.pop())

    @rule()
    def save(self) -> None:
        self.session.save()
        assert not self.session.dirty

    @rule(save=st.booleans())
    def reopen(self, save: bool) -> None:
        path = self.session.save() if save else self.folder / "s.h5"
        self.session.close()
        self.session = Session.open(path)

    @rule(while_saving=st.sampled_from(("not", "before", "after")))
    def crash(self, while_saving: str) -> None:
        """Go on with a copy of what is on the disk at some moment, as after a power cut."""
        if while_saving != "not":
            pending = self.session.begin_save()
            self.session.abandon_save(pending)
            if while_saving == "after":
                pending.write()
        self.crashes += 1
        after = self.folder / f"after-{self.crashes}"
        after.mkdir()
        shutil.copytree(companions(self.folder / "s.h5"), after / ".s.h5.trackwright")
        shutil.copy(self.folder / "s.h5", after)
        self.session.close()
        self.folder = after
        self.session = Session.open(after / "s.h5")

    @invariant()
    def nothing_is_lost(self) -> None:
        if not hasattr(self, "session"):
            return
        assert state_of(self.session)[:2] == self.states[-1]
        assert len(self.session.history) == self.edits
        assert not self.session.read_only

    def teardown(self) -> None:
        if hasattr(self, "session"):
            self.session.close()
        root = next(at for at in (self.folder, *self.folder.parents) if (at / "recording").exists())
        shutil.rmtree(root)
        self.patch.undo()


TestSessionAgainstStates = SessionAgainstStates.TestCase
TestSessionAgainstStates.settings = settings(max_examples=12, stateful_step_count=15, deadline=None)

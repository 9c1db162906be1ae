"""Whatever is edited, undone, saved, reopened and crashed: a plain list of states says the same."""

from __future__ import annotations

import os
import shutil
import tempfile
from collections.abc import Callable
from pathlib import Path

import pytest
from any_edit import label_plan, row_plan
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

from tracking.errors import EditError
from tracking.session import Session, session_reader
from tracking.session.layout import VERSION
from tracking.session.session_writer import companions

STEPS_BETWEEN_FILES = 4
"""Writing and reading files takes nearly all the time: steps between them find more."""

seldom = precondition(lambda self: self.since_file >= STEPS_BETWEEN_FILES)


class SessionAgainstStates(RuleBasedStateMachine):
    """`states` are the tables and labels after each edit in force; `undone` those taken back."""

    def __init__(self) -> None:
        super().__init__()
        self.patch = pytest.MonkeyPatch()
        # What is looked over here was written here; hostile files have tests of their own.
        self.patch.setattr(session_reader, "check_file", lambda _: VERSION)
        # A crash is a copy of the files here: what the disk has not taken yet is not lost by it.
        self.patch.setattr(os, "fsync", lambda _: None)
        self.folder = Path(tempfile.mkdtemp())
        self.crashes = self.since_file = 0

    @initialize()
    def begin(self) -> None:
        recording = make_recording(self.folder / "recording")
        run = make_run(tracks=3, frames=14, particles=1)
        self.session = Session.create(recording, [run], self.folder / "s.h5")
        self.states = [state_of(self.session)[:2]]
        self.undone: list[tuple[object, ...]] = []
        self.edits = 0

    @rule(data=st.data())
    def edit_rows(self, data: st.DataObject) -> None:
        plan = row_plan(data.draw, self.session)
        self._do(lambda: self.session.apply(plan()))

    @rule(data=st.data())
    def edit_rows_again(self, data: st.DataObject) -> None:
        """As likely as all that does not edit: undo, saving, crashes."""
        self.edit_rows(data)

    @rule(data=st.data())
    def edit_labels(self, data: st.DataObject) -> None:
        plan = label_plan(data.draw, self.session)
        self._do(lambda: self.session.apply(plan()))

    @precondition(lambda self: self.edits > 1)
    @rule(data=st.data())
    def undo_alone(self, data: st.DataObject) -> None:
        number = data.draw(st.integers(1, self.edits))
        self._do(lambda: self.session.undo_alone(number))

    def _do(self, step: Callable[[], object]) -> None:
        try:
            step()
        except EditError:
            return
        self.states.append(state_of(self.session)[:2])
        self.undone.clear()
        self.edits += 1
        self.since_file += 1

    @precondition(lambda self: len(self.states) > 1)
    @rule()
    def undo(self) -> None:
        self.session.undo()
        self.undone.append(self.states.pop())
        self.since_file += 1

    @precondition(lambda self: self.undone)
    @rule()
    def redo(self) -> None:
        self.session.redo()
        self.states.append(self.undone.pop())
        self.since_file += 1

    @seldom
    @rule()
    def save(self) -> None:
        self.session.save()
        self.since_file = 0
        assert not self.session.dirty

    @seldom
    @rule(save=st.booleans())
    def reopen(self, save: bool) -> None:
        path = self.session.save() if save else self.folder / "s.h5"
        self.session.close()
        self.session = Session.open(path)
        self.since_file = 0

    @seldom
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
        self.since_file = 0

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
# `make model` has ten thousand of them.
TestSessionAgainstStates.settings = settings(max_examples=50, stateful_step_count=50, deadline=None)

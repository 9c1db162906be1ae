"""What a failed try told goes with its cause: it stays no longer than what it was about."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

import pytest

from app.features.setup.presenter import still_told
from app.features.setup.scene import SetupState, Step
from tracking.geometry import Ground
from tracking.setup import SetupPlan
from tracking.setup.files import is_document

STATE = SetupState(SetupPlan(Path("a/left.mp4"), Path("a/right.mp4")))
TOLD = dict.fromkeys(Step, "failed")


def with_plan(**changes: object) -> SetupState:
    assert STATE.plan is not None
    return replace(STATE, plan=replace(STATE.plan, **changes))


@pytest.mark.parametrize(
    ("after", "first_gone"),
    [
        (with_plan(lag=2), Step.CAMERAS),
        (with_plan(calibration=(Path("c.yaml"),)), Step.CALIBRATION),
        (replace(STATE, calibration_method="board"), Step.CALIBRATION),
        (with_plan(ground=Ground(2.0, 30.0)), Step.FLOOR),
        (replace(STATE, floor_method="points"), Step.FLOOR),
        (with_plan(name="hall"), Step.WRITE),
    ],
)
def test_a_change_takes_back_what_later_steps_told(after: SetupState, first_gone: Step) -> None:
    steps = tuple(Step)
    assert tuple(still_told(TOLD, STATE, after)) == steps[: steps.index(first_gone)]


def test_the_same_state_takes_nothing_back() -> None:
    assert still_told(TOLD, STATE, replace(STATE)) == TOLD


@pytest.mark.parametrize(
    ("name", "expected"),
    [
        *(("README", True), ("readme.md", True), ("notes.txt", True), ("paper.pdf", True)),
        *(("left.mp4", False), ("walk.h5", False), ("recording.toml", False), ("cam.yaml", False)),
    ],
)
def test_files_to_read_are_told_from_footage(tmp_path: Path, name: str, expected: bool) -> None:
    (tmp_path / name).write_text("words")
    assert is_document(tmp_path / name) is expected

"""An examination in the words of the doctor's page."""

from __future__ import annotations

import math
from dataclasses import replace

from app.features.doctor.presenter import scene_of
from app.features.doctor.scene import State
from tracking.doctor import Examination, Finding, Mend
from tracking.translation import msg


def finding(cost_m: float, mend: Mend | None = None) -> Finding:
    """One with every kind of figure."""
    evidence = {"amount": 0.5, "sigma": 0.01, "unit": "degrees", "z": 50.0, "matches": 120}
    return Finding(
        "right-rolled", msg("the right camera is rolled"), msg("mend it"), evidence, cost_m,
        alike=("right-tilted",), mend=mend,
    )  # fmt: skip


def test_a_finding_is_told_with_cost_meaning_and_figures_that_people_read() -> None:
    scene = scene_of(Examination((finding(0.123, Mend(lag=1)),), ("rows",), {}))
    assert scene.state is State.FOUND
    (shown,) = scene.findings
    assert shown.title == "The right camera is rolled"
    assert shown.cost == "0.12 m on the floor"
    assert shown.meaning == "A person at 5 m is misplaced by 0.12 m on the floor."
    assert shown.figures == (
        ("Amount", "0.50 ± 0.01 degrees"),
        ("Points seen in both cameras", "120"),
    )
    assert shown.alike == "right-tilted"
    assert shown.mendable


def test_figures_of_floors_are_named_in_words() -> None:
    names = ("height_m", "height_told_m", "tilt_deg", "tilt_told_deg", "roll_deg", "roll_told_deg")
    found = replace(finding(0.1), evidence=dict.fromkeys(names, 2.0))
    (shown,) = scene_of(Examination((found,), ("floor",), {})).findings
    told = [name for name, _ in shown.figures]
    assert told[:2] == ["Height measured (m)", "Height in recording.toml (m)"]
    assert not any("_" in name for name in told)


def test_costs_beyond_all_bounds_and_below_a_centimetre_are_words() -> None:
    scene = scene_of(Examination((finding(math.inf), finding(0.001)), (), {}))
    first, second = scene.findings
    assert first.cost == "no position is right"
    assert "less than 1 cm" in second.cost
    assert not first.mendable


def test_what_was_checked_and_what_could_not_be_is_said_where_nothing_is_wrong() -> None:
    scene = scene_of(Examination((), ("camera-moved",), {"floor": msg("needs two cameras")}))
    assert scene.state is State.WELL
    assert "Checked: whether a camera moved" in scene.text
    assert scene.unchecked == "Not checked: where the floor is (needs two cameras)"

"""Which review items are decided together, and how many that are."""

import pytest

from app.features.review.alike import groups_alike, plan_decisions
from app.features.review.alike_dialog import AlikeDialog
from tracking.editing import apply_change
from tracking.review import ReviewItem
from tracking.tracks import Labels, TrackTable


def _item(kind, tracks, frame, likelihood):
    return ReviewItem(kind, tracks, frame, frame - 5, frame + 5, likelihood, 9.0, kind, "look")


CURRENT = _item("lost", (4, 7), 50, 0.3)
LEFT = (
    _item("lost", (9,), 20, 0.8),
    CURRENT,
    _item("lost", (8,), 90, 0.1),
    _item("jump", (4,), 70, 0.2),
    _item("jump", (5,), 75, 0.9),
)


@pytest.fixture
def groups():
    return groups_alike(CURRENT, LEFT, lambda track: f"{track} red & blue")


def test_of_the_kind_of_a_person_and_of_less_chance(groups):
    found = {group.title: [one.frame for one in group.items] for group in groups}
    assert found == {
        "All of this kind: Lost, then found": [20, 50, 90],
        "All of this kind that are 30% likely or less to be errors": [50, 90],
        "All of 4 red & blue": [50, 70],
        "All that are 30% likely or less to be errors": [50, 90, 70],
    }


def test_where_no_other_is_like_it_there_is_no_group():
    assert groups_alike(CURRENT, (CURRENT,), str) == ()


def test_one_change_decides_all(groups):
    change = plan_decisions(groups[0].items, "right", Labels())
    labels = apply_change(TrackTable(), Labels(), change)
    assert {key[2] for key in labels.verdicts} == {20, 50, 90}
    assert "3 review items" in change.text


def test_the_dialog_shows_what_is_chosen_and_tells_which_it_was(groups, qtbot):
    from PySide6.QtWidgets import QWidget

    parent = QWidget()
    qtbot.addWidget(parent)
    dialog = AlikeDialog(groups, 10.0, parent)
    told = []
    dialog.decided.connect(lambda items, decision: told.append((len(items), decision)))
    assert dialog.listed.count() == 3
    assert dialog.choices.button(2).text() == "All of 4 red && blue (2 items)"
    dialog.choices.button(2).click()
    assert dialog.listed.count() == 2
    assert dialog.listed.item(0).text().startswith("00:05.00")
    dialog.dismiss.click()
    assert told == [(2, "dismissed")]

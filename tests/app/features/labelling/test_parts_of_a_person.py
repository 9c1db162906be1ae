"""Where parts of a person are that nobody labelled in a frame."""

import pytest

from app.features.labelling.parts import parts_of, parts_over
from tracking.editing import apply_change, plan_label_part, plan_put_box
from tracking.tracks import Labels, PartLabel, TrackTable

HEAD, TORSO = 0, 1


@pytest.fixture
def walked():
    """A person of twice the size in frame 3, whose head was drawn in frame 1."""
    table, labels = TrackTable(), Labels()
    boxes = {1: (10.0, 20.0, 20.0, 60.0), 2: (30.0, 20.0, 20.0, 60.0), 3: (0.0, 0.0, 40.0, 120.0)}
    for frame, box in boxes.items():
        apply_change(table, labels, plan_put_box(table, 1 if frame > 1 else None, frame, box))
    plan = plan_label_part(labels, PartLabel(1, 1, HEAD, (12.0, 26.0, 8.0, 10.0)))
    return table, apply_change(table, labels, plan)


def test_a_rectangle_that_was_drawn_goes_along_with_the_box_of_the_person(walked):
    table, labels = walked
    parts = {frame: parts_of(labels, table, None, 1, frame) for frame in (2, 3)}
    assert parts[2][HEAD][0].box == pytest.approx((32, 26, 8, 10))
    assert parts[3][HEAD][0].box == pytest.approx((4, 12, 16, 20))
    assert not parts[2][HEAD][1]  # nobody said so there


def test_a_range_has_it_too_and_other_parts_stay_where_a_box_has_them(walked):
    table, labels = walked
    one, two, _ = parts_over(labels, table, None, (1, HEAD), (1, 4))
    assert (two.box[0] - one.box[0], two.box[1]) == pytest.approx((20, 26))
    before = parts_of(Labels(), table, None, 1, 2)
    assert parts_of(labels, table, None, 1, 2)[TORSO] == before[TORSO]

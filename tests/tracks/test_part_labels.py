"""Part labels are a value: a plain dictionary says the same, whatever is changed."""

from __future__ import annotations

from hypothesis import given
from hypothesis import strategies as st

from tracking.tracks import PartKey, PartLabel, PartLabels

KEYS = st.tuples(st.integers(0, 600), st.integers(1, 3), st.integers(0, 2))
WIDTHS = st.integers(1, 3).map(float)


def label(key: PartKey, width: float) -> PartLabel:
    return PartLabel(*key, (0.0, 0.0, width, 1.0))


@given(st.lists(st.tuples(st.sets(KEYS, max_size=4), st.dictionaries(KEYS, WIDTHS, max_size=4))))
def test_a_dictionary_says_the_same(steps: list[tuple[set[PartKey], dict[PartKey, float]]]) -> None:
    labels, model = PartLabels(), {}
    for out, into in steps:
        before, was = labels, dict(model)
        labels = labels.changed(out, [label(key, width) for key, width in into.items()])
        for key in out:
            model.pop(key, None)
        model.update({key: label(key, width) for key, width in into.items()})
        assert dict(before) == was
    assert dict(labels) == model
    assert list(labels) == sorted(model)
    assert len(labels) == len(model)
    assert labels == PartLabels(model.values())
    for frame in (0, 255, 256, 600):
        assert labels.of_frame(frame) == tuple(
            model[key] for key in sorted(model) if key[0] == frame
        )
    for track in (1, 2, 3):
        assert labels.of_track(track, 100, 512) == tuple(
            model[key] for key in sorted(model) if key[1] == track and 100 <= key[0] < 512
        )


def test_labels_that_say_something_else_are_not_equal() -> None:
    one = PartLabels([label((3, 1, 0), 1.0)])
    assert one != PartLabels([label((3, 1, 0), 2.0)])
    assert one != PartLabels()
    assert one != {(3, 1, 0): label((3, 1, 0), 1.0)}.values()


def test_what_is_taken_out_leaves_nothing_behind() -> None:
    one = PartLabels([label((3, 1, 0), 1.0)])
    assert one.changed([(3, 1, 0)], []) == PartLabels()
    assert one.changed([(9, 1, 0)], []) == one
    assert (3, 1, 0) in one
    assert (9, 1, 0) not in one

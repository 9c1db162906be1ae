"""What two sets of part labels say differently."""

from dataclasses import replace

from hypothesis import given
from hypothesis import strategies as st

from tracking.tracks import PartLabel, PartLabels

KEYS = st.tuples(st.sampled_from([0, 1, 255, 256, 900]), st.integers(1, 3), st.integers(0, 2))


def _label(key) -> PartLabel:
    return PartLabel(*key, (1.0, 2.0, 3.0, 4.0))


@given(st.sets(KEYS), st.sets(KEYS), st.sets(KEYS))
def test_what_differs_makes_the_one_into_the_other(keys, out, into):
    before = PartLabels(map(_label, keys))
    after = before.changed(out & keys, [replace(_label(key), on_part=None) for key in into])
    here, there = before.unlike(after)
    assert before.changed([label.key for label in here], there) == after
    assert {label.frame for label in (*here, *there)} <= {key[0] for key in out | into}


def test_what_is_the_same_differs_in_nothing():
    labels = PartLabels([_label((5, 1, 0))])
    assert labels.unlike(labels) == ([], [])
    assert labels.unlike(labels.changed([(5, 1, 0)], [])) == ([_label((5, 1, 0))], [])

from __future__ import annotations

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from hypothesis.extra import numpy as arrays

from tracking.pipeline.particle_codec import CODINGS, Plain, Runs, Shares, Steps
from tracking.pipeline.spool import Spool
from tracking.pipeline.spool_tables import SpooledColumn
from tracking.tracks import PART_PARTICLE_COLUMNS, PARTICLE_COLUMNS

FLOAT, WHOLE = np.dtype(np.float32), np.dtype(np.int32)
PLACES = arrays.arrays(np.float32, 40, elements=st.floats(-500, 500, width=32))


def column(coding, dtype, *stretches) -> SpooledColumn:
    made = SpooledColumn(Spool(), coding, dtype)
    for values in stretches:
        made.append(np.asarray(values, dtype))
    return made


@given(PLACES)
def test_places_are_at_most_half_a_millimetre_off(places: np.ndarray):
    read = np.asarray(column(Steps(1 / 1024), FLOAT, places))
    assert read.dtype == FLOAT
    assert np.abs(read.astype(float) - places).max() <= 0.0005


@given(PLACES, st.integers(1, 39))
def test_places_are_rounded_alike_however_they_are_put_aside(places: np.ndarray, at: int):
    whole = np.asarray(column(Steps(1 / 1024), FLOAT, places))
    halves = np.asarray(column(Steps(1 / 1024), FLOAT, places[:at], places[at:]))
    assert whole.tobytes() == halves.tobytes()
    again = np.asarray(column(Steps(1 / 1024), FLOAT, whole))
    assert again.tobytes() == whole.tobytes()


@pytest.mark.parametrize("far", [1e4, 1e9, np.nan, np.inf])
def test_places_far_away_and_unknown_ones_are_put_aside_too(far: float):
    read = np.asarray(column(Steps(1 / 1024), FLOAT, [0.5, far, -3.0]))
    assert read.tobytes() == np.array([0.5, far, -3.0], FLOAT).tobytes()


def test_places_take_two_bytes_and_ids_hardly_any():
    spool = Spool()
    Steps(1 / 1024).put(spool, np.linspace(-30, 30, 1000, dtype=np.float32))
    assert spool.size == 2000
    Runs().put(spool, np.repeat(np.arange(1, 3), 500))
    assert spool.size == 2016


@given(arrays.arrays(np.float32, 30, elements=st.floats(0, 1, width=32)))
def test_weights_are_right_to_three_digits(weights: np.ndarray):
    read = np.asarray(column(Shares(), FLOAT, weights)).astype(float)
    assert np.all(np.abs(read - weights) <= np.maximum(weights * 2.0**-11, 2.0**-25))


@given(arrays.arrays(np.int32, st.integers(1, 30), elements=st.integers(0, 3)), st.data())
def test_any_rows_of_a_column_of_ids_are_read(ids: np.ndarray, data: st.DataObject):
    at = data.draw(st.integers(0, len(ids)))
    start = data.draw(st.integers(0, len(ids)))
    stop = data.draw(st.integers(0, len(ids)))
    stored = column(Runs(), WHOLE, ids[:at], ids[at:])
    assert len(stored) == len(ids)
    assert stored[start:stop].tolist() == ids[start:stop].tolist()


def test_what_a_tracker_links_by_its_bits_is_kept_bit_by_bit():
    values = np.random.default_rng(1).normal(300, 90, 50).astype(np.float32)
    assert np.asarray(column(Plain(), FLOAT, values)).tobytes() == values.tobytes()


def test_places_and_weights_of_particles_take_sixteen_bits_each():
    for table, types in (
        ("particles", PARTICLE_COLUMNS),
        ("part_particles", PART_PARTICLE_COLUMNS),
    ):
        assert list(CODINGS[table]) == list(types)
        for name, coding in CODINGS[table].items():
            assert isinstance(coding, Steps | Shares) == (types[name] == FLOAT)

"""Peaks are those that SciPy finds."""

import subprocess
import sys

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from scipy.signal import find_peaks

from tracking.people.heads import peaks_of

LINES = st.lists(st.integers(0, 8), min_size=1, max_size=60)


@given(LINES, st.sampled_from([0.5, 1.0, 3.0]))
def test_peaks_and_their_prominences_are_those_of_scipy(heights, least):
    line = np.array(heights, np.float64)
    places, found = find_peaks(line, prominence=least, plateau_size=1)
    peaks, rises = peaks_of(line, least)
    assert peaks.tolist() == places.tolist()
    assert rises.tolist() == found["prominences"].tolist()


def test_a_long_line_of_noise_has_the_same_peaks():
    line = np.random.default_rng(3).normal(size=2000).cumsum()
    places, found = find_peaks(line, prominence=1.0, plateau_size=1)
    peaks, rises = peaks_of(line, 1.0)
    assert np.array_equal(peaks, places)
    assert np.array_equal(rises, found["prominences"])


@pytest.mark.parametrize("module", ["tracking.trackers", "app.cli.track", "app.cli.trackers"])
def test_nothing_that_is_typed_waits_for_scipys_signals_and_statistics(module):
    asked = f"import sys, {module}; print({{'scipy.signal', 'scipy.stats'}} & set(sys.modules))"
    done = subprocess.run([sys.executable, "-c", asked], capture_output=True, text=True, check=True)
    assert done.stdout.strip() == "set()"

"""Which samples are of one recording, and so whose people are held out together."""

from __future__ import annotations

import numpy as np
import pytest
from made_up_parts import made_up_samples

from tracking.failure import Samples, told_apart


@pytest.fixture(scope="module")
def lobby() -> Samples:
    return made_up_samples(seed=4108, people=2, recording="lobby")


def names(apart: list[Samples]) -> list[str]:
    return ["/".join(sorted(set(one.columns["recording"]))) for one in apart]


def test_the_same_footage_keeps_one_name(lobby: Samples) -> None:
    apart = told_apart([(lobby, "a", "one"), (lobby, "a", "two")])
    assert names(apart) == ["lobby", "lobby"]


def test_other_footage_of_that_name_gets_its_title_too(lobby: Samples) -> None:
    apart = told_apart([(lobby, "a", "one"), (lobby, "b", "two")])
    assert names(apart) == ["lobby", "lobby (two)"]


def test_two_sessions_of_footage_that_was_renamed_keep_one_name(lobby: Samples) -> None:
    sources = [(lobby, "a", "one"), (lobby, "b", "two"), (lobby, "b", "three")]
    assert names(told_apart(sources)) == ["lobby", "lobby (two)", "lobby (two)"]


def test_sessions_of_one_title_are_told_apart_all_the_same(lobby: Samples) -> None:
    sources = [(lobby, footage, "day") for footage in "abc"]
    assert names(told_apart(sources)) == ["lobby", "lobby (day)", "lobby (day, 2)"]


@pytest.mark.parametrize("table_first", [True, False])
def test_a_table_speaks_of_the_recording_it_names(lobby: Samples, table_first: bool) -> None:
    sources = [(lobby, "", "table"), (lobby, "a", "one")]
    apart = told_apart(sources if table_first else sources[::-1])
    assert names(apart) == ["lobby", "lobby"]


def test_nothing_but_names_is_changed(lobby: Samples) -> None:
    other = told_apart([(lobby, "a", "one"), (lobby, "b", "two")])[1]
    assert np.array_equal(other.features, lobby.features)
    assert all(
        np.array_equal(other.columns[name], lobby.columns[name])
        for name in lobby.columns
        if name != "recording"
    )

"""Which samples are of one recording, and so whose people are held out together."""

from __future__ import annotations

import numpy as np
import pytest
from made_up_parts import made_up_samples

from tracking.failure import SAMPLE_COLUMNS, Samples, joined, told_apart


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


def test_one_footage_under_two_names_is_one_recording(lobby: Samples) -> None:
    renamed = made_up_samples(seed=4109, people=2, recording="entrance")
    assert names(told_apart([(lobby, "a", "one"), (renamed, "a", "two")])) == ["lobby", "lobby"]


def people(apart: list[Samples]) -> set[int]:
    return set(joined(apart).people().tolist())


def test_people_of_one_recording_tracked_twice_are_not_told_apart(lobby: Samples) -> None:
    again = made_up_samples(seed=4109, people=2, recording="lobby")
    other = made_up_samples(seed=4110, people=2, recording="yard")
    assert len(people(told_apart([(lobby, "a", "one"), (other, "b", "two")]))) == 4
    twice = told_apart([(lobby, "a", "one"), (again, "a", "two"), (other, "b", "three")])
    who = joined(twice).people()
    assert len(set(who[: -len(other)])) == 1
    assert len(set(who[-len(other) :])) == 2


def test_a_table_of_a_session_s_own_tracks_tells_the_same_people_apart(lobby: Samples) -> None:
    some = lobby[np.arange(len(lobby)) % 3 > 0]
    apart = told_apart([(lobby, "a", "one"), (some, "", "table")])
    assert len(people(apart)) == 2
    both = joined(apart).instants()
    assert set(both[len(lobby) :]) <= set(both[: len(lobby)])


def test_people_whom_truth_names_are_told_apart_in_every_session(lobby: Samples) -> None:
    known = lobby.with_columns(person=lobby.columns["track"])
    swapped = lobby.with_columns(person=3 - lobby.columns["track"])
    both = joined(told_apart([(known, "a", "one"), (swapped, "a", "two")]))
    who, track = both.people(), both.columns["track"]
    half = len(lobby)
    assert len(set(who.tolist())) == 2
    assert np.array_equal(who[:half][track[:half] == 1], who[half:][track[half:] == 2])


def test_the_tracks_of_two_sessions_are_never_one_instant(lobby: Samples) -> None:
    again = made_up_samples(seed=4109, people=2, recording="lobby")
    apart = told_apart([(lobby, "a", "one"), (again, "a", "two")])
    moments = [set(joined(apart[:count]).instants().tolist()) for count in (1, 2)]
    assert len(moments[1]) == 2 * len(moments[0])


def test_nothing_but_names_is_changed(lobby: Samples) -> None:
    other = told_apart([(lobby, "a", "one"), (lobby, "b", "two")])[1]
    assert np.array_equal(other.features, lobby.features, equal_nan=True)
    assert all(
        np.array_equal(other.columns[name], lobby.columns[name])
        for name in SAMPLE_COLUMNS
        if name != "recording"
    )

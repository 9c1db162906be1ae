"""Which settings of a tracker are offered to everybody, and which on request."""

import dataclasses

import pytest

from tracking.setting import setting, stage
from tracking.settings import settings_fields
from tracking.trackers import TRACKERS

MOST = 20
"""More would not be read."""


@pytest.mark.parametrize("name", TRACKERS)
def test_a_tracker_offers_at_most_twenty_settings(name):
    fields = settings_fields(TRACKERS[name].settings_type)
    assert 1 <= sum(not field.expert for field in fields) <= MOST


@pytest.mark.parametrize("name", TRACKERS)
def test_stages_name_expert_settings_that_they_offer_otherwise(name):
    settings = TRACKERS[name].settings_type()
    for field in dataclasses.fields(settings):
        inner = getattr(settings, field.name)
        if dataclasses.is_dataclass(inner):
            offered = {one.name for one in settings_fields(type(inner)) if not one.expert}
            assert set(field.metadata.get("expert", ())) <= offered


@dataclasses.dataclass(frozen=True)
class Inner:
    plain: float = setting(1.0, "", None, "Left alone.")
    rare: float = setting(1.0, "", None, "Rarely changed.", expert=True)
    of_no_use: float = setting(1.0, "", None, "Of no use to the outer one.")


@dataclasses.dataclass(frozen=True)
class Outer:
    own: float = setting(1.0, "", None, "Its own.")
    inner: Inner = stage(Inner, expert=("of_no_use",))


def test_a_tracker_marks_settings_of_an_earlier_stage_as_expert_too():
    expert = {field.name: field.expert for field in settings_fields(Outer)}
    assert expert == {
        "own": False,
        "inner.plain": False,
        "inner.rare": True,
        "inner.of_no_use": True,
    }
    assert not any(field.expert for field in settings_fields(Inner) if field.name != "rare")

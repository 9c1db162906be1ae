"""Settings describe themselves."""

from __future__ import annotations

from dataclasses import fields

import pytest

from tracking.foreground import ForegroundSettings
from tracking.people import PeopleSettings
from tracking.stereo import StereoSettings

ALL = [
    pytest.param(settings, field, id=f"{type(settings).__name__}.{field.name}")
    for settings in (ForegroundSettings(), StereoSettings(), PeopleSettings())
    for field in fields(settings)
]


@pytest.mark.parametrize(("settings", "field"), ALL)
def test_a_setting_says_its_unit_range_and_meaning(settings: object, field: object) -> None:
    metadata = field.metadata
    if isinstance(getattr(settings, field.name), bool):
        assert metadata["range"] is None
    else:
        low, high = metadata["range"]
        assert low <= getattr(settings, field.name) <= high
    assert isinstance(metadata["unit"], str)
    assert metadata["help"]

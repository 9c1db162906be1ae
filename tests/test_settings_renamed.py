"""Settings that had other names in earlier versions."""

from __future__ import annotations

from dataclasses import dataclass, field

import pytest

from tracking.errors import SettingsError
from tracking.setting import setting
from tracking.settings import former_names, settings_from, settings_from_text, with_present_names


@dataclass(frozen=True, slots=True)
class Stage:
    bandwidth: float = setting(1.0, "", (0.0, 5.0), "Size of the kernel", formerly=("reach",))


@dataclass(frozen=True, slots=True)
class Own:
    process_noise: float = setting(
        1.0, "", (0.0, 9.0), "Process noise", formerly=("agility", "spread")
    )
    clusters: Stage = field(default_factory=Stage)


def test_every_former_name_leads_to_the_present_one_within_its_stage() -> None:
    assert former_names(Own) == {
        "agility": "process_noise",
        "spread": "process_noise",
        "clusters.reach": "clusters.bandwidth",
    }


def test_kept_values_are_read_under_the_present_names() -> None:
    kept = {"agility": 3.0, "clusters.reach": 2.0, "unknown": 7}
    named = with_present_names(Own, kept)
    assert named == {"process_noise": 3.0, "clusters.bandwidth": 2.0, "unknown": 7}


@pytest.mark.parametrize("names", [("agility", "process_noise"), ("process_noise", "agility")])
def test_of_two_names_of_one_setting_the_present_one_counts(names: tuple[str, str]) -> None:
    kept = {name: 2.0 if name == "process_noise" else 5.0 for name in names}
    assert with_present_names(Own, kept) == {"process_noise": 2.0}


@pytest.mark.parametrize("name", ["agility", "spread", "clusters.reach"])
def test_who_types_a_former_name_is_told_the_present_one(name: str) -> None:
    present = former_names(Own)[name]
    for refused in (
        lambda: settings_from_text(Own, {name: "2"}),
        lambda: settings_from(Own, {name: 2.0}),
    ):
        with pytest.raises(SettingsError) as error:
            refused()
        assert str(error.value) == f"setting {name} is unknown: its name is {present} now"

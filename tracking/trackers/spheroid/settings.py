"""The settings of the spheroid tracker."""

from __future__ import annotations

from dataclasses import dataclass, field

from tracking.errors import SettingsError
from tracking.foreground import ForegroundSettings, RampSettings
from tracking.setting import setting
from tracking.trackers.occluders import occluders_from

_PAPER_HEIGHT_M = 1.8


def _sensitive() -> ForegroundSettings:
    """What a ramp makes of small differences is little, so that it may begin early."""
    return ForegroundSettings(threshold=12.0)


@dataclass(frozen=True, slots=True)
class SpheroidSettings:
    """What the spheroid tracker can be told; see the `help` of each field."""

    paper: bool = setting(
        False, "", None, "as published: one fixed spheroid, plain scores as weights, no colours"
    )
    particles: int = setting(300, "", (10, 5000), "hypotheses for each person")
    radius_m: float = setting(0.25, "m", (0.1, 0.6), "minor semi-axes of a person's spheroid")
    least_height_m: float = setting(1.35, "m", (0.5, 2.2), "lowest body height that is estimated")
    most_height_m: float = setting(2.0, "m", (0.6, 2.5), "largest body height that is estimated")
    usual_height_m: float = setting(
        1.72, "m", (0.5, 2.4), "body height thought of a newcomer; paper takes 1.8"
    )
    spread_m: float = setting(
        0.12, "m/√s", (0.0, 2.0), "random spread of the hypotheses' places after a second"
    )
    spread_velocity: float = setting(0.8, "m/s/√s", (0.0, 10.0), "the same of their velocities")
    region_scale: float = setting(
        2.0,
        "",
        (1.0, 4.0),
        "the region of evaluation, in sizes of the person's spheroid; counts with paper only",
    )
    apart_m: float = setting(
        0.35,
        "m",
        (0.0, 2.0),
        "a hypothesis closer than this to another person's place counts 0; paper takes two radii",
    )
    colour_weight: float = setting(
        6.0,
        "",
        (0.0, 100.0),
        "how much the colours of a person say against foreground; 0, or with paper: nothing",
    )
    birth_every_s: float = setting(0.2, "s", (0.02, 10.0), "how often newcomers are looked for")
    birth_looks: int = setting(
        2, "", (1, 50), "looks in which a newcomer must be seen before it becomes a track"
    )
    largest_spread_m: float = setting(
        0.9, "m", (0.1, 10.0), "a track ends when its hypotheses are spread wider than this"
    )
    lost_hidden_s: float = setting(
        1.5,
        "s",
        (0.05, 60.0),
        "time after which a person hidden by others is given up; not with paper",
    )
    remembered_s: float = setting(
        5.0,
        "s",
        (0.0, 120.0),
        "so long somebody lost gets the same track when found again near by; not with paper",
    )
    smooth: bool = setting(
        True, "", None, "once tracked, smooth paths and boxes from both ends and fill their gaps"
    )
    occluders: str = setting(
        "", "", None, "outlines of what hides people: [[[u, v], ...], ...] in px of the left image"
    )
    ramp: RampSettings = field(default_factory=RampSettings)
    foreground: ForegroundSettings = field(default_factory=_sensitive)

    @property
    def newcomer_m(self) -> float:
        """Body height thought of a newcomer, m; as published one fixed height, everybody's."""
        return _PAPER_HEIGHT_M if self.paper else self.usual_height_m

    def __post_init__(self) -> None:
        """Check what belongs together, before any work; raises `SettingsError`."""
        occluders_from(self.occluders)
        if not self.least_height_m <= self.usual_height_m <= self.most_height_m:
            raise SettingsError(
                f"usual_height_m: {self.usual_height_m} is not between least_height_m, "
                f"{self.least_height_m}, and most_height_m, {self.most_height_m}; change one"
            )
        if self.ramp.low >= self.ramp.high:
            raise SettingsError(
                f"ramp.low: {self.ramp.low} is not below ramp.high, {self.ramp.high}; lower it"
            )

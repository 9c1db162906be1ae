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
        False,
        "",
        None,
        "follow people exactly as published: one fixed spheroid, plain scores as weights, no "
        "colours",
    )
    particles: int = setting(
        300,
        "",
        (10, 5000),
        "guesses kept of where each person is; more follow crowds more surely and take more time",
    )
    radius_m: float = setting(
        0.25,
        "m",
        (0.1, 0.6),
        "how stout a person's egg-shaped body model (spheroid) is: half its breadth; higher: "
        "neighbours share more of the picture",
    )
    least_height_m: float = setting(
        1.35,
        "m",
        (0.5, 2.2),
        "lowest body height that is estimated; higher: children come out too tall and too near",
    )
    most_height_m: float = setting(2.0, "m", (0.6, 2.5), "largest body height that is estimated")
    usual_height_m: float = setting(
        1.72, "m", (0.5, 2.4), "body height a newcomer begins with; the paper takes 1.8"
    )
    spread_m: float = setting(
        0.12,
        "m/√s",
        (0.0, 2.0),
        "how far people may stray from their expected place in a second; higher: sudden turns "
        "are followed, neighbours are mixed up sooner",
    )
    spread_velocity: float = setting(0.8, "m/s/√s", (0.0, 10.0), "the same for how fast they walk")
    region_scale: float = setting(
        2.0,
        "",
        (1.0, 4.0),
        "how large the surroundings are that a guess is judged by, in sizes of the spheroid; "
        "counts with paper only",
    )
    apart_m: float = setting(
        0.35,
        "m",
        (0.0, 2.0),
        "no two people are nearer to each other; higher: fewer double tracks, who walks close "
        "together is lost; the paper takes two radii",
    )
    colour_weight: float = setting(
        6.0,
        "",
        (0.0, 100.0),
        "how much clothes decide, beside foreground; higher: fewer swapped ids where clothes "
        "differ; 0, or with paper: not at all",
    )
    birth_every_s: float = setting(
        0.2,
        "s",
        (0.02, 10.0),
        "how often newcomers are looked for; lower: found sooner, at the price of time",
    )
    birth_looks: int = setting(
        2,
        "",
        (1, 50),
        "looks a newcomer must be seen in before it becomes a track; higher: fewer false tracks, "
        "which begin later",
    )
    largest_spread_m: float = setting(
        0.9,
        "m",
        (0.1, 10.0),
        "a track ends when its guesses are spread wider than this; higher: doubtful people are "
        "kept longer",
    )
    lost_hidden_s: float = setting(
        1.5,
        "s",
        (0.05, 60.0),
        "how long a person hidden by others is waited for; not with paper",
    )
    remembered_s: float = setting(
        5.0,
        "s",
        (0.0, 120.0),
        "for how long somebody lost gets the same id back when found near by; 0: never; not with "
        "paper",
    )
    smooth: bool = setting(
        True,
        "",
        None,
        "once tracked, look the whole run over: one id for a person's whole stay (not with paper), "
        "smooth paths and boxes, gaps filled",
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

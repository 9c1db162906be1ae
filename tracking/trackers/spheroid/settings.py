"""The settings of the spheroid tracker."""

from __future__ import annotations

from dataclasses import dataclass

from tracking.detections.settings import ONLY, DetectionSettings
from tracking.errors import SettingsError
from tracking.foreground import ForegroundSettings, RampSettings
from tracking.setting import setting, stage
from tracking.trackers.shared.occluders import occluders_from

_PAPER_HEIGHT_M, _PAPER_SPREAD_M = 1.8, 0.9
_UNUSED = (
    *("shadow_threshold", "floor_shadow_threshold", "shadow_texture", "shadow_hue"),
    *("shadow_constant", "shadow_min_brightness"),
)
"""`ShadowWeights` learns beside people what a shadow is."""


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
        "Track exactly as published, without our additions: one fixed spheroid, plain scores as "
        "weights, no colours",
    )
    particles: int = setting(
        300,
        "",
        (10, 5000),
        "Particles per person; higher: tracking in crowds is more reliable but takes more time",
        group="Particles and motion",
    )
    radius_m: float = setting(
        0.25,
        "m",
        (0.1, 0.6),
        "Radius of the spheroid that models a body (half its width); higher: neighbours share "
        "more of the image",
        group="Bodies",
    )
    min_height_m: float = setting(
        1.35,
        "m",
        (0.5, 2.2),
        "Smallest body height that is estimated; higher: children are estimated too tall and too "
        "near",
        formerly=("least_height_m",),
        group="Bodies",
    )
    max_height_m: float = setting(
        2.0,
        "m",
        (0.6, 2.5),
        "Largest body height that is estimated; higher: tall people fit better",
        formerly=("most_height_m",),
        group="Bodies",
    )
    initial_height_m: float = setting(
        1.72,
        "m",
        (0.5, 2.4),
        "Body height of a tentative track (1.8 in the paper); higher: it starts nearer to the "
        "camera",
        formerly=("usual_height_m",),
        group="Bodies",
        expert=True,
    )
    process_noise_m: float = setting(
        0.12,
        "m/√s",
        (0.0, 2.0),
        "Process noise of the position; higher: tracks follow sudden turns, but neighbours are "
        "mixed up sooner",
        formerly=("spread_m",),
        group="Particles and motion",
    )
    process_noise_velocity: float = setting(
        0.8,
        "m/s/√s",
        (0.0, 10.0),
        "Process noise of the velocity; higher: tracks follow sudden turns, but neighbours are "
        "mixed up sooner",
        formerly=("spread_velocity",),
        group="Particles and motion",
        expert=True,
    )
    region_scale: float = setting(
        2.0,
        "",
        (1.0, 4.0),
        "Size of the region in which a particle is weighted, in sizes of the spheroid, with "
        "paper only; higher: a wider background counts",
        group="Bodies",
        expert=True,
    )
    min_separation_m: float = setting(
        0.35,
        "m",
        (0.0, 2.0),
        "Smallest distance between two people (two radii in the paper); higher: fewer duplicate "
        "tracks, but people who walk close together are lost",
        formerly=("apart_m",),
        group="Bodies",
    )
    colour_weight: float = setting(
        6.0,
        "",
        (0.0, 100.0),
        "Weight of colours beside foreground (0, or with paper: they do not count); higher: fewer "
        "id switches where clothes differ",
        group="Association",
    )
    birth_interval_s: float = setting(
        0.2,
        "s",
        (0.02, 10.0),
        "Seconds between two searches for new people; lower: they are found sooner, but tracking "
        "takes more time",
        formerly=("birth_every_s",),
        group="Track management",
        expert=True,
    )
    birth_frames: int = setting(
        2,
        "",
        (1, 50),
        "Searched frames in which a new person must be detected before a track starts; higher: "
        "fewer false tracks, which start later",
        formerly=("birth_looks",),
        group="Track management",
    )
    max_spread_m: float = setting(
        1.5,
        "m",
        (0.1, 10.0),
        "A track whose particles spread wider than this (with paper: 0.9) is no longer reported; "
        "higher: uncertain tracks are kept longer",
        formerly=("largest_spread_m",),
        group="Particles and motion",
        expert=True,
    )
    report_occluded_s: float = setting(
        1.5,
        "s",
        (0.05, 60.0),
        "Seconds an occluded track is reported without a detection, not with paper; higher: "
        "longer guesses behind other people",
        formerly=("lost_hidden_s",),
        group="Track management",
    )
    coast_s: float = setting(
        5.0,
        "s",
        (0.0, 120.0),
        "Seconds an unreported track coasts before it is deleted (with paper: at once). Until "
        "then the person gets the id back when detected near by; higher: more ids come back, and "
        "more go to the wrong person",
        formerly=("remembered_s",),
        group="Track management",
    )
    smooth: bool = setting(
        True,
        "",
        None,
        "After tracking, link the tracks of one person (not with paper), smooth positions and "
        "boxes, and fill gaps. Off: the run holds exactly what was tracked live",
    )
    occluders: str = setting(
        "",
        "",
        None,
        "Outlines of objects that hide people: [[[u, v], ...], ...] in px of the left image",
        expert=True,
    )
    ramp: RampSettings = stage(RampSettings)
    foreground: ForegroundSettings = stage(_sensitive, unused=_UNUSED)
    detections: DetectionSettings = stage(DetectionSettings)

    @property
    def detections_only(self) -> bool:
        """Whether people are seen by another program's boxes alone."""
        return bool(self.detections.file) and self.detections.use == ONLY

    @property
    def tentative_height_m(self) -> float:
        """Body height of a tentative track, m; as published, the fixed height of all tracks."""
        return _PAPER_HEIGHT_M if self.paper else self.initial_height_m

    @property
    def widest_spread_m(self) -> float:
        """How far particles may spread, m."""
        return _PAPER_SPREAD_M if self.paper else self.max_spread_m

    def __post_init__(self) -> None:
        """Check what belongs together, before any work; raises `SettingsError`."""
        occluders_from(self.occluders)
        if not self.min_height_m <= self.initial_height_m <= self.max_height_m:
            raise SettingsError(
                "initial_height_m: {initial_height_m} is not between min_height_m, "
                "{min_height_m}, and max_height_m, {max_height_m}; change one",
                initial_height_m=self.initial_height_m,
                min_height_m=self.min_height_m,
                max_height_m=self.max_height_m,
            )
        if self.ramp.low >= self.ramp.high:
            raise SettingsError(
                "ramp.low: {low} is not below ramp.high, {high}; lower it",
                low=self.ramp.low,
                high=self.ramp.high,
            )

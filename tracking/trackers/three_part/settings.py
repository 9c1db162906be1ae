"""The settings of the trackers that follow rectangles in the picture."""

from __future__ import annotations

from dataclasses import dataclass

from tracking.detections import DetectionSettings
from tracking.errors import SettingsError
from tracking.foreground import ForegroundSettings
from tracking.people import PeopleSettings
from tracking.setting import setting, stage
from tracking.trackers.shared.occluders import occluders_from

_OF_TWO_CAMERAS = (
    *("min_area_m2", "min_point_height_m", "min_height_m", "body_depth_m"),
    "disparity_noise_px",
)
"""Settings of finding people by distances, which one camera does not tell."""


@dataclass(frozen=True, slots=True)
class Aids:
    """What puts parts right besides the colour filters; see the settings of these names.

    Attributes:
        adjust: [ZhaoLee2009] section 4.3.2. fit_silhouettes, pose_constraints, reidentify: ours.
    """

    adjust: bool = False
    fit_silhouettes: bool = False
    pose_constraints: bool = False
    reidentify: bool = False


@dataclass(frozen=True, slots=True)
class WholeBodySettings:
    """What a tracker of one rectangle a person can be told; see the `help` of each field."""

    min_particles: int = setting(
        200,
        "",
        (10, 20000),
        "Fewest particles of a body part, however certain it is; higher: steadier, but takes more"
        " time",
        formerly=("least_particles",),
        group="Particles and motion",
    )
    max_particles: int = setting(
        1000,
        "",
        (10, 20000),
        "Most particles of a body part, however uncertain it is; higher: a lost part is found "
        "sooner, but tracking takes more time",
        formerly=("most_particles",),
        group="Particles and motion",
    )
    particle_growth: float = setting(
        1.2,
        "",
        (0.1, 10.0),
        "Growth of the number of particles with the entropy of their weights; higher: a lost part"
        " is found sooner, but tracking takes more time",
        group="Particles and motion",
        expert=True,
    )
    similarity_sigma: float = setting(
        0.07,
        "",
        (0.01, 1.0),
        "Standard deviation of the colour distance in the likelihood; lower: stricter, but parts "
        "are lost sooner when the light changes",
        group="Association",
        expert=True,
    )
    colour_forgetting_factor: float = setting(
        0.9,
        "",
        (0.0, 1.0),
        "Share of the colour model that remains after each update; higher: the model follows "
        "the light more slowly, and a wrong association harms it less",
        formerly=("model_memory",),
        group="Association",
        expert=True,
    )
    process_noise_position: float = setting(
        0.9,
        "1/√s",
        (0.0, 10.0),
        "Process noise of the position, in sizes of the part; higher: fast movement is followed, "
        "but the part jitters more",
        formerly=("spread_position",),
        group="Particles and motion",
        expert=True,
    )
    process_noise_size: float = setting(
        0.25,
        "1/√s",
        (0.0, 5.0),
        "Process noise of the size, in sizes of the part; higher: changes of size are followed, "
        "but the size jitters more",
        formerly=("spread_size",),
        group="Particles and motion",
        expert=True,
    )
    process_noise_velocity: float = setting(
        2.5,
        "1/s",
        (0.0, 50.0),
        "Process noise of the velocity, in sizes of the part; higher: turns and stops are "
        "followed, but the part jitters more",
        formerly=("spread_velocity",),
        group="Particles and motion",
        expert=True,
    )
    stored_particles: int = setting(
        100,
        "",
        (0, 20000),
        "Particles of each part that the session stores for display; 0: none; higher: larger files",
        formerly=("kept_particles",),
        group="Particles and motion",
    )
    confirm_s: float = setting(
        0.15,
        "s",
        (0.0, 10.0),
        "Seconds of detections after which a tentative track is confirmed; higher: fewer false "
        "tracks, which start later",
        formerly=("birth_s",),
        group="Track management",
    )
    delete_after_s: float = setting(
        1.0,
        "s",
        (0.05, 60.0),
        "Seconds without foreground after which a track is deleted; higher: fewer "
        "fragmentations, longer guesses",
        formerly=("lost_after_s",),
        group="Track management",
    )
    delete_occluded_s: float = setting(
        4.0,
        "s",
        (0.05, 60.0),
        "Seconds without foreground after which a track behind other people or drawn occluders "
        "is deleted; higher: tracks wait longer there",
        formerly=("lost_hidden_s",),
        group="Track management",
    )
    delete_at_edge_s: float = setting(
        0.3,
        "s",
        (0.05, 60.0),
        "Seconds before a track that was lost at the image edge is deleted; lower: people who "
        "leave are deleted sooner",
        formerly=("lost_at_edge_s",),
        group="Track management",
    )
    occluders: str = setting(
        "",
        "",
        None,
        "Outlines of objects that hide people: [[[u, v], ...], ...] in px of the left image",
        expert=True,
    )
    foreground: ForegroundSettings = stage(ForegroundSettings)
    people: PeopleSettings = stage(PeopleSettings, unused=_OF_TWO_CAMERAS)
    detections: DetectionSettings = stage(DetectionSettings)

    def __post_init__(self) -> None:
        """Check what belongs together, before any work; raises `SettingsError`."""
        occluders_from(self.occluders)
        if self.min_particles > self.max_particles:
            raise SettingsError(
                "min_particles: {min_particles} is more than max_particles, {max_particles}; "
                "raise that one or lower this one",
                min_particles=self.min_particles,
                max_particles=self.max_particles,
            )

    @property
    def aids(self) -> Aids:
        """None: one rectangle has no other parts to be put right by."""
        return Aids()


@dataclass(frozen=True, slots=True)
class ThreePartSettings(WholeBodySettings):
    """What a tracker of head, torso and hip-leg can be told besides.

    Which settings make which row of [ZhaoLee2009]'s comparison: `adjust=false` is theirs without
    adjustment, colour filters alone that nothing puts back; `adjust=true` with `fit_silhouettes`,
    `pose_constraints` and `reidentify` false is theirs with it, the detector's failures put back
    by the other parts and the foreground; all true is ours.
    """

    adjust: bool = setting(
        True,
        "",
        None,
        "Put failed parts back where the other parts and the foreground place them. Off: as in "
        "the paper's comparison, and the next three settings have no effect",
        group="Bodies",
    )
    fit_silhouettes: bool = setting(
        True,
        "",
        None,
        "Fit the parts of isolated people to their silhouettes (not in the paper). Off: colours "
        "alone place these parts",
        formerly=("follow_silhouettes",),
        group="Bodies",
    )
    pose_constraints: bool = setting(
        True,
        "",
        None,
        "Detect failed parts by foreground and pose too, and keep occluded parts within the body "
        "(not in the paper). Off: only the part-failure detector does",
        formerly=("body_rules",),
        group="Bodies",
    )
    reidentify: bool = setting(
        True,
        "",
        None,
        "Give lost people their id back, and split tracks that hold two people (not in the "
        "paper). Off: neither is done",
        formerly=("find_again",),
        group="Association",
    )
    smooth: bool = setting(
        True,
        "",
        None,
        "After tracking, with reidentify and a calibrated camera: link the tracks of one person, "
        "smooth positions and boxes, and fill gaps. Off: the run holds exactly what was tracked "
        "live",
    )
    detector: str = setting(
        "",
        "",
        None,
        "File of the part-failure detector; empty: the built-in one with the paper's features; "
        "evidence: the built-in one that sees evidence too",
    )

    @property
    def aids(self) -> Aids:
        """What puts parts right."""
        if not self.adjust:
            return Aids()
        return Aids(True, self.fit_silhouettes, self.pose_constraints, self.reidentify)

"""The settings of the trackers that follow rectangles in the picture."""

from __future__ import annotations

from dataclasses import dataclass, field

from tracking.errors import SettingsError
from tracking.foreground import ForegroundSettings
from tracking.people import PeopleSettings
from tracking.setting import setting
from tracking.trackers.occluders import occluders_from


@dataclass(frozen=True, slots=True)
class Aids:
    """What puts parts right besides the colour filters; see the settings of these names.

    Attributes:
        adjust: [ZhaoLee2009] section 4.3.2. follow_silhouettes, body_rules, find_again: ours.
    """

    adjust: bool = False
    follow_silhouettes: bool = False
    body_rules: bool = False
    find_again: bool = False


@dataclass(frozen=True, slots=True)
class WholeBodySettings:
    """What a tracker of one rectangle a person can be told; see the `help` of each field."""

    least_particles: int = setting(
        200, "", (10, 20000), "fewest particles of a filter, however certain it is"
    )
    most_particles: int = setting(
        1000, "", (10, 20000), "most particles of a filter, however uncertain it is"
    )
    particle_growth: float = setting(
        1.2, "", (0.1, 10.0), "how many more particles follow where all weights are alike"
    )
    similarity_sigma: float = setting(
        0.07, "", (0.01, 1.0), "likelihood's standard deviation of the distance between histograms"
    )
    model_memory: float = setting(0.9, "", (0.0, 1.0), "share of a colour model kept at each frame")
    spread_position: float = setting(
        0.9, "1/√s", (0.0, 10.0), "random spread of the centre after a second, in sizes of the part"
    )
    spread_size: float = setting(0.25, "1/√s", (0.0, 5.0), "the same of the part's size")
    spread_velocity: float = setting(
        2.5, "1/s", (0.0, 50.0), "the same of the velocity, in sizes of the part a second"
    )
    kept_particles: int = setting(
        100, "", (0, 20000), "particles of a part kept in the session, evenly chosen; 0: none"
    )
    birth_s: float = setting(
        0.15, "s", (0.0, 10.0), "time a new region must be seen before it becomes a track"
    )
    lost_after_s: float = setting(
        1.0, "s", (0.05, 60.0), "time without foreground after which a track ends"
    )
    lost_hidden_s: float = setting(
        4.0, "s", (0.05, 60.0), "the same while a person is hidden by others or by what is drawn"
    )
    lost_at_edge_s: float = setting(
        0.3, "s", (0.05, 60.0), "the same for a person at the picture's edge"
    )
    occluders: str = setting(
        "", "", None, "outlines of what hides people: [[[u, v], ...], ...] in px of the left image"
    )
    foreground: ForegroundSettings = field(default_factory=ForegroundSettings)
    people: PeopleSettings = field(default_factory=PeopleSettings)

    def __post_init__(self) -> None:
        """Check what belongs together, before any work; raises `SettingsError`."""
        occluders_from(self.occluders)
        if self.least_particles > self.most_particles:
            raise SettingsError(
                f"least_particles: {self.least_particles} is more than most_particles, "
                f"{self.most_particles}; raise that one or lower this one"
            )

    @property
    def aids(self) -> Aids:
        """None: one rectangle has no other parts to be put right by."""
        return Aids()


@dataclass(frozen=True, slots=True)
class ThreePartSettings(WholeBodySettings):
    """What a tracker of head, torso and hip-leg can be told besides.

    Which settings make which row of [ZhaoLee2009]'s comparison: `adjust=false` is theirs without
    adjustment, colour filters alone that nothing puts back; `adjust=true` with
    `follow_silhouettes`, `body_rules` and `find_again` false is theirs with it, the detector's
    failures put back by the other parts and the foreground; all true is ours.
    """

    adjust: bool = setting(
        True,
        "",
        None,
        "put parts that failed back where the others and the foreground say; "
        "false: the paper's comparison, where nothing does; the next three then count for nothing",
    )
    follow_silhouettes: bool = setting(
        True,
        "",
        None,
        "beyond the paper: draw parts of people seen alone and whole to their outline",
    )
    body_rules: bool = setting(
        True,
        "",
        None,
        "beyond the paper: parts fail by foreground and pose too, and hidden ones stay in the body",
    )
    find_again: bool = setting(
        True, "", None, "beyond the paper: look for people who were lost, part those taken for one"
    )
    detector: str = setting(
        "", "", None, "file of the failure detector; without one the built-in detector judges"
    )

    @property
    def aids(self) -> Aids:
        """What puts parts right."""
        if not self.adjust:
            return Aids()
        return Aids(True, self.follow_silhouettes, self.body_rules, self.find_again)

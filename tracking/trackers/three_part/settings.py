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
        200,
        "",
        (10, 20000),
        "fewest guesses for a body part, however sure it is; more are steadier and take more time",
    )
    most_particles: int = setting(
        1000,
        "",
        (10, 20000),
        "most guesses for a body part, however doubtful it is; more find it again sooner and "
        "take more time",
    )
    particle_growth: float = setting(
        1.2,
        "",
        (0.1, 10.0),
        "how many more guesses are made when all seem equally good; higher: quicker to find a "
        "lost part, slower to run",
    )
    similarity_sigma: float = setting(
        0.07,
        "",
        (0.01, 1.0),
        "how alike colours must be to be the same part; lower: stricter, lost sooner when light "
        "changes",
    )
    model_memory: float = setting(
        0.9,
        "",
        (0.0, 1.0),
        "how much of a part's colours stays at each frame; higher: new light is followed more "
        "slowly, a mix-up spoils them less",
    )
    spread_position: float = setting(
        0.9,
        "1/√s",
        (0.0, 10.0),
        "how far a part may stray in a second, in its own sizes; higher: quick movement is "
        "followed, the part trembles more",
    )
    spread_size: float = setting(0.25, "1/√s", (0.0, 5.0), "the same for its size")
    spread_velocity: float = setting(2.5, "1/s", (0.0, 50.0), "the same for how fast it moves")
    kept_particles: int = setting(
        100,
        "",
        (0, 20000),
        "guesses of each part kept in the session to be looked at; 0: none, smaller files",
    )
    birth_s: float = setting(
        0.15,
        "s",
        (0.0, 10.0),
        "how long a new region must be seen before it becomes a track; higher: fewer false "
        "tracks, which begin later",
    )
    lost_after_s: float = setting(
        1.0,
        "s",
        (0.05, 60.0),
        "how long a person with no foreground is followed before the track ends; higher: fewer "
        "broken tracks, longer guesses",
    )
    lost_hidden_s: float = setting(
        4.0, "s", (0.05, 60.0), "the same while others, or what was drawn as an occluder, hide them"
    )
    lost_at_edge_s: float = setting(
        0.3,
        "s",
        (0.05, 60.0),
        "the same at the picture's edge; lower: whoever leaves is let go sooner",
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
        "put parts that failed back where the other parts and the foreground say; off: the "
        "paper's comparison, where nothing does and the next three count for nothing",
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
        True,
        "",
        None,
        "beyond the paper: look for people who were lost, and part those taken for one",
    )
    detector: str = setting(
        "", "", None, "file of the failure detector; empty: the built-in one judges"
    )

    @property
    def aids(self) -> Aids:
        """What puts parts right."""
        if not self.adjust:
            return Aids()
        return Aids(True, self.follow_silhouettes, self.body_rules, self.find_again)

"""The settings that stereo trackers share."""

from __future__ import annotations

from dataclasses import dataclass, field

from tracking.foreground import ForegroundSettings
from tracking.people import PeopleSettings
from tracking.setting import setting
from tracking.stereo import StereoSettings


@dataclass(frozen=True, slots=True)
class StereoFilterSettings:
    """What every stereo tracker can be told; see the `help` of each field."""

    particles: int = setting(
        500,
        "",
        (10, 20000),
        "guesses kept of where each person is; more follow crowds more surely and take more time",
    )
    start_spread_m: float = setting(
        0.25,
        "m",
        (0.01, 2.0),
        "how far around the first sighting a newcomer may be; higher: surer to be found in the "
        "next frame, but nearer to being mixed up",
    )
    sigma_near_m: float = setting(
        0.12,
        "m",
        (0.01, 2.0),
        "how far off a measured place is, close to the camera; higher: paths are smoother, and "
        "follow turns later",
    )
    sigma_range: float = setting(
        0.001,
        "m/m²",
        (0.0, 0.1),
        "how much more a measured place is off far away: this times the square of the distance; "
        "higher: far people are trusted less",
    )
    hidden_below: float = setting(
        0.3,
        "",
        (0.0, 1.0),
        "a person of whom less than this share should show, from behind others, counts as "
        "hidden: it is then waited for as long as people hidden by others are; higher: sooner",
    )
    unseen_s: float = setting(
        0.2,
        "s",
        (0.01, 60.0),
        "how fast somebody who is not seen is moved to where others could hide them; lower: at "
        "once",
    )
    least_margin: float = setting(
        0.2,
        "",
        (0.0, 5.0),
        "how much better a sighting must suit one person than the next to be theirs, as a "
        "difference in cost; higher: fewer swapped ids, more gaps",
    )
    colour_distance_m: float = setting(
        0.6,
        "m",
        (0.0, 5.0),
        "a person's colours are learnt only while nobody else is closer than this; higher: "
        "cleaner colours, learnt less often",
    )
    confirm_matches: int = setting(
        3,
        "",
        (1, 100),
        "frames a newcomer must be seen in before it becomes a track; higher: fewer false "
        "tracks, which begin later",
    )
    birth_distance_m: float = setting(
        0.5,
        "m",
        (0.0, 5.0),
        "nobody new starts closer than this to somebody followed; higher: fewer double tracks, "
        "people who come in pairs are found later",
    )
    lost_after_s: float = setting(
        1.5,
        "s",
        (0.05, 60.0),
        "how long somebody is followed without being seen, before the track ends; higher: fewer "
        "broken tracks, longer guesses",
    )
    lost_hidden_s: float = setting(
        4.0,
        "s",
        (0.05, 60.0),
        "the same while others are thought to hide them; higher: longer waits behind people",
    )
    lost_at_edge_s: float = setting(
        0.5,
        "s",
        (0.05, 60.0),
        "the same for who was last seen at the picture's edge; lower: whoever leaves is let go "
        "sooner",
    )
    smooth: bool = setting(
        True,
        "",
        None,
        "once all is tracked, smooth paths and boxes from both ends and fill their gaps; off: "
        "exactly what was seen live",
    )
    foreground: ForegroundSettings = field(default_factory=ForegroundSettings)
    stereo: StereoSettings = field(default_factory=StereoSettings)
    people: PeopleSettings = field(default_factory=PeopleSettings)


@dataclass(frozen=True, slots=True)
class StereoTrackerSettings(StereoFilterSettings):
    """What a tracker that sums up the costs of the papers' cues can be told."""

    spread_m: float = setting(
        0.25,
        "m",
        (0.01, 3.0),
        "how far people may stray from their expected place in a second; higher: sudden turns "
        "are followed, neighbours are mixed up sooner",
    )
    spread_growth: float = setting(
        1.0, "1/s", (0.0, 10.0), "how much wider that gets with each second a person is not seen"
    )
    velocity_memory_s: float = setting(
        0.4,
        "s",
        (0.05, 5.0),
        "time over which walking speed is averaged; higher: steadier, later to notice a turn or "
        "a stop",
    )
    gate_m: float = setting(
        0.9,
        "m",
        (0.1, 5.0),
        "farthest from where a person is expected that they are looked for; higher: quick "
        "walkers are kept, ids are swapped sooner",
    )
    gate_growth: float = setting(
        1.0, "1/s", (0.0, 10.0), "how much wider that gets with each second a person is not seen"
    )
    cost_limit: float = setting(
        2.0,
        "",
        (0.1, 10.0),
        "a sighting that suits a person worse than this is not theirs, even if nobody else is "
        "there; higher: fewer gaps, more swapped ids",
    )
    distance_weight: float = setting(
        2.0,
        "1/m",
        (0.0, 20.0),
        "how much a metre off the expected place counts against a sighting; higher: place decides",
    )
    colour_weight: float = setting(
        1.0,
        "",
        (0.0, 10.0),
        "how much other colours count against a sighting; higher: clothes decide",
    )
    hidden_weight: float = setting(
        0.5,
        "",
        (0.0, 10.0),
        "how much it counts against a sighting that the person should be hidden there; higher: "
        "who comes out from behind others is rather somebody else",
    )

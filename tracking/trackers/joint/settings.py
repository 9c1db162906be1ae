"""The settings of the joint stereo tracker."""

from __future__ import annotations

from dataclasses import dataclass

from tracking.setting import setting
from tracking.trackers.stereo_settings import StereoFilterSettings
from tracking.trackers.stereo_walking import WalkingSettings


@dataclass(frozen=True, slots=True)
class JointSettings(WalkingSettings, StereoFilterSettings):
    """Settings of `stereo-joint`.

    Standard terms: `agility` is the process noise intensity, `new_at_edge` and `new_within` are
    birth rates, `overlooked` is what the detection probability in full view lacks of 1.
    """

    confirm_s: float = setting(
        0.1,
        "s",
        (0.0, 10.0),
        "how long a newcomer must be seen before it becomes a track; higher: fewer false tracks, "
        "which begin later",
    )
    lost_after_s: float = setting(
        0.5,
        "s",
        (0.05, 60.0),
        "how long somebody in plain view is shown without being seen; after that they are only "
        "remembered, and get their id back when found",
    )
    least_margin: float = setting(
        0.1,
        "",
        (0.0, 5.0),
        "how much better a sighting must suit one person than the next to be theirs (0.1: a nat, "
        "2.7 times as likely); higher: fewer swapped ids, more gaps",
    )
    agility: float = setting(
        1.0,
        "m²/s³",
        (0.001, 100.0),
        "how suddenly people turn, stop and start; higher: turns are followed at once, paths are "
        "rougher and neighbours mixed up sooner",
    )
    new_at_edge: float = setting(
        1.0,
        "1/m²/s",
        (1e-6, 100.0),
        "how often somebody new comes in at the picture's edge, on each square metre of floor; "
        "higher: whoever appears there is rather a new person than a lost one",
    )
    new_within: float = setting(
        0.05,
        "1/m²/s",
        (1e-6, 100.0),
        "the same in the middle of the picture, through doors or from behind pillars",
    )
    overlooked: float = setting(
        0.05,
        "",
        (0.001, 0.9),
        "how often somebody in full view is not detected; higher: misses are forgiven, people "
        "who are gone are kept longer",
    )
    looks_weight: float = setting(
        0.5,
        "",
        (0.0, 4.0),
        "how much clothes and height decide who is who, beside place; higher: looks decide, "
        "which goes wrong among people dressed alike",
    )
    smooth: bool = setting(
        True,
        "",
        None,
        "once all is tracked, put ids right over the whole recording, smooth paths and boxes and "
        "fill gaps; off: exactly what was seen live",
    )
    direction_weight: float = setting(
        1.0,
        "nat",
        (0.0, 10.0),
        "how much a sudden turn counts against a sighting, in nats (1 nat: 2.7 times less "
        "likely); higher: people are thought to walk straight on",
    )
    remember_s: float = setting(
        8.0,
        "s",
        (0.0, 60.0),
        "how long somebody lost within the picture can get their id back; higher: longer, and "
        "sooner given to somebody else",
    )
    slowing_s: float = setting(
        2.0,
        "s",
        (0.1, 60.0),
        "how long somebody who is not seen is thought to walk on; lower: they are looked for "
        "nearer to where they were lost",
    )

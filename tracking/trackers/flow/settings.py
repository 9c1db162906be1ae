"""The settings of the flow tracker."""

from __future__ import annotations

from dataclasses import dataclass, field

from tracking.foreground import ForegroundSettings
from tracking.setting import setting


@dataclass(frozen=True, slots=True)
class PointSettings:
    """How points are found and followed."""

    most: int = setting(
        300,
        "",
        (20, 2000),
        "most points followed at once; more follow crowds more surely and take more time",
    )
    corner: float = setting(
        0.0001,
        "",
        (0.00001, 0.1),
        "how plain a corner must be to be followed; lower: more points, also on smooth clothes, "
        "and more that slip",
    )
    spacing: float = setting(
        0.2,
        "",
        (0.02, 2.0),
        "how far apart new points are, in body widths there; lower: more points on each person",
    )
    window_px: int = setting(
        11,
        "px",
        (5, 31),
        "side of the patch around a point that is followed, odd; higher: steadier, small far "
        "people blur with what is behind them",
        odd=True,
    )
    levels: int = setting(
        3,
        "",
        (0, 5),
        "how often the picture is halved to follow quick movement; higher: quicker people, more "
        "slips",
    )
    return_px: float = setting(
        1.0,
        "px",
        (0.1, 10.0),
        "a point followed on and back must come this near to where it was; lower: fewer slips, "
        "fewer points",
    )
    change: float = setting(
        20.0,
        "grey levels",
        (1.0, 255.0),
        "a point whose patch changes by more in a frame ends; higher: points live longer, also "
        "where they slipped",
    )
    history_s: float = setting(
        0.6,
        "s",
        (0.2, 5.0),
        "how much of a point's way decides whether it stands still; higher: people who stop are "
        "kept longer",
    )
    still_m_s: float = setting(
        0.15,
        "m/s",
        (0.0, 2.0),
        "slower points are nobody's; higher: the background is left out more surely, slow "
        "walkers are missed",
    )
    foreground_only: bool = setting(
        True,
        "",
        None,
        "look for points only where something differs from the background; off: also elsewhere, "
        "which takes more time",
    )


@dataclass(frozen=True, slots=True)
class ClusterSettings:
    """How tracklets are gathered by mean shift."""

    width_m: float = setting(
        0.4,
        "m",
        (0.1, 2.0),
        "how broad the space is whose points are one person; higher: people side by side become "
        "one",
    )
    height_m: float = setting(1.65, "m", (0.2, 3.0), "how high that space is")
    centre_m: float = setting(0.8, "m", (0.1, 2.5), "how high its middle is over the floor")
    reach: float = setting(
        1.0,
        "",
        (0.1, 5.0),
        "how far beyond that space points still count, in its own sizes; higher: looser groups "
        "become one person",
    )
    fewest: int = setting(
        4,
        "",
        (1, 100),
        "a group of fewer points is nobody; higher: fewer false people, far or plain-clothed "
        "ones are missed",
    )
    join: float = setting(
        0.5,
        "",
        (0.0, 1.0),
        "groups closer than this are one person, in halves of that space; higher: fewer people "
        "parted into two",
    )
    warm: bool = setting(
        True,
        "",
        None,
        "begin where the groups of the frame before were: quicker; off: from nothing in each frame",
    )
    occlusion: bool = setting(
        True,
        "",
        None,
        "make that space smaller where the lower part of a body shows no points, as behind others",
    )

    @property
    def bodies(self) -> float:
        """How many bodies wide and high a kernel is.

        It reaches `reach` bodies from its middle to each side ([Yoneji2013] eq. 4).
        """
        return 2.0 * self.reach


@dataclass(frozen=True, slots=True)
class FlowSettings:
    """What the flow tracker can be told; see the `help` of each field."""

    hold: bool = setting(
        True,
        "",
        None,
        "a point stays with its person while it moves as the body does; off: people are found "
        "anew in each frame, as in the paper",
    )
    birth_s: float = setting(
        0.2,
        "s",
        (0.0, 10.0),
        "how long a group of points must have moved before it becomes a track; higher: fewer "
        "false tracks, which begin later",
    )
    walked_m: float = setting(
        0.3,
        "m",
        (0.0, 10.0),
        "a track is shown only once it has gone so far from where it began; higher: fewer false "
        "tracks, short walks are missed",
    )
    unproven_s: float = setting(
        1.5,
        "s",
        (0.1, 60.0),
        "how long it has for that, or it was nobody; higher: slow walkers are kept, false ones "
        "live longer",
    )
    empty_s: float = setting(
        0.6,
        "s",
        (0.05, 60.0),
        "how long nothing may be seen where somebody should be in sight before the track ends, "
        "longer behind pillars; counts with hold only",
    )
    lost_after_s: float = setting(
        2.5,
        "s",
        (0.05, 60.0),
        "how long somebody out of sight is followed before the track ends; higher: fewer broken "
        "tracks, longer guesses",
    )
    lost_at_edge_s: float = setting(
        0.4,
        "s",
        (0.05, 60.0),
        "the same at the picture's edge or outside it; lower: whoever leaves is let go sooner",
    )
    closest_m: float = setting(
        0.2,
        "m",
        (0.0, 2.0),
        "people who walk nearer together than this are one; higher: fewer double tracks, couples "
        "become one; counts with hold only",
    )
    silhouettes: bool = setting(
        True,
        "",
        None,
        "draw people to where their bodies fill the foreground; counts with hold only",
    )
    led_s: float = setting(
        2.0,
        "s",
        (0.0, 10.0),
        "how long people are thought to have walked on before they were found and after they "
        "were lost, in a finished run; counts with hold only",
    )
    smooth: bool = setting(
        True,
        "",
        None,
        "once all is tracked, look the run over from both ends: smoother paths and boxes; off: "
        "exactly what was seen live",
    )
    points: PointSettings = field(default_factory=PointSettings)
    clusters: ClusterSettings = field(default_factory=ClusterSettings)
    foreground: ForegroundSettings = field(default_factory=ForegroundSettings)

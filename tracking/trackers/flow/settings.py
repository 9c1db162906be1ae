"""The settings of the flow tracker."""

from __future__ import annotations

from dataclasses import dataclass, field

from tracking.foreground import ForegroundSettings
from tracking.setting import setting


@dataclass(frozen=True, slots=True)
class PointSettings:
    """How points are found and followed."""

    most: int = setting(300, "", (20, 2000), "points followed at once, at most")
    corner: float = setting(
        0.0001, "", (0.00001, 0.1), "weakest corner followed: least eigenvalue of its gradients"
    )
    spacing: float = setting(
        0.2, "", (0.02, 2.0), "distance between new points, in widths of the kernel there"
    )
    window_px: int = setting(11, "px", (5, 31), "side of the patch that is followed", odd=True)
    levels: int = setting(3, "", (0, 5), "halvings of the picture in which a point is looked for")
    return_px: float = setting(
        1.0, "px", (0.1, 10.0), "followed back, a point must come as near to where it was"
    )
    change: float = setting(
        20.0, "grey levels", (1.0, 255.0), "a point whose patch changes by more in a frame ends"
    )
    history_s: float = setting(
        0.6, "s", (0.2, 5.0), "how long a way decides whether a point stands still"
    )
    still_m_s: float = setting(
        0.15, "m/s", (0.0, 2.0), "slower points are nobody's; as fast as at half a body's height"
    )
    foreground_only: bool = setting(
        True, "", None, "look for points only where something differs from the background"
    )


@dataclass(frozen=True, slots=True)
class ClusterSettings:
    """How tracklets are gathered by mean shift."""

    width_m: float = setting(0.4, "m", (0.1, 2.0), "width of the kernel's box")
    height_m: float = setting(1.65, "m", (0.2, 3.0), "height of the kernel's box")
    centre_m: float = setting(0.8, "m", (0.1, 2.5), "height of the box's middle over the floor")
    reach: float = setting(
        1.0, "", (0.1, 5.0), "how far from its middle the kernel reaches, in widths and heights"
    )
    fewest: int = setting(4, "", (1, 100), "clusters of fewer tracklets are dropped")
    join: float = setting(
        0.5, "", (0.0, 1.0), "modes closer than this join, in halves of the kernel's sides"
    )
    warm: bool = setting(
        True, "", None, "begin with the modes of the frame before, one step a frame"
    )
    occlusion: bool = setting(
        True, "", None, "shrink the kernel where the lower part of a body has no tracklets"
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
        "a tracklet stays with its person while it moves as the body does; off: clusters of each "
        "frame, as in the paper",
    )
    birth_s: float = setting(
        0.2, "s", (0.0, 10.0), "time a cluster must have moved before it becomes a track"
    )
    walked_m: float = setting(
        0.3, "m", (0.0, 10.0), "a track is told only once it has gone so far from where it began"
    )
    unproven_s: float = setting(
        1.5, "s", (0.1, 60.0), "time in which it must do so, or it was nobody"
    )
    empty_s: float = setting(
        0.6,
        "s",
        (0.05, 60.0),
        "time with nothing seen where somebody should be in sight, after which a track ends; "
        "longer where pillars hide people; counts with hold only",
    )
    lost_after_s: float = setting(
        2.5, "s", (0.05, 60.0), "time out of sight after which a track ends"
    )
    lost_at_edge_s: float = setting(
        0.4, "s", (0.05, 60.0), "the same for a person at the picture's edge or outside it"
    )
    closest_m: float = setting(
        0.2,
        "m",
        (0.0, 2.0),
        "people who walk nearer together than this are one; counts with hold only",
    )
    silhouettes: bool = setting(
        True, "", None, "with hold: draw people to where their bodies fill the foreground"
    )
    led_s: float = setting(
        2.0,
        "s",
        (0.0, 10.0),
        "time people are thought to have walked on, in a finished run, before they were found and "
        "after they were lost; counts with hold only",
    )
    smooth: bool = setting(
        True, "", None, "look a finished run over from both ends: smoother paths and boxes"
    )
    points: PointSettings = field(default_factory=PointSettings)
    clusters: ClusterSettings = field(default_factory=ClusterSettings)
    foreground: ForegroundSettings = field(default_factory=ForegroundSettings)

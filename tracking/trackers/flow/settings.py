"""The settings of the flow tracker."""

from __future__ import annotations

from dataclasses import dataclass

from tracking.detections import DetectionSettings
from tracking.foreground import ForegroundSettings
from tracking.setting import setting, stage

_UNUSED = (
    *("shadow_threshold", "floor_shadow_threshold", "shadow_texture", "shadow_hue"),
    *("shadow_constant", "shadow_min_brightness"),
)
"""`ShadowWeights` learns beside people what a shadow is."""


@dataclass(frozen=True, slots=True)
class PointSettings:
    """How points are found and followed."""

    max_points: int = setting(
        300,
        "",
        (20, 2000),
        "Largest number of tracked points; higher: tracking in crowds is more reliable but takes "
        "more time",
        formerly=("most",),
    )
    corner_quality: float = setting(
        0.0001,
        "",
        (0.00001, 0.1),
        "Smallest corner quality of a tracked point; lower: more points, also on plain clothes, "
        "and more that drift",
        formerly=("corner",),
        expert=True,
    )
    spacing: float = setting(
        0.2,
        "",
        (0.02, 2.0),
        "Distance between new points, in body widths at that place; lower: more points on each "
        "person",
        expert=True,
    )
    window_px: int = setting(
        11,
        "px",
        (5, 31),
        "Side of the square patch that is tracked around a point, odd; higher: steadier, but "
        "small far people blur with the background",
        odd=True,
        expert=True,
    )
    pyramid_levels: int = setting(
        3,
        "",
        (0, 5),
        "Levels of the image pyramid; higher: faster people are tracked, and more points drift",
        formerly=("levels",),
        expert=True,
    )
    forward_backward_px: float = setting(
        1.0,
        "px",
        (0.1, 10.0),
        "Largest forward-backward error of a point that is tracked to the next frame and back; "
        "lower: fewer points drift, and fewer remain",
        formerly=("return_px",),
        expert=True,
    )
    max_residual: float = setting(
        20.0,
        "grey levels",
        (1.0, 255.0),
        "A point whose patch changes by more from frame to frame is deleted; higher: points live "
        "longer, also where they drift",
        formerly=("change",),
        expert=True,
    )
    history_s: float = setting(
        0.6,
        "s",
        (0.2, 5.0),
        "Time over which the speed of a point is measured; higher: people who stop are kept longer",
        expert=True,
    )
    min_speed_m_s: float = setting(
        0.15,
        "m/s",
        (0.0, 2.0),
        "Smallest speed of the points of a person; higher: the background is ignored more "
        "reliably, but slow walkers are missed",
        formerly=("still_m_s",),
    )
    foreground_only: bool = setting(
        True,
        "",
        None,
        "Search for points only in the foreground. Off: the whole image is searched, which takes "
        "more time",
        expert=True,
    )


@dataclass(frozen=True, slots=True)
class ClusterSettings:
    """How tracklets are gathered by mean shift."""

    width_m: float = setting(
        0.4,
        "m",
        (0.1, 2.0),
        "Width of the volume whose points belong to one person; higher: people side by side "
        "become one",
    )
    height_m: float = setting(
        1.65,
        "m",
        (0.2, 3.0),
        "Height of the volume of a person; higher: more points belong to one person",
        expert=True,
    )
    centre_m: float = setting(
        0.8,
        "m",
        (0.1, 2.5),
        "Height of the volume's centre above the floor; higher: feet count less",
        expert=True,
    )
    bandwidth: float = setting(
        1.0,
        "",
        (0.1, 5.0),
        "Bandwidth of mean shift: size of the kernel in multiples of the volume of a person; "
        "higher: looser groups of points become one person",
        formerly=("reach",),
        expert=True,
    )
    min_points: int = setting(
        4,
        "",
        (1, 100),
        "Fewest points of a person; higher: fewer false people, but people far away or in plain "
        "clothes are missed",
        formerly=("fewest",),
    )
    merge_distance: float = setting(
        0.5,
        "",
        (0.0, 1.0),
        "Clusters closer than this are one person, in halves of the volume; higher: fewer people "
        "are split into two",
        formerly=("join",),
        expert=True,
    )
    warm_start: bool = setting(
        True,
        "",
        None,
        "Start mean shift from the clusters of the previous frame, which is faster. Off: each "
        "frame is clustered from scratch",
        formerly=("warm",),
        expert=True,
    )
    occlusion: bool = setting(
        True,
        "",
        None,
        "Shrink the volume where the lower part of a body has no points, as behind other people. "
        "Off: it always has its full size",
        expert=True,
    )

    @property
    def bodies(self) -> float:
        """How many bodies wide and high a kernel is.

        It reaches `bandwidth` bodies from its middle to each side ([Yoneji2013] eq. 4).
        """
        return 2.0 * self.bandwidth


@dataclass(frozen=True, slots=True)
class FlowSettings:
    """What the flow tracker can be told; see the `help` of each field."""

    persistent_points: bool = setting(
        True,
        "",
        None,
        "A person keeps its points while they move with the body. Off: people are found again "
        "from all points in each frame, as in the paper",
        formerly=("hold",),
        group="Track management",
    )
    confirm_s: float = setting(
        0.2,
        "s",
        (0.0, 10.0),
        "Seconds a group of points must move before it becomes a track; higher: fewer false "
        "tracks, which start later",
        formerly=("birth_s",),
        group="Track management",
    )
    confirm_distance_m: float = setting(
        0.3,
        "m",
        (0.0, 10.0),
        "Distance a track must walk before it is reported; higher: fewer false tracks, but short "
        "walks are missed",
        formerly=("walked_m",),
        group="Track management",
    )
    confirm_timeout_s: float = setting(
        1.5,
        "s",
        (0.1, 60.0),
        "Seconds after which a track that has not walked the confirm distance is deleted; higher:"
        " slow walkers are kept, and false tracks live longer",
        formerly=("unproven_s",),
        group="Track management",
        expert=True,
    )
    delete_in_view_s: float = setting(
        0.6,
        "s",
        (0.05, 60.0),
        "Seconds without points or foreground after which a track in plain view is deleted "
        "(longer behind pillars), with persistent_points only; higher: longer guesses",
        formerly=("empty_s",),
        group="Track management",
    )
    delete_after_s: float = setting(
        2.5,
        "s",
        (0.05, 60.0),
        "Seconds without a detection after which a track is deleted; higher: fewer "
        "fragmentations, longer guesses",
        formerly=("lost_after_s",),
        group="Track management",
    )
    delete_at_edge_s: float = setting(
        0.4,
        "s",
        (0.05, 60.0),
        "Seconds before a track that was lost at the image edge or outside the image is deleted; "
        "lower: people who leave are deleted sooner",
        formerly=("lost_at_edge_s",),
        group="Track management",
    )
    merge_distance_m: float = setting(
        0.2,
        "m",
        (0.0, 2.0),
        "Tracks that walk closer together than this become one, with persistent_points only; "
        "higher: fewer duplicate tracks, but couples become one",
        formerly=("closest_m",),
        group="Track management",
    )
    fit_silhouettes: bool = setting(
        True,
        "",
        None,
        "Move people to where their bodies fill the foreground, with persistent_points only. "
        "Off: points alone place people",
        formerly=("silhouettes",),
        group="Bodies",
    )
    extrapolate_s: float = setting(
        2.0,
        "s",
        (0.0, 10.0),
        "Seconds by which finished tracks are extrapolated before their first and after their "
        "last detection, with persistent_points only; higher: longer tracks with more guesses",
        formerly=("led_s",),
        group="Track management",
    )
    smooth: bool = setting(
        True,
        "",
        None,
        "After tracking, smooth positions and boxes forward and backward. Off: the run holds "
        "exactly what was tracked live",
    )
    points: PointSettings = stage(PointSettings)
    clusters: ClusterSettings = stage(ClusterSettings)
    foreground: ForegroundSettings = stage(ForegroundSettings, unused=_UNUSED)
    detections: DetectionSettings = stage(DetectionSettings)

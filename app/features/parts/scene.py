"""Body parts as the views show them: rectangles, particles, and how they went over time."""

from __future__ import annotations

from dataclasses import dataclass

from app.core.scenes.part_curve import PartCurve


@dataclass(frozen=True, slots=True, eq=False)
class CurvesScene:
    """The plots of one person's parts.

    Attributes:
        title: e.g. "Parts of 4 red coat".
        curves: of head, torso and hip-leg; none where there is nothing to show.
        names: of the parts. chosen: the one looked at.
        frame: at the playhead. frame_count, fps: of the recording.
        said: a line a part, its figures at the playhead.
        message: what to do, where there are no curves.
    """

    title: str
    curves: tuple[PartCurve, ...] = ()
    names: tuple[str, ...] = ()
    chosen: int = 0
    frame: int = 0
    frame_count: int = 1
    fps: float = 1.0
    said: tuple[str, ...] = ()
    message: str = ""


@dataclass(frozen=True, slots=True)
class Failure:
    """Where a part begins to fail.

    Attributes:
        place: its number among all of the run. by_rule: a rule of the tracker says so, not the
            detector.
    """

    frame: int
    track: int
    part: int
    place: int
    by_rule: bool = False

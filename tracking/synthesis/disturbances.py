"""Disturbances of a rendered recording: a late begin, changing light, a knocked camera."""

from __future__ import annotations

from dataclasses import dataclass, replace

import numpy as np

from tracking.errors import SettingsError
from tracking.synthesis.specs import SceneSpec

_LATEST_S = 3600.0
_DIMMED = 0.7  # share of the light that is left
_DIMMING_S = 1.0
_KNOCKED_DEG, _TWISTED_DEG = 1.5, 1.0


@dataclass(frozen=True, slots=True)
class Disturbances:
    """What is out of the ordinary; nothing by default.

    Attributes:
        begin_s: this much of the scene's start is left out, so that it begins with people in it.
        dimmed_s: when a part of the light goes out, in seconds of the recording.
        bumped_s: when the camera is knocked out of its place for good.

    Raises:
        SettingsError: a time is negative or far beyond any recording.
    """

    begin_s: float = 0.0
    dimmed_s: float | None = None
    bumped_s: float | None = None

    def __post_init__(self) -> None:
        for name in ("begin_s", "dimmed_s", "bumped_s"):
            value = getattr(self, name)
            if value is not None and not 0 <= value <= _LATEST_S:
                raise SettingsError(
                    "{setting} is {value:g}; give 0 to {latest_s:g} seconds",
                    setting=name.removesuffix("_s"),
                    value=value,
                    latest_s=_LATEST_S,
                )

    def brightness(self, second: float) -> float:
        """Share of the light that is there, 0..1."""
        if self.dimmed_s is None:
            return 1.0
        gone = float(np.clip((second - self.dimmed_s) / _DIMMING_S, 0.0, 1.0))
        return 1.0 - (1.0 - _DIMMED) * gone

    def is_bumped(self, second: float) -> bool:
        """Whether the camera has been knocked."""
        return self.bumped_s is not None and second >= self.bumped_s


def knock_camera(spec: SceneSpec) -> SceneSpec:
    """The scene as its camera sees it after the knock: the axis higher, the camera twisted."""
    return replace(
        spec, tilt_deg=spec.tilt_deg - _KNOCKED_DEG, roll_deg=spec.roll_deg + _TWISTED_DEG
    )


NO_DISTURBANCES = Disturbances()

"""The pictures that a page shows beside a finding."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

from tracking.scoring.report.findings import Finding
from tracking.scoring.report.ground_plan import ground_plan
from tracking.scoring.report.switch_pictures import (
    MOST_SWITCHES,
    SwitchPictures,
    place_picture,
    switch_pictures,
)
from tracking.translation import msg

_MOST_PICTURED = 240
"""Switches of all findings together: a page of more is too large to be sent to anybody."""


@dataclass(frozen=True, slots=True)
class Shown:
    """Pictures of a finding.

    Attributes:
        switches: cut out of the recording. place: a frame of it, as JPEG, for a map in pixels.
        why_none: why there are no pictures of switches.
    """

    switches: tuple[SwitchPictures, ...] = ()
    place: bytes | None = None
    why_none: str = msg("the recording was not found")


def shown_of(
    finding: Finding, among: int, tell: Callable[[int, int], None], why_none: str
) -> Shown:
    """The pictures of one of so many findings of a report.

    Args:
        among: how many findings the report has; they share the room that a page has.
        tell: told how many switches are done of how many; may raise to cancel.
        why_none: why there are no pictures of switches, where there are none.
    """
    most = max(1, min(MOST_SWITCHES, _MOST_PICTURED // among))
    switches = switch_pictures(finding, tell, most)
    plan = ground_plan(finding.subject)
    in_picture = plan is not None and not plan.on_floor
    return Shown(switches, place_picture(finding.subject) if in_picture else None, why_none)

"""Looks through tracks for places where they are likely wrong."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np

from tracking.geometry import View
from tracking.review.costs import costs
from tracking.review.evidence import gathered
from tracking.review.hazard.expected import Hazards
from tracking.review.joining import Reasons, joined_places, stacked
from tracking.review.likelihood import LEAST_WEIGHT, WEIGHTS, likelihoods
from tracking.review.material import Material
from tracking.review.queue import ranked
from tracking.review.reasons import REASONS
from tracking.review.speaking import Speaker
from tracking.review.stretches import stretches
from tracking.review.suspicion import Suspicion
from tracking.review.wording import fix
from tracking.tracks import Labels, Run, TrackTable

Progress = Callable[[int, int], None]
"""Told steps done and steps in all; may raise to cancel."""

JOINED_S = 0.75
"""Reasons about the same people so near in time are one suspicion."""
_LEAST = 0.01
"""Less likely suspicions are not mentioned."""
MOST = 10_000
"""Of more than these, more than anybody ever looks through, those worth most are kept."""


def find_suspicions(
    table: TrackTable,
    run: Run | None,
    fps: float,
    labels: Labels | None = None,
    view: View | None = None,
    progress: Progress | None = None,
    *,
    size: tuple[int, int] | None = None,
) -> tuple[Suspicion, ...]:
    """Places where the tracks are likely wrong, those that are worth most first.

    Verdicts and reviewed ranges are not looked at here: see `open_suspicions`.

    Args:
        table: the corrected tracks; not changed, so a snapshot can be handed to another thread.
        run: the one they began as, for what its tracker noticed; None, or one without signals:
            what needs them is not looked for.
        fps: frames a second.
        labels: whose occluders explain why tracks end; None for none.
        view: the camera, whose picture's borders do so too; None where it is not known.
        progress: told how far it is; what it raises ends the search.
        size: of the picture in px, where there is no view.
    """
    tell = progress or _untold
    total = len(REASONS) + 3
    tell(0, total)
    if not len(table):
        return ()
    evidence = gathered(table, run, fps)
    tell(1, total)
    picture = view.camera.size if view else size
    material = Material.of(evidence, picture, labels.occluders if labels else ())
    found = []
    for number, look in enumerate(REASONS.values()):
        tell(2 + number, total)
        found.append(look(material))
    tell(total - 1, total)
    reasons = stacked(found, [max(WEIGHTS[each.kind], LEAST_WEIGHT) for each in found])
    suspicions = _suspicions(material, reasons)
    tell(total, total)
    return ranked(suspicions, "worth")


def _untold(done: int, total: int) -> None:
    """Nobody asked."""


def _suspicions(material: Material, reasons: Reasons) -> list[Suspicion]:
    evidence = material.evidence
    places = joined_places(reasons, evidence.frames_of(JOINED_S))
    leader = places.leader
    watched = stretches(reasons, places, Hazards.of(material))
    likely = likelihoods(reasons.kinds, places.strength, watched.expected)
    cost = costs(material, reasons.first[leader], reasons.second[leader], watched.frame)
    told = np.flatnonzero(likely >= _LEAST)
    told = told[np.argsort(-(likely * cost)[told], kind="stable")[:MOST]]
    columns = (leader, watched.frame, watched.start, watched.end, likely, cost)
    figures = (column[told].tolist() for column in columns)
    speaker = Speaker.of(reasons, places, evidence.fps)
    return [
        _suspicion(speaker, place, *numbers)
        for place, *numbers in zip(told.tolist(), *figures, strict=True)
    ]


def _suspicion(
    speaker: Speaker,
    place: int,
    leader: int,
    frame: int,
    start: int,
    end: int,
    likelihood: float,
    cost: float,
) -> Suspicion:
    kind, first, second, _, _ = speaker.reasons[leader]
    text, *others = speaker.said(place, leader)
    return Suspicion(
        kind=kind,
        tracks=(min(first, second), max(first, second)) if second else (first,),
        frame=frame,
        start=start,
        end=end,
        likelihood=likelihood,
        cost=cost,
        text=text,
        fix=fix(kind, second),
        others=tuple(others),
    )

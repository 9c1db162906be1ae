"""Part rectangles, particles and curves of the open document as scenes."""

from __future__ import annotations

import math
from dataclasses import replace

import numpy as np

from app.core.i18n import joined, tr
from app.core.keymap import in_brackets
from app.core.scenes.part_curve import THRESHOLD, PartCurve
from app.core.scenes.part_names import part_name
from app.core.scenes.pictured_parts import PartBox, PicturedParts
from app.core.tracks.frame_state import FrameState
from app.core.tracks.particle_weights import relative_weights
from app.features.parts.scene import CurvesScene
from tracking.trackers import body_part_tracker
from tracking.tracks import PART_NAMES, Box, Columns


def part_boxes(state: FrameState, part: int) -> tuple[PartBox, ...]:
    """The parts' rectangles in a frame, those of the selected person last."""
    rows = state.tracks.parts(state.frame)
    boxes = [_box(rows, row, state, part) for row in range(len(rows["track"]))]
    return tuple(sorted((box for box in boxes if box), key=lambda one: (one.selected, one.chosen)))


def with_particles(parts: PicturedParts, state: FrameState, part: int) -> PicturedParts:
    """The rectangles with the particles of one part of the selected person."""
    cloud = state.tracks.part_particles(state.frame)
    mine = (cloud["track"] == state.selected) & (cloud["part"] == part)
    own = {name: column[mine] for name, column in cloud.items()}
    places = np.column_stack((own["u"], own["v"])).astype(np.float64)
    colour = state.colours.of(state.selected)
    return replace(parts, particles=places, weights=relative_weights(own), colour=colour)


def _box(rows: Columns, row: int, state: FrameState, part: int) -> PartBox | None:
    centre_u, centre_v, width, height, score = (
        float(rows[name][row]) for name in ("cx", "cy", "width", "height", "score")
    )
    if not math.isfinite(centre_u + centre_v + width + height):
        return None
    track, own = int(rows["track"][row]), int(rows["part"][row])
    box: Box = (centre_u - width / 2, centre_v - height / 2, width, height)
    failed, occluded = bool(rows["failed"][row]), bool(rows["occluded"][row])
    selected = track == state.selected
    text = verdict_text(own, failed, occluded, score)
    colour = state.colours.of(track)
    chosen = selected and own == part
    scored = not occluded and math.isfinite(score) and not by_rule(failed, score)
    return PartBox(track, own, box, colour, failed, occluded, text, selected, chosen, scored)


def verdict_text(part: int, failed: bool, occluded: bool, score: float) -> str:
    """What is said of a part, e.g. "torso: off, +1.32"; see `by_rule`."""
    name = part_name(part)
    if occluded:
        return tr("{part}: hidden", part=name)
    if by_rule(failed, score):
        return tr("{part}: off, by rule", part=name)
    if not math.isfinite(score):
        return tr("{part}: not judged", part=name)
    said = tr("{part}: off, {score:+z.2f}") if failed else tr("{part}: on, {score:+z.2f}")
    return said.format(part=name, score=score)


def by_rule(failed: bool, score: float) -> bool:
    """Whether a part was called failed by a rule of the tracker, not by the detector's score."""
    return failed and not score > THRESHOLD


def curves_of(rows: Columns) -> tuple[PartCurve, ...]:
    """A curve a part, of one track's `PART_COLUMNS`; none where there are no rows."""
    if not len(rows["frame"]):
        return ()
    return tuple(_curve(rows, part) for part in range(len(PART_NAMES)))


def _curve(rows: Columns, part: int) -> PartCurve:
    mine = np.flatnonzero(rows["part"] == part)
    return PartCurve(
        frames=rows["frame"][mine].astype(np.int64),
        entropy=rows["entropy"][mine].astype(np.float64),
        particles=rows["particles"][mine].astype(np.float64),
        score=rows["score"][mine].astype(np.float64),
        failed=rows["failed"][mine].astype(np.bool_),
        occluded=rows["occluded"][mine].astype(np.bool_),
    )


def curves_scene(
    state: FrameState, curves: tuple[PartCurve, ...], part: int, frame_count: int, fps: float
) -> CurvesScene:
    """The plots of the selected person at a frame, or what to do where there are none."""
    chosen = state.selected
    if not chosen or not curves:
        return CurvesScene(tr("Parts over time"), message=_nothing(state, bool(curves)))
    names = tuple(part_name(one) for one in range(len(PART_NAMES)))
    said = tuple(_said(name, curve, state.frame) for name, curve in zip(names, curves, strict=True))
    title = tr("Parts of {who} over time", who=state.label(chosen))
    return CurvesScene(title, curves, names, part, state.frame, frame_count, fps, said)


def _nothing(state: FrameState, some: bool) -> str:
    if state.selected or some:
        return tr(
            "No parts were tracked of this person: track with {tracker}{key} to see head, "
            "torso and hip-leg here.",
            tracker=body_part_tracker(),
            key=in_brackets("tracks.track"),
        )
    return tr("Click a person to see their parts over time.")


def _said(name: str, curve: PartCurve, frame: int) -> str:
    """The figures of a part at a frame in words."""
    at = int(np.searchsorted(curve.frames, frame))
    if at >= len(curve.frames) or curve.frames[at] != frame:
        return tr("{part}: not tracked here", part=name)
    figures, score, failed = [], float(curve.score[at]), bool(curve.failed[at])
    if math.isfinite(score):
        figures.append(tr("score {score:+z.2f} in the run", score=score))
    if by_rule(failed, score):
        figures.append(tr("off by rule"))
    if math.isfinite(curve.entropy[at]):
        figures.append(tr("entropy {entropy:.2f}", entropy=curve.entropy[at]))
    figures.append(tr("{n:.0f} particles", n=curve.particles[at]))
    return tr("{part}: {figures}", part=name, figures=joined(", ", figures))

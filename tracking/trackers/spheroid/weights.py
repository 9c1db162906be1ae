"""Weights of hypotheses: what they explain, their colours, and who stands there already."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from tracking.geometry import Ellipses, FlatView, standing_ellipses
from tracking.trackers.spheroid.box_cues import box_log_weights, flat_boxes
from tracking.trackers.spheroid.feet import feet_of, feet_parts, feet_scores
from tracking.trackers.spheroid.filter_steps import weigh_hypotheses
from tracking.trackers.spheroid.hypotheses import Floats, SpheroidPeople
from tracking.trackers.spheroid.hypothesis_scores import LINES, JudgedFrame, judge, windows_of
from tracking.trackers.spheroid.settings import SpheroidSettings
from tracking.trackers.spheroid.sums import Window, sums_inside
from tracking.trackers.spheroid.view_model import headless, near_side_hidden, seen_steeply

Flags = NDArray[np.bool_]

_BALANCE, _CUT_BALANCE = 0.45, 0.3
"""B from which on a pixel speaks for a hypothesis, below against; and of people whose heads are out
of the picture: legs fill but half of a spheroid's width."""
LEGS_BALANCE, LEGS_WEIGHT = 0.22, 0.57
"""The same of the lower half of people seen from the side, and how much a pixel counts there beside
one of the upper half. Bodies fill 0.9 of their upper half, legs half of the lower one, and 0.05 of
what is empty is foreground: the logarithms of the likelihood ratios of a pixel, log(p / q) where it
is foreground and log((1 - p) / (1 - q)) where not, follow from that, as does `_BALANCE`."""
_STEEP_BALANCE, _STEEP_CUT_BALANCE = 0.35, 0.27
"""The same seen steeply: feet and head, the ends of a body, are narrower there than a spheroid's,
and what these leave empty would push it outwards and make it short."""
_HIDDEN_CUT_BALANCE = 0.1
"""The same seen steeply with the near side hidden, too: what a spheroid leaves empty at its sides
would push it outwards, and nothing that is seen holds it."""
_HEIGHT_SD_M, _STEEP_HEIGHT_SD_M = 0.3, 0.15
"""Of the body heights of people: how unlikely it is that one is far from the usual. It counts in
every frame, so from the side, where head and feet tell the height, little; seen steeply they do
not."""
_LEAN_S = 0.05
"""Who walks leans ahead: seconds of walking by which the body's axis is before where he stands."""
SHARPNESS = 40.0
"""Logarithm of the weight of a hypothesis that explains everything, over one of nothing."""
FEET = 4.0
"""The same of one whose legs end where legs are seen to end, over one without legs."""
_BOXES_TELL = 0.08
"""What pixels tell where people are seen by boxes alone, beside those of the foreground: a box is
off by some 7 % of its height, and all its pixels with it."""


def silhouettes(
    people: SpheroidPeople, flat: FlatView, settings: SpheroidSettings, scale: float = 1.0
) -> Ellipses:
    """(people) the spheroids at their estimates, px of the flat picture; enlarged by a scale."""
    axes = axes_of(people, settings)
    return standing_ellipses(flat.projection, axes, people.height, settings.radius_m, scale)


def axes_of(people: SpheroidPeople, settings: SpheroidSettings) -> Floats:
    """(people, 2) m where the axes of the bodies are, that of those who walk ahead of the feet."""
    return people.xy + _lean_s(settings) * people.mean[:, 2:]


def hypotheses_of(people: SpheroidPeople, settings: SpheroidSettings) -> tuple[Floats, Floats]:
    """Axes (people, N, 2) and body heights (people, N) of all hypotheses, m."""
    ahead_m = axes_of(people, settings) - people.xy
    return people.state[..., :2] + ahead_m[:, None], people.tall.astype(np.float64)


def _lean_s(settings: SpheroidSettings) -> float:
    return 0.0 if settings.paper else _LEAN_S


def judge_and_weigh(
    people: SpheroidPeople,
    judged: JudgedFrame,
    flat: FlatView,
    settings: SpheroidSettings,
    alike: Floats | None = None,
    boxes: Floats | None = None,
) -> tuple[SpheroidPeople, list[Window]]:
    """The people with their hypotheses weighed, and the windows in which that was done.

    Args:
        judged: with the silhouettes of everybody's expected places as cover.
        alike: (people, N) logarithms of weights by colour; None: colours say nothing.
        boxes: (n, 4) of another program's detector, px as recorded; None: there are none.
    """
    axes, tall = hypotheses_of(people, settings)
    short, steep = headless(people, flat), seen_steeply(people, flat)
    if not settings.paper:
        # Short and far out looks like tall and near as long as no head is seen.
        tall = np.where((short & steep)[:, None], people.height[:, None], tall)
    seen = standing_ellipses(flat.projection, axes, tall, settings.radius_m)
    own = silhouettes(people, flat, settings)
    if settings.paper:
        log_weight, windows = _score(people, judged, seen, own, flat, settings)
    else:
        windows = windows_of(judged, seen, own, LINES)
        balance = _balances(people, own, flat, short, steep)
        log_weight = _gains(windows, seen, own, balance, ~short & ~steep)
        rows = np.flatnonzero(~steep)
        log_weight[rows] += _feet_gains(people, judged, own, axes, rows, flat, settings)
        log_weight *= _BOXES_TELL if settings.detections_only else 1.0
        if boxes is not None and len(boxes):
            log_weight += box_log_weights(seen, own, flat_boxes(boxes, flat))
        spread_m = np.where(steep, _STEEP_HEIGHT_SD_M, _HEIGHT_SD_M)[:, None]
        log_weight -= 0.5 * ((tall - settings.initial_height_m) / spread_m) ** 2
    if alike is not None:
        log_weight += alike
    log_weight[is_taken(people, settings) | ~np.isfinite(seen.u)] = -np.inf
    return weigh_hypotheses(people, log_weight), windows


def _score(
    people: SpheroidPeople,
    judged: JudgedFrame,
    seen: Ellipses,
    own: Ellipses,
    flat: FlatView,
    settings: SpheroidSettings,
) -> tuple[Floats, list[Window]]:
    """(people, N) logarithms of the plain scores, as published, and the windows they are of.

    Each hypothesis has its own region of evaluation.
    """
    scale = settings.region_scale
    axes, tall = hypotheses_of(people, settings)
    region = standing_ellipses(flat.projection, axes, tall, settings.radius_m, scale)
    windows = windows_of(judged, _concatenate(seen, region), own, 0)
    with np.errstate(divide="ignore"):
        return np.log(judge(windows, seen, region).scores()), windows


def _gains(
    windows: list[Window], seen: Ellipses, own: Ellipses, balance: Floats, with_legs: Flags
) -> Floats:
    """(people, N) logarithms of weights: what speaks for hypotheses less what speaks against.

    Where we differ from [Waechter2013] eq. 2: C hardly tells near hypotheses apart, and foreground
    of people not followed yet, anywhere in the region, makes all alike. Here a pixel in the
    silhouette counts by how far its B lies above or below a balance: the logarithm of a likelihood
    ratio. What is outside of the silhouettes is the same for all hypotheses and cancels out.

    Args:
        balance: (people,) B from which on a pixel speaks for them.
        with_legs: (people,) whose lower halves are legs, which leave a gap: taken for a body, what
            is empty between them would draw spheroids up, to somebody smaller and farther away.
    """
    inside = sums_inside(windows, seen)
    area = np.maximum(np.nan_to_num(own.areas(), nan=1.0), 1.0)
    level = balance[:, None]
    gain = inside.ramp - level * inside.area
    legs = LEGS_WEIGHT * (inside.low_ramp - LEGS_BALANCE * inside.low_area)
    as_body = inside.low_ramp - level * inside.low_area
    gain += np.where(with_legs[:, None], legs - as_body, 0.0)
    return SHARPNESS * gain / area[:, None]


def _feet_gains(
    people: SpheroidPeople,
    judged: JudgedFrame,
    own: Ellipses,
    axes: Floats,
    rows: NDArray[np.intp],
    flat: FlatView,
    settings: SpheroidSettings,
) -> Floats:
    """(rows, N) logarithms of weights by what feet say; steeply seen, bodies hide them."""
    if len(rows) == 0:
        return np.zeros((0, axes.shape[1]))
    feet = feet_of(flat, axes[rows])
    parts = feet_parts(judged, flat, own, axes_of(people, settings), feet, rows)
    return FEET * feet_scores(parts, feet)


def _balances(
    people: SpheroidPeople, own: Ellipses, flat: FlatView, short: Flags, steep: Flags
) -> Floats:
    """(people,) B from which on a pixel speaks for them.

    Args:
        own: (people) their silhouettes. short: (people,) whose head is out of the picture.
        steep: who is seen steeply.
    """
    level = np.where(short, _CUT_BALANCE, _BALANCE)
    balance = np.where(steep, np.where(short, _STEEP_CUT_BALANCE, _STEEP_BALANCE), level)
    cut = short & steep
    if cut.any():
        balance[cut & near_side_hidden(people, own, flat)] = _HIDDEN_CUT_BALANCE
    return balance


def is_taken(people: SpheroidPeople, settings: SpheroidSettings) -> Flags:
    """(people, N) hypotheses too close to where somebody else stands ([Waechter2013] 3.2.2)."""
    close = np.zeros(people.weight.shape, bool)
    reach = 2 * settings.radius_m if settings.paper else settings.min_separation_m
    apart = np.hypot(*(people.xy[:, None] - people.xy[None]).transpose(2, 0, 1))
    width = np.abs(people.state[..., :2] - people.xy[:, None]).max(axis=(1, 2), initial=0.0)
    for one, other in zip(*np.nonzero(apart < reach + np.sqrt(2) * width[:, None]), strict=True):
        if one != other:
            offset = people.state[one, :, :2] - people.xy[other]
            close[one] |= np.hypot(offset[:, 0], offset[:, 1]) < reach
    return close


def _concatenate(one: Ellipses, other: Ellipses) -> Ellipses:
    """Both of each person's, (people, n + k)."""
    pairs = ((getattr(one, name), getattr(other, name)) for name in one.__slots__)
    return Ellipses(*(np.concatenate(pair, axis=1) for pair in pairs))

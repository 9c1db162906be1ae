"""What trackers of one camera think of, laid over the left picture: bodies and tracklets.

Everything is painted into one picture, however many hypotheses there are.
"""

from __future__ import annotations

import cv2
import numpy as np
from numpy.typing import NDArray

from app.core.i18n import tr
from app.core.keymap import in_brackets
from app.core.scenes import Colour, LegendEntry
from app.core.scenes.okabe_ito import YELLOW
from app.core.tracks.frame_state import FrameState, ViewOptions
from app.core.tracks.made_by import MadeBy, overlay_of, settings_of
from app.core.tracks.particle_weights import relative_weights
from tracking.geometry import View
from tracking.plugins import PluginKind, failed_drawing
from tracking.trackers import TRACKERS, Bodies, tracker_with
from tracking.tracks import Columns

Rgba = NDArray[np.uint8]
Floats = NDArray[np.float64]

_MOST_OUTLINES = 600
"""More would be neither told apart nor painted in time."""
_POINTS, _LEVELS = 20, 6
_FAINTEST, _STRONGEST = 45, 235
_REGION_ALPHA, _EDGE_ALPHA = 50, 220
_SUBPIXEL = 3
"""Bits of a pixel's fraction that OpenCV takes."""
_FARTHEST_PX = 20_000
_LIGHT: Colour = (190, 190, 190)
"""Stands for the colours of people."""


class BodyPainter:
    """Paints outlines of hypotheses, a region of evaluation, tracklets and a kernel.

    All are drawn as the run had them that is shown.

    Args:
        view: the camera over its floor; None: nothing but tracklets can be painted.
    """

    def __init__(self, view: View | None) -> None:
        self._view = view

    def over(
        self,
        state: FrameState,
        view_options: ViewOptions,
        below: Rgba | None,
        shape: tuple[int, ...],
    ) -> Rgba:
        """What is asked for over what lies over the left picture already, if anything does.

        Args:
            below: (height, width, 4) RGBA, as the result is. shape: of the picture.
        """
        layer = np.zeros((*shape[:2], 4), np.uint8)
        self._paint(state, view_options, layer)
        layer = _straight(layer)
        return layer if below is None else _laid_over(layer, below)

    def _paint(self, state: FrameState, view_options: ViewOptions, below: Rgba) -> None:
        """Paint what is asked for; colours are multiplied by their opacity, see `_ink`."""
        if self._view is not None and view_options.evaluation and _has_regions(state.run):
            self._paint_region(self._view, state, below)
        if self._view is not None and view_options.outlines:
            self._paint_outlines(self._view, state, below)
        if view_options.tracklets:
            _paint_tracklets(state, below)
            if self._view is not None and _has_kernels(state):
                self._paint_kernel(self._view, state, below)

    def _paint_outlines(self, view: View, state: FrameState, below: Rgba) -> None:
        """Of the selected person's particles, or of everybody's; the heavier the clearer."""
        particles = state.tracks.particles(state.frame)
        weights = relative_weights(particles)
        rows = np.arange(len(weights))
        if state.selected:
            rows = rows[particles["track"] == state.selected]
        if len(rows) > _MOST_OUTLINES:
            rows = rows[np.argsort(weights[rows], kind="stable")[-_MOST_OUTLINES:]]
        tracks = particles["track"][rows]
        xy = np.column_stack((particles["x"][rows], particles["y"][rows])).astype(np.float64)
        draw, settings = overlay_of(state.run, lambda overlays: overlays.outlines)
        drawn = draw(view, settings, Bodies(xy, _heights(state, tracks)), _POINTS)
        _stroke(below, drawn, state.colours.of_all(tracks), weights[rows])

    def _paint_region(self, view: View, state: FrameState, below: Rgba) -> None:
        """Where a hypothesis at the selected person's place is judged, less what others cover.

        As published ([Waechter2013] eq. 2): only runs with the setting `paper` have one.
        """
        rows = state.tracks.of_frame(state.frame)
        xy = np.column_stack((rows["x"], rows["y"])).astype(np.float64)
        known = np.isfinite(xy).all(axis=1)
        own = known & (rows["track"] == state.selected)
        others = known & ~own
        if not own.any():
            return
        tall = _heights(state, rows["track"])
        person, rest = (Bodies(xy[some], tall[some]) for some in (own, others))
        overlay, settings = overlay_of(state.run, lambda overlays: overlays.evaluation)
        region = overlay.draw(view, settings, person, rest)
        inside = np.zeros(below.shape[:2], np.uint8)
        cv2.fillPoly(inside, _fixed(region.outline[None]), 255, cv2.LINE_8, _SUBPIXEL)
        for masked in _fixed(region.masked):
            cv2.fillPoly(inside, [masked], 0, cv2.LINE_8, _SUBPIXEL)
        below[inside > 0] = _ink(YELLOW, _REGION_ALPHA)
        edge = _ink(YELLOW, _EDGE_ALPHA)
        cv2.polylines(below, _fixed(region.outline[None]), True, edge, 2, cv2.LINE_AA, _SUBPIXEL)

    def _paint_kernel(self, view: View, state: FrameState, below: Rgba) -> None:
        """The rectangle in which mean shift gathers tracklets round the selected person's middle.

        A run that holds tracklets gathers so only those that are nobody's yet.
        """
        rows = state.tracks.of_frame(state.frame)
        own = rows["track"] == state.selected
        if not own.any():
            return
        draw, settings = overlay_of(state.run, lambda overlays: overlays.kernel)
        corners = draw(view, settings, np.array([[rows["x"][own][0], rows["y"][own][0]]], float))
        if not np.isfinite(corners).all():
            return
        white = _ink((255, 255, 255), _STRONGEST)
        for shade, width in ((_ink((0, 0, 0), _EDGE_ALPHA), 4), (white, 2)):
            cv2.polylines(below, _fixed(corners), True, shade, width, cv2.LINE_AA, _SUBPIXEL)


def legend_of(state: FrameState, view_options: ViewOptions) -> tuple[LegendEntry, ...]:
    """What is laid over the picture, as far as it is seen in the frame."""
    said = {
        "outlines": (_LIGHT, tr("hypotheses: clearer means likelier")),
        "evaluation": (YELLOW, tr("region of evaluation")),
        "tracklets": (
            _LIGHT,
            tr("tracklets: the dot is this frame; faint ones belong to no person"),
        ),
    }
    asked = {name: getattr(view_options, name) for name in said}
    entries = [LegendEntry(*said[name]) for name in said if asked[name] and _seen(state, name)]
    if asked["tracklets"] and state.selected and _has_kernels(state):
        entries.append(LegendEntry((255, 255, 255), tr("kernel: its tracklets form one person")))
    return tuple(entries)


def _seen(state: FrameState, name: str) -> bool:
    return not why_nothing(state, name)


def why_nothing(state: FrameState, name: str) -> str:
    """What to do where something that was asked for is not seen in the frame; "": it is."""
    tracks, frame = state.tracks, state.frame
    made_by = "" if state.run is None else state.run.tracker
    if (failed := failed_drawing(PluginKind.TRACKER, made_by)) is not None:
        return tr(failed.message)
    if name == "tracklets" and not len(tracks.tracklets(frame)["track"]):
        return tr(
            "No points are tracked here: track with {tracker}{key} to see tracklets",
            tracker=tracker_with(lambda spec: spec.overlays.tracklets).name,
            key=in_brackets("tracks.track"),
        )
    if name == "outlines" and not len(tracks.particles(frame)["track"]):
        return tr(
            "No hypotheses here: track with {tracker}, or two cameras{key}, to see them",
            tracker=tracker_with(lambda spec: spec.overlays.outlines).name,
            key=in_brackets("tracks.track"),
        )
    if name == "evaluation" and not _has_regions(state.run):
        return _no_regions()
    if name == "evaluation" and not state.selected:
        return tr("Click a person to see the region in which their hypotheses are evaluated")
    return ""


def _no_regions() -> str:
    """Which tracker has regions of evaluation."""
    spec = tracker_with(lambda one: one.overlays.evaluation)
    assert spec.overlays.evaluation is not None
    return tr(
        "No region of evaluation here: only {tracker} with its setting '{setting}' has "
        "one; track with that{key} to see it",
        tracker=spec.name,
        setting=spec.overlays.evaluation.setting,
        key=in_brackets("tracks.track"),
    )


def _has_regions(run: MadeBy | None) -> bool:
    """Whether a run's hypotheses were judged in regions of evaluation: as published."""
    spec = TRACKERS.get(run.tracker) if run is not None else None
    if spec is None or spec.overlays.evaluation is None:
        return False
    return bool(getattr(settings_of(run, spec), spec.overlays.evaluation.setting))


def _has_kernels(state: FrameState) -> bool:
    """Whether tracklets are gathered by mean shift here."""
    if state.run is None:
        return bool(len(state.tracks.tracklets(state.frame)["track"]))
    spec = TRACKERS.get(state.run.tracker)
    return spec is not None and spec.overlays.kernel is not None


def _heights(state: FrameState, tracks: NDArray[np.int32]) -> Floats:
    """(n,) m of the bodies of tracks (n,) as estimated; NaN: not estimated."""
    rows = state.tracks.signals(state.frame)
    known = np.isfinite(rows["height_m"])
    estimated = dict(
        zip(rows["track"][known].tolist(), rows["height_m"][known].tolist(), strict=True)
    )
    return np.array([estimated.get(track, np.nan) for track in tracks.tolist()])


def _paint_tracklets(state: FrameState, below: Rgba) -> None:
    """Last positions as strokes in their person's colour, a dot where each point is now."""
    rows = state.tracks.tracklets(state.frame)
    ways = _ways(rows)
    colours = state.colours.of_all(rows["track"])
    weights = np.where(rows["track"] > 0, 1.0, 0.3).astype(np.float32)
    _stroke(below, ways, colours, weights, closed=False)
    alpha = _alpha(weights)
    for way, colour, strength in zip(_fixed(ways), colours.tolist(), alpha.tolist(), strict=True):
        red, green, blue = colour
        shade = _ink((red, green, blue), strength)
        cv2.circle(below, way[0].tolist(), 2 << _SUBPIXEL, shade, -1, cv2.LINE_AA, _SUBPIXEL)


def _ways(rows: Columns) -> Floats:
    """(n, 3, 2) px, newest first; missing positions stand where the ones after them do."""
    names = (("u0", "v0"), ("u1", "v1"), ("u2", "v2"))
    ways = np.stack([np.column_stack([rows[one] for one in pair]) for pair in names], axis=1)
    ways = ways.astype(np.float64)
    for step in (1, 2):
        missing = ~np.isfinite(ways[:, step]).all(axis=1)
        ways[missing, step] = ways[missing, step - 1]
    return ways


def _stroke(
    below: Rgba,
    shapes: Floats,
    colours: NDArray[np.uint8],
    weights: NDArray[np.float32],
    *,
    closed: bool = True,
) -> None:
    """Draw (n, points, 2) shapes, the faintest first: one call for all of one colour and level."""
    seen = np.isfinite(shapes).all(axis=(1, 2))
    level = np.clip((weights * _LEVELS).astype(np.int64), 0, _LEVELS - 1)
    fixed = _fixed(shapes[seen])
    keys = np.column_stack((level[seen], colours[seen]))
    kinds, of_kind = np.unique(keys, axis=0, return_inverse=True)
    for number, (step, red, green, blue) in enumerate(kinds.tolist()):
        chosen = np.flatnonzero(of_kind.reshape(-1) == number).tolist()
        alpha = int(_alpha(np.array([(step + 1) / _LEVELS]))[0])
        drawn = [fixed[one] for one in chosen]
        shade = _ink((red, green, blue), alpha)
        cv2.polylines(below, drawn, closed, shade, 1, cv2.LINE_AA, _SUBPIXEL)


def _ink(colour: Colour, alpha: int) -> tuple[float, float, float, int]:
    """A colour multiplied by its opacity: smooth edges of strokes then keep their hue."""
    red, green, blue = (part * alpha / 255 for part in colour)
    return red, green, blue, alpha


def _straight(layer: Rgba) -> Rgba:
    """Colours as they are, no longer multiplied by their opacity."""
    seen = layer[..., 3] > 0
    inked = layer[seen].astype(np.float32)
    inked[:, :3] = np.minimum(np.rint(inked[:, :3] * 255 / inked[:, 3:]), 255)
    layer[seen] = inked
    return layer


def _laid_over(layer: Rgba, below: Rgba) -> Rgba:
    """A layer over another one, as the painter lays pictures over each other."""
    result, seen = below.copy(), layer[..., 3] > 0
    top, ground = layer[seen].astype(np.float32), below[seen].astype(np.float32)
    share = top[:, 3:] / 255
    alpha = top[:, 3:] + ground[:, 3:] * (1 - share)
    mixed = top[:, :3] * top[:, 3:] + ground[:, :3] * ground[:, 3:] * (1 - share)
    result[seen, :3] = mixed / alpha
    result[seen, 3] = alpha[:, 0]
    return result


def _alpha(weights: NDArray[np.floating]) -> NDArray[np.int64]:
    alpha = _FAINTEST + (_STRONGEST - _FAINTEST) * np.clip(weights, 0, 1)
    return np.asarray(alpha, np.int64)


def _fixed(shapes: Floats) -> list[NDArray[np.int32]]:
    """Shapes in fractions of pixels, as OpenCV takes them; none that are nowhere."""
    near = np.clip(np.nan_to_num(shapes, nan=-_FARTHEST_PX), -_FARTHEST_PX, _FARTHEST_PX)
    return list(np.rint(near * (1 << _SUBPIXEL)).astype(np.int32))

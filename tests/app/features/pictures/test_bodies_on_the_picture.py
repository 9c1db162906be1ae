"""Outlines of hypotheses, the region of evaluation, tracklets and the kernel over the picture."""

from __future__ import annotations

from dataclasses import dataclass, field, replace
from typing import Any

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from app.core.colours.track_colours import TrackColours
from app.core.tracks.frame_state import FrameState, ViewOptions
from app.core.tracks.made_by import AtWork
from app.features.pictures.bodies import BodyPainter, _laid_over, legend_of, why_nothing
from tracking.geometry import Camera, Ground, View
from tracking.trackers.flow import FlowSettings, kernel_table
from tracking.trackers.flow.mean_shift import is_inside
from tracking.trackers.spheroid import SpheroidSettings, outlines
from tracking.tracks import (
    DETECTION_COLUMNS,
    PARTICLE_COLUMNS,
    SIGNAL_COLUMNS,
    TRACK_COLUMNS,
    TRACKLET_COLUMNS,
    Columns,
    Particles,
    Run,
    empty,
)

SIZE = (320, 240)
NOTHING = ViewOptions(trails=False)


def rows_of(types: Any, **columns: Any) -> Columns:
    """A table with these columns, zeros in the others."""
    count = len(next(iter(columns.values())))
    return {
        name: np.asarray(columns.get(name, np.zeros(count))).astype(dtype)
        for name, dtype in types.items()
    }


@dataclass
class OneFrame:
    """Tracks of a single frame."""

    rows: Columns = field(default_factory=lambda: empty(TRACK_COLUMNS))
    seen: Columns = field(default_factory=lambda: empty(PARTICLE_COLUMNS))
    points: Columns = field(default_factory=lambda: empty(TRACKLET_COLUMNS))
    noticed: Columns = field(default_factory=lambda: empty(SIGNAL_COLUMNS))

    def of_frame(self, _: int) -> Columns:
        return self.rows

    def particles(self, _: int) -> Columns:
        return self.seen

    def tracklets(self, _: int) -> Columns:
        return self.points

    def signals(self, _: int) -> Columns:
        return self.noticed


PEOPLE = rows_of(TRACK_COLUMNS, track=[1, 2], x=[-0.8, 0.9], y=[4.0, 4.2])
PARTICLES = rows_of(
    PARTICLE_COLUMNS, track=[1, 1, 2], x=[-0.8, -0.7, 0.9], y=[4.0, 4.0, 4.2], weight=[0.9, 0.1, 1]
)


@pytest.fixture(scope="module")
def view() -> View:
    matrix = np.array([[300.0, 0.0, 160.0], [0.0, 300.0, 120.0], [0.0, 0.0, 1.0]])
    camera = Camera(matrix, np.zeros(5), *SIZE)
    return View(camera, Ground(height_m=2.6, tilt_deg=25.0))


def run_of(tracker: str, **settings: Any) -> Run:
    """A run of a tracker with some settings; points of nested ones are written as underscores."""
    named = {name.replace("__", "."): value for name, value in settings.items()}
    none = Particles.none(PARTICLE_COLUMNS)
    return Run(tracker, named, 0, (0, 1), empty(TRACK_COLUMNS), empty(DETECTION_COLUMNS), none)


PUBLISHED = run_of("spheroid", paper=True)


def painted(
    view: View | None,
    tracks: OneFrame,
    selected: int = 0,
    run: Run | None = None,
    **asked: bool,
) -> np.ndarray:
    state = FrameState(0, tracks, selected=selected, run=run)
    shape = (SIZE[1], SIZE[0], 3)
    return BodyPainter(view).over(state, replace(NOTHING, **asked), None, shape)


def on_outline(picture: np.ndarray, outline: np.ndarray) -> np.ndarray:
    """The pixels nearest to an outline's corners, of those inside the picture."""
    at = np.rint(outline).astype(int)
    is_inside = ((at >= 0) & (at < SIZE)).all(axis=1)
    return picture[at[is_inside, 1], at[is_inside, 0]]


def test_each_hypothesis_is_an_outline_in_its_persons_colour(view: View) -> None:
    picture = painted(view, OneFrame(PEOPLE, PARTICLES), outlines=True)
    for track, place in ((1, (-0.8, 4.0)), (2, (0.9, 4.2))):
        (outline,) = outlines(view, np.array([place]), 1.72)
        pixels = on_outline(picture, outline)
        assert (pixels[:, 3] > 0).mean() > 0.9
        assert np.median(pixels[:, :3], axis=0) == pytest.approx(TrackColours().of(track), abs=3)


def test_heavier_hypotheses_are_clearer(view: View) -> None:
    picture = painted(view, OneFrame(PEOPLE, PARTICLES), outlines=True)
    alphas = np.unique(picture[..., 3])
    (light,) = outlines(view, np.array([(-0.7, 4.0)]), 1.72)
    assert on_outline(picture, light)[:, 3].min() < alphas.max() / 2


def test_of_a_selected_person_only_their_hypotheses_are_drawn(view: View) -> None:
    picture = painted(view, OneFrame(PEOPLE, PARTICLES), selected=2, outlines=True)
    colours = picture[picture[..., 3] > 120][:, :3]  # paler ones are rounded
    assert np.abs(colours - np.array(TrackColours().of(2), float)).max() <= 5


def test_outlines_are_as_tall_as_the_tracker_thinks(view: View) -> None:
    noticed = rows_of(SIGNAL_COLUMNS, track=[1, 2], height_m=[1.2, np.nan])
    picture = painted(view, OneFrame(PEOPLE, PARTICLES, noticed=noticed), outlines=True)
    (tall,), (small,) = (outlines(view, np.array([(-0.8, 4.0)]), h) for h in (1.72, 1.2))
    top = np.rint(tall[tall[:, 1].argmin()]).astype(int)
    assert picture[top[1], top[0], 3] == 0
    assert (on_outline(picture, small)[:, 3] > 0).mean() > 0.9


def test_what_a_tracker_at_work_thinks_is_drawn_with_its_own_settings(view: View) -> None:
    at_work = AtWork.of("spheroid", SpheroidSettings(radius_m=0.4, paper=True))
    state = FrameState(0, OneFrame(PEOPLE, PARTICLES), selected=1, run=at_work)
    asked = replace(NOTHING, outlines=True, evaluation=True)
    picture = BodyPainter(view).over(state, asked, None, (SIZE[1], SIZE[0], 3))
    (stout,) = outlines(view, np.array([(-0.8, 4.0)]), 1.72, 0.4)
    assert (on_outline(picture, stout)[:, 3] > 0).mean() > 0.9
    assert why_nothing(state, "evaluation") == ""


def test_the_legend_tells_of_what_is_seen_alone() -> None:
    asked = replace(NOTHING, outlines=True, evaluation=True, tracklets=True)
    state = FrameState(0, OneFrame(PEOPLE, PARTICLES), selected=1, run=PUBLISHED)
    texts = " ".join(entry.text for entry in legend_of(state, asked))
    assert "hypotheses" in texts
    assert "region of evaluation" in texts
    assert "tracklets" not in texts
    assert legend_of(state, NOTHING) == ()


def test_the_region_of_evaluation_leaves_out_what_others_cover(view: View) -> None:
    near = rows_of(TRACK_COLUMNS, track=[1, 2], x=[0.0, 0.4], y=[4.0, 4.2])
    picture = painted(view, OneFrame(near), 1, PUBLISHED, evaluation=True)
    (other,) = outlines(view, np.array([(0.4, 4.2)]), 1.72)
    middle = np.rint(other.mean(axis=0)).astype(int)
    assert picture[middle[1], middle[0], 3] == 0
    (own,) = outlines(view, np.array([(0.0, 4.0)]), 1.72)
    left = np.rint(own[own[:, 0].argmin()]).astype(int)
    assert picture[left[1], left[0], 3] > 0


def test_nobody_selected_has_no_region(view: View) -> None:
    assert not painted(view, OneFrame(PEOPLE), run=PUBLISHED, evaluation=True).any()


def test_tracklets_are_strokes_in_the_colour_of_their_cluster() -> None:
    points = rows_of(
        TRACKLET_COLUMNS,
        track=[3, 0],
        u0=[100, 200],
        v0=[50, 60],
        u1=[90, 195],
        v1=[50, 60],
        u2=[80, 190],
        v2=[50, 60],
    )
    picture = painted(None, OneFrame(points=points), tracklets=True)
    assert picture[50, 85, :3].astype(int) == pytest.approx(TrackColours().of(3), abs=2)
    assert picture[50, 100, :3].astype(int) == pytest.approx(TrackColours().of(3), abs=2)
    assert picture[60, 192, :3].astype(int) == pytest.approx(TrackColours().of(0), abs=3)
    assert picture[50, 100, 3] > picture[60, 200, 3] > 0


def test_a_tracklet_of_one_position_is_a_dot() -> None:
    nan = np.nan
    points = rows_of(
        TRACKLET_COLUMNS, track=[3], u0=[100], v0=[50], u1=[nan], v1=[nan], u2=[nan], v2=[nan]
    )
    picture = painted(None, OneFrame(points=points), tracklets=True)
    drawn = np.argwhere(picture[..., 3] > 0)
    assert np.abs(drawn - (50, 100)).max() <= 3


@pytest.mark.parametrize("reach", [0.4, 0.8])
def test_the_kernel_drawn_is_what_mean_shift_holds_round_who_is_selected(
    view: View, reach: float
) -> None:
    chosen = {"clusters__width_m": 0.5, "clusters__height_m": 1.2, "clusters__bandwidth": reach}
    flow = run_of("flow", **chosen)
    picture = painted(view, OneFrame(PEOPLE), 1, flow, tracklets=True)
    v, u = np.argwhere(picture[..., :3].sum(axis=-1) > 200).T  # not its dark edge
    middle = view.pixel_from_world(np.array([[-0.8, 4.0, 0.8]]))
    table = kernel_table(view, width_m=0.5, height_m=1.2).scaled(2 * reach)
    for axis, drawn in ((0, u), (1, v)):
        tried = np.repeat(middle, 3201, axis=0)
        tried[:, axis] += np.arange(-160, 160.01, 0.1)
        held = tried[is_inside(middle[:, None], table.at(middle)[:, None], tried[:, None])[0], axis]
        stroke = 1.5  # px beyond its middle
        assert drawn.min() + stroke == pytest.approx(held.min(), abs=1.5)
        assert drawn.max() - stroke == pytest.approx(held.max(), abs=1.5)


def test_there_is_no_kernel_in_runs_that_gather_no_tracklets(view: View) -> None:
    assert FlowSettings().persistent_points
    assert painted(view, OneFrame(PEOPLE), 1, run_of("flow"), tracklets=True).any()
    assert not painted(view, OneFrame(PEOPLE), 1, run_of("spheroid"), tracklets=True).any()


def test_outlines_are_as_wide_as_the_run_had_them(view: View) -> None:
    broad = run_of("spheroid", radius_m=0.5)
    picture = painted(view, OneFrame(PEOPLE, PARTICLES), run=broad, outlines=True)
    (outline,) = outlines(view, np.array([(0.9, 4.2)]), 1.72, radius_m=0.5)
    assert (on_outline(picture, outline)[:, 3] > 0).mean() > 0.9


def test_as_published_everybody_is_as_tall_as_in_the_paper(view: View) -> None:
    picture = painted(view, OneFrame(PEOPLE, PARTICLES), run=PUBLISHED, outlines=True)
    (outline,) = outlines(view, np.array([(0.9, 4.2)]), 1.8)
    assert (on_outline(picture, outline)[:, 3] > 0).mean() > 0.9


def test_the_region_of_evaluation_is_as_large_as_the_run_had_it(view: View) -> None:
    one = OneFrame(rows_of(TRACK_COLUMNS, track=[1], x=[0.0], y=[4.0]))
    small, large = (
        painted(view, one, 1, run_of("spheroid", paper=True, region_scale=scale), evaluation=True)
        for scale in (1.2, 1.6)
    )
    covered = [np.count_nonzero(picture[..., 3]) for picture in (small, large)]
    assert covered[1] == pytest.approx(covered[0] * (1.6 / 1.2) ** 2, rel=0.15)


@pytest.mark.parametrize("run", [None, run_of("spheroid"), run_of("flow"), run_of("three-part")])
def test_runs_that_judge_in_no_region_show_none_and_say_why(view: View, run: Run | None) -> None:
    assert not painted(view, OneFrame(PEOPLE), 1, run, evaluation=True).any()
    said = why_nothing(FrameState(0, OneFrame(PEOPLE), selected=1, run=run), "evaluation")
    assert "setting 'paper'" in said


def test_without_a_floor_nothing_but_tracklets_is_drawn() -> None:
    tracks = OneFrame(PEOPLE, PARTICLES)
    asked = {"outlines": True, "evaluation": True, "tracklets": True}
    assert not painted(None, tracks, 1, PUBLISHED, **asked).any()


def test_people_behind_the_camera_are_not_drawn(view: View) -> None:
    behind = rows_of(PARTICLE_COLUMNS, track=[1], x=[0.0], y=[-5.0], weight=[1.0])
    assert not painted(view, OneFrame(PEOPLE, behind), outlines=True).any()


channel = st.integers(0, 255)
pixels = st.lists(st.tuples(channel, channel, channel, channel), min_size=1, max_size=9)


@given(pixels, st.data())
def test_one_layer_lies_over_another_as_a_painter_lays_them(
    below: list[tuple[int, ...]], data: st.DataObject
) -> None:
    top = data.draw(
        st.lists(
            st.tuples(channel, channel, channel, channel),
            min_size=len(below),
            max_size=len(below),
        )
    )
    one, other = (np.array([rows], np.uint8) for rows in (top, below))
    result = _laid_over(one, other).astype(float)
    share = one[..., 3:].astype(float) / 255
    under = other[..., 3:].astype(float) / 255
    alpha = share + under * (1 - share)
    assert result[..., 3:] == pytest.approx(255 * alpha, abs=1.01)
    mixed = one[..., :3] * share + other[..., :3] * under * (1 - share)
    wrong = np.abs(result[..., :3] - mixed / np.maximum(alpha, 1e-9)) * (alpha > 0)
    assert wrong.max() <= 1.01

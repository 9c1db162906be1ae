"""The same trajectories counted by PedPy: the same passages, people, densities and speeds."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest
from walks import crowd

from tracking.counting import (
    CountingLine,
    Passages,
    Paths,
    Region,
    area,
    lengths,
    occupancy,
    passages,
    velocities,
)

pytest.importorskip(
    "pedpy", reason="PedPy is not installed; its numbers are compared with only then"
)
pytestmark = pytest.mark.filterwarnings("ignore")  # what pandas says of PedPy is not ours

LINES = (
    CountingLine("across", (0.0, -3.0), (0.0, 3.0)),
    CountingLine("slanted", (-2.5, -2.0), (3.0, 1.5)),
)
REGIONS = (
    Region("square", ((-1.5, -1.5), (1.5, -1.5), (1.5, 1.5), (-1.5, 1.5))),
    Region("slanted", ((-3.0, -3.0), (1.0, -2.0), (2.0, 0.0), (-1.0, 2.5), (-2.5, 1.0))),
)
FPS = 10.0
SEEDS = range(6)


def before_the_last_frame(found: Passages, columns: dict[str, Any]) -> Passages:
    """PedPy looks at no movement into the last frame of a track."""
    last = np.zeros(columns["track"].max() + 1, int)
    np.maximum.at(last, columns["track"], columns["frame"])
    return found.rows(found.frame < last[found.track])


def trajectories(columns: dict[str, Any]) -> Any:
    import pandas
    import pedpy

    rows = {"id": columns["track"], "frame": columns["frame"], "x": columns["x"], "y": columns["y"]}
    return pedpy.TrajectoryData(pandas.DataFrame(rows), frame_rate=FPS)


@pytest.mark.parametrize("seed", SEEDS)
@pytest.mark.parametrize("line", LINES, ids=lambda line: line.name)
def test_the_same_people_pass_in_the_same_frames(seed: int, line: CountingLine) -> None:
    import pedpy
    from pedpy.methods.method_utils import compute_crossing_frames

    columns = crowd(seed)
    across = pedpy.MeasurementLine([line.start, line.end])
    theirs = compute_crossing_frames(traj_data=trajectories(columns), measurement_line=across)
    ours = before_the_last_frame(passages(columns, FPS, [line]), columns)
    said = sorted(zip(theirs["id"].tolist(), theirs["frame"].tolist(), strict=True))
    assert sorted(zip(ours.track.tolist(), ours.frame.tolist(), strict=True)) == said
    assert len(said) > 0


@pytest.mark.parametrize("seed", SEEDS)
def test_first_passages_rise_as_n_t_does(seed: int) -> None:
    import pedpy

    columns = crowd(seed)
    across = pedpy.MeasurementLine([LINES[0].start, LINES[0].end])
    n_t, _ = pedpy.compute_n_t(traj_data=trajectories(columns), measurement_line=across)
    ours = before_the_last_frame(passages(columns, FPS, LINES[:1]), columns)
    _, first = np.unique(ours.track, return_index=True)  # sorted by time: the first of each
    so_far = np.searchsorted(np.sort(ours.frame[first]), n_t["frame"], side="right")
    assert so_far.tolist() == n_t["cumulative_pedestrians"].tolist()


@pytest.mark.parametrize("seed", SEEDS)
@pytest.mark.parametrize("region", REGIONS, ids=lambda region: region.name)
def test_densities_are_the_same_in_every_frame(seed: int, region: Region) -> None:
    import pedpy

    columns = crowd(seed)
    theirs = pedpy.compute_classic_density(
        traj_data=trajectories(columns), measurement_area=pedpy.MeasurementArea(region.polygon)
    )
    (ours,) = occupancy(columns, FPS, [region], step_s=1 / FPS)
    assert ours.density[theirs["frame"]] == pytest.approx(theirs["density"].to_numpy(), abs=1e-12)
    assert area(region.polygon) == pytest.approx(pedpy.MeasurementArea(region.polygon).area)
    assert theirs["density"].max() > 0


def single_sided(columns: dict[str, Any], frame_step: int) -> Any:
    import pedpy

    return pedpy.compute_individual_speed(
        traj_data=trajectories(columns),
        frame_step=frame_step,
        speed_calculation=pedpy.SpeedCalculation.BORDER_SINGLE_SIDED,
    )


@pytest.mark.parametrize("seed", SEEDS)
@pytest.mark.parametrize("frame_step", [1, 3, 5])
def test_speeds_are_the_same_at_every_place(seed: int, frame_step: int) -> None:
    columns = crowd(seed)
    theirs = single_sided(columns, frame_step).sort_values(["id", "frame"])
    ours = lengths(velocities(Paths.on_floor(columns), FPS, frame_step))
    assert ours == pytest.approx(theirs["speed"].to_numpy(), abs=1e-9)


@pytest.mark.parametrize("seed", SEEDS)
@pytest.mark.parametrize("region", REGIONS, ids=lambda region: region.name)
def test_mean_speeds_are_the_same_in_every_frame_with_somebody_inside(
    seed: int, region: Region
) -> None:
    import pedpy

    columns = crowd(seed)
    theirs = pedpy.compute_mean_speed_per_frame(
        traj_data=trajectories(columns),
        individual_speed=single_sided(columns, 3),
        measurement_area=pedpy.MeasurementArea(region.polygon),
    )
    (ours,) = occupancy(columns, FPS, [region], step_s=1 / FPS, frame_step=3)
    mean = np.nan_to_num(ours.mean_speed[theirs["frame"]])  # PedPy: 0 where nobody is inside
    assert mean == pytest.approx(theirs["speed"].to_numpy(), abs=1e-9)

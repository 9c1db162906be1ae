"""Numbers of PedPy on made-up crowds; run as a program it prints them for `test_pedpy_numbers`.

cd tests/counting && python pedpy_numbers.py
"""

from __future__ import annotations

import warnings
from typing import Any

from walks import crowd

FPS = 10.0
SEEDS = (11, 12, 13)
LINE = ((-2.5, -2.0), (3.0, 1.5))
SQUARE = ((-1.5, -1.5), (1.5, -1.5), (1.5, 1.5), (-1.5, 1.5))
FRAME_STEP = 3


def numbers(seed: int) -> tuple[int, int, float, float]:
    """Crossings, people at the end of N(t), sums over frames of density and of mean speed."""
    import pandas
    import pedpy
    from pedpy.methods.method_utils import compute_crossing_frames

    columns: dict[str, Any] = crowd(seed)
    rows = {"id": columns["track"], "frame": columns["frame"], "x": columns["x"], "y": columns["y"]}
    walked = pedpy.TrajectoryData(pandas.DataFrame(rows), frame_rate=FPS)
    line, square = pedpy.MeasurementLine(LINE), pedpy.MeasurementArea(SQUARE)
    crossings = compute_crossing_frames(traj_data=walked, measurement_line=line)
    n_t, _ = pedpy.compute_n_t(traj_data=walked, measurement_line=line)
    density = pedpy.compute_classic_density(traj_data=walked, measurement_area=square)
    speed = pedpy.compute_individual_speed(
        traj_data=walked,
        frame_step=FRAME_STEP,
        speed_calculation=pedpy.SpeedCalculation.BORDER_SINGLE_SIDED,
    )
    mean = pedpy.compute_mean_speed_per_frame(
        traj_data=walked, individual_speed=speed, measurement_area=square
    )
    last = int(n_t["cumulative_pedestrians"].iloc[-1])
    return len(crossings), last, float(density["density"].sum()), float(mean["speed"].sum())


if __name__ == "__main__":
    warnings.simplefilter("ignore")
    for seed in SEEDS:
        print(f"    {seed}: {numbers(seed)!r},")

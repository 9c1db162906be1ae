"""The floor by stereo and by people: `python -m tests.benchmarks.floor [--only NAME ...] [--json]`.

Each recording's floor is found without the one that its manifest gives, and compared with it.
"""

from __future__ import annotations

import json
import time
from collections.abc import Callable, Iterator
from typing import Any

from tests.benchmarks.command import one_core, parser_of, real_data, tell
from tests.benchmarks.footage.recordings import Footage, all_footage, footage_names
from tracking.calibration.floor import FloorEstimate, floor_by_people, floor_by_stereo
from tracking.errors import TrackwrightError
from tracking.recording import Recording

_WAYS: dict[str, Callable[[Recording], FloorEstimate]] = {
    "stereo": floor_by_stereo,
    "people": floor_by_people,
}


def errors_of(footage: Footage) -> Iterator[dict[str, Any]]:
    """One row for each way that the recording suits; what was refused says so."""
    with footage.open() as recording:
        truth = recording.ground
        if truth is None or recording.calibration is None:
            return
        for way, find in _WAYS.items():
            if way == "stereo" and not recording.is_stereo:
                continue
            began = time.process_time()
            row: dict[str, Any] = {"recording": footage.name, "way": way}
            try:
                found = find(recording)
            except TrackwrightError as error:
                yield {**row, "refused": str(error)}
                continue
            ground = found.ground
            yield {
                **row,
                "height_percent": 100.0 * (ground.height_m / truth.height_m - 1.0),
                "tilt_deg": ground.tilt_deg - truth.tilt_deg,
                "roll_deg": ground.roll_deg - truth.roll_deg,
                "tilt_sigma_deg": found.tilt_sigma_deg,
                "cpu_s": time.process_time() - began,
            }


def main() -> None:
    """Read the command line, measure and print."""
    one_core()
    parser = parser_of("floor", __doc__)
    parser.add_argument("--only", nargs="+", choices=footage_names(), metavar="NAME")
    parser.add_argument("--data", default=real_data(), help="folder of recordings")
    parser.add_argument("--json", action="store_true", help="figures as JSON")
    asked = parser.parse_args()
    rows = []
    for footage in all_footage(asked.data, asked.only):
        for row in errors_of(footage):
            rows.append(row)
            if not asked.json:
                tell(_line(row))
    if asked.json:
        print(json.dumps(rows, indent=1))


def _line(row: dict[str, Any]) -> str:
    head = f"{row['recording']:22s} {row['way']:7s}"
    if "refused" in row:
        return f"{head} refused: {row['refused']}"
    return (
        f"{head} height {row['height_percent']:+6.2f} %, tilt {row['tilt_deg']:+6.2f}, roll "
        f"{row['roll_deg']:+6.2f} degrees (tilt give or take {row['tilt_sigma_deg']:.2f}), "
        f"{row['cpu_s']:.1f} s"
    )


if __name__ == "__main__":
    main()

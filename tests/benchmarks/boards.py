"""Cameras calibrated from rendered boards: `python -m tests.benchmarks.boards [--pairs N]`.

Pairs of pictures of each kind of board, by standard and by fisheye lenses, noise and blur included,
are calibrated, and compared with the cameras that they were rendered by.
"""

from __future__ import annotations

import json
import tempfile
import time
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import cv2
import numpy as np

from tests.benchmarks.command import one_core, parser_of, tell
from tests.calibration.rendered_boards import CAMERA, FISHEYE, pair_of, write_pairs
from tracking.calibration.boards import Board, BoardRequest, LensKind, calibrate_boards
from tracking.geometry import Camera, StereoCalibration

_BOARDS = (
    Board("chessboard", 9, 6, 0.025),
    Board("charuco", 7, 5, 0.05, dictionary="4X4_50"),
    Board("circles", 9, 6, 0.025),
    Board("asymmetric-circles", 4, 9, 0.02),
)
_LENSES: tuple[tuple[LensKind, Camera], ...] = (("standard", CAMERA), ("fisheye", FISHEYE))
_SEED = 7


def rows_of(pairs: int) -> Iterator[dict[str, Any]]:
    """A row for each kind of board and lens."""
    for board in _BOARDS:
        for lens, camera in _LENSES:
            with tempfile.TemporaryDirectory() as folder:
                left, right = write_pairs(Path(folder), board, pair_of(camera), pairs, _SEED)
                began_s = time.process_time()
                found = calibrate_boards(BoardRequest(left, right, board, lens))
            yield {
                "board": board.kind,
                "lens": lens,
                "pairs": len(found.used),
                "rms_px": found.rms_px,
                "row_error_px": found.row_error_px,
                **_errors(found.calibration, pair_of(camera)),
                "cpu_s": time.process_time() - began_s,
            }


def _errors(found: StereoCalibration, truth: StereoCalibration) -> dict[str, float]:
    """How far cameras are from those that they were rendered by."""
    turn, _ = cv2.Rodrigues(found.rotation @ truth.rotation.T)
    middle = found.left.matrix[:2, 2] - truth.left.matrix[:2, 2]
    return {
        "focal_percent": 100.0 * (found.left.matrix[0, 0] / truth.left.matrix[0, 0] - 1.0),
        "centre_px": float(np.hypot(*middle)),
        "turn_deg": float(np.rad2deg(np.linalg.norm(turn))),
        "baseline_percent": 100.0 * (found.baseline_m / truth.baseline_m - 1.0),
    }


def main() -> None:
    """Read the command line, measure and print."""
    one_core()
    parser = parser_of("boards", __doc__)
    parser.add_argument("--pairs", type=int, default=15, help="pairs of pictures of each board")
    parser.add_argument("--json", action="store_true", help="figures as JSON")
    asked = parser.parse_args()
    rows = []
    for row in rows_of(asked.pairs):
        rows.append(row)
        if not asked.json:
            tell(
                "{board:19s} {lens:9s} {pairs:3d} pairs, rms {rms_px:.3f} px, rows "
                "{row_error_px:.3f} px, focal length {focal_percent:+.2f} %, centre "
                "{centre_px:.1f} px, turn {turn_deg:.3f} degrees, baseline "
                "{baseline_percent:+.2f} %, {cpu_s:.1f} s".format(**row)
            )
    if asked.json:
        print(json.dumps(rows, indent=1))


if __name__ == "__main__":
    main()

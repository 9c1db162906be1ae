"""`calibrate`: cameras from images of a board, or roughly from matched points."""

from __future__ import annotations

import re
from contextlib import closing
from pathlib import Path
from typing import Any

import typer

from app.cli.destination import check_file, check_text_replaced
from app.cli.option_groups import BoardSquares
from app.cli.output import print_json, print_table, progress, say
from tracking.calibration.boards import (
    Board,
    BoardCalibration,
    BoardRequest,
    LensKind,
    calibrate_boards,
)
from tracking.calibration.rough import (
    RoughCalibration,
    RoughRequest,
    calibrate_one_roughly,
    calibrate_roughly,
)
from tracking.errors import CalibrationError
from tracking.geometry import StereoCalibration, write_calibration
from tracking.recording.places import open_pictures
from tracking.translation import msg, tr

_SIZE = re.compile(r"(\d{1,3})[xX*](\d{1,3})")
_USUAL_FOV_DEG = 65.0


def board_of(size: str, squares: BoardSquares) -> Board:
    """The board that was typed. Raises BadParameter where there is none such."""
    found = _SIZE.fullmatch(size.strip())
    if found is None:
        raise typer.BadParameter(
            msg("{size!r} is no size of a board; write it as 9x6", size=size), param_hint="--board"
        )
    try:
        columns, rows = int(found[1]), int(found[2])
        return Board(
            squares.kind, columns, rows, squares.square, squares.marker, squares.dictionary
        )
    except CalibrationError as error:
        raise typer.BadParameter(tr(error.message), param_hint="--board, --square") from error


def run_calibrate(
    left: str, right: str | None, board: Board, lens: LensKind, out: Path | None, *, as_json: bool
) -> None:
    """Calibrate, write the file, and print how good it is."""
    _check(out)
    with progress(msg("looking for the board")) as tell:
        found = calibrate_boards(BoardRequest(left, right, board, lens), tell)
    if out is not None:
        write_calibration(out, found.calibration)
    for note in found.notes:
        say(note)
    if as_json:
        print_json(as_document(found))
    else:
        print_table(_rows(found))
        if out is not None:
            say(msg("written: {path}", path=out))


def run_rough(
    left: str,
    right: str | None,
    fov_deg: float | None,
    baseline_m: float | None,
    out: Path | None,
    *,
    as_json: bool,
) -> None:
    """Calibrate roughly, write the file, and print what was found."""
    if (right is None) != (baseline_m is None):
        raise typer.BadParameter(
            msg(
                "give both: the right camera and its distance from the left one in metres; neither "
                "for one camera"
            ),
            param_hint="--right, --baseline",
        )
    _check(out)
    if fov_deg is None:
        fov_deg = _USUAL_FOV_DEG
        say(msg("the field of view is taken to be {fov:g} degrees; give --fov", fov=fov_deg))
    calibration, document = _roughly(left, right, fov_deg, baseline_m)
    if out is not None:
        write_calibration(out, calibration)
    say(msg("this calibration is rough: metres may be off by a tenth and more"))
    if as_json:
        print_json(document)
    else:
        print_table([(name, f"{value:.4g}") for name, value in document.items()])
        if out is not None:
            say(msg("written: {path}", path=out))


def _roughly(
    left: str, right: str | None, fov_deg: float, baseline_m: float | None
) -> tuple[StereoCalibration, dict[str, float]]:
    """The calibration, and the figures it is told by: of one camera the field of view alone."""
    if right is None or baseline_m is None:
        with closing(open_pictures(Path(left), left)) as pictures:
            return calibrate_one_roughly(pictures.size, fov_deg), {"fov": fov_deg}
    with progress(msg("matching points")) as tell:
        found = calibrate_roughly(RoughRequest(left, right, fov_deg, baseline_m), tell)
    return found.calibration, _rough_document(found)


def _check(out: Path | None) -> None:
    if out is not None:
        check_file(out)
        check_text_replaced(out, "-o")


def as_document(found: BoardCalibration) -> dict[str, Any]:
    """As the contract names it."""
    document: dict[str, Any] = {
        "rms": found.rms_px,
        "left_rms": found.left_rms_px,
        "right_rms": found.right_rms_px,
        "pairs": len(found.used),
        "rejected": list(found.rejected),
        "missed": list(found.missed),
        "baseline": found.calibration.baseline_m,
        "coverage": found.covered,
        "row_error": found.row_error_px,
        "per_picture": found.per_picture,
        "notes": [tr(note) for note in found.notes],
    }
    if found.right_rms_px is None:
        for name in ("right_rms", "baseline", "row_error"):
            del document[name]
    return document


def _rows(found: BoardCalibration) -> list[tuple[str, object]]:
    rows: list[tuple[str, object]] = [
        (msg("error"), msg("{px:.3f} px (root mean square)", px=found.rms_px)),
        (msg("left camera"), msg("{px:.3f} px", px=found.left_rms_px)),
    ]
    if found.right_rms_px is not None and found.row_error_px is not None:
        rows += [
            (msg("right camera"), msg("{px:.3f} px", px=found.right_rms_px)),
            (msg("baseline"), msg("{metres:.4f} m", metres=found.calibration.baseline_m)),
            (msg("rows after rectification"), msg("{px:.3f} px apart", px=found.row_error_px)),
        ]
    used = msg("{used} of {all}", used=len(found.used), all=len(found.used) + len(found.rejected))
    rows += [
        (msg("images used"), used),
        (msg("image covered"), f"{found.covered:.0%}"),
    ]
    return rows


def _rough_document(found: RoughCalibration) -> dict[str, float]:
    return {
        "matches": found.matches,
        "inliers": found.inlier_share,
        "row_error": found.row_error_px,
        "baseline": found.calibration.baseline_m,
        "fov": found.fov_deg,
    }

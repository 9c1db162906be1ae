"""Check: rows of both cameras, and the floor, against calibration and [ground]."""

from __future__ import annotations

import numpy as np

from tracking.arrays import Picture
from tracking.doctor.drawings import draw_floor, draw_rows
from tracking.doctor.evidence import StillPair
from tracking.doctor.fault_fit import Explained, explain
from tracking.doctor.faults import FAULTS, Rig
from tracking.doctor.findings import Finding, Mend
from tracking.doctor.floor_cost import floor_cost_m
from tracking.doctor.floor_points import floor_points
from tracking.doctor.residuals import floor_residuals, row_residuals
from tracking.geometry import Ground
from tracking.translation import msg

ROWS, FLOOR = "rows", "floor"
FEWEST_MATCHES = 120
"""Points in both cameras without which nothing is said about their rows."""
_LEAST_COST_M = 0.01
"""A fault that moves people by less is none."""


def check_geometry(pair: StillPair, rig: Rig) -> list[Finding]:
    """Faults of calibration and floor that the matched points show, and cost anything."""
    findings = []
    for told in explain(rig, pair.matches, FAULTS):
        # Where the floor is not given, rows that are off still spoil every disparity.
        cost = floor_cost_m(rig, told.mended) if rig[1] is not None else _unplaced_cost_m(rig, told)
        if cost >= _LEAST_COST_M:
            findings.append(_finding(pair, rig, told, cost))
        rig = told.mended
    return findings


def _unplaced_cost_m(rig: Rig, told: Explained) -> float:
    # A camera as people hang them, so that faults can be put in order.
    usual = Ground(2.5, 30.0)
    return floor_cost_m((rig[0], usual), (told.mended[0], usual))


def _finding(pair: StillPair, rig: Rig, told: Explained, cost_m: float) -> Finding:
    fault = told.fault
    rows = row_residuals(rig[0], pair.matches)
    figures: dict[str, float | int | str] = {
        "amount": told.amount * fault.per_unit,
        "sigma": told.sigma * fault.per_unit,
        "unit": fault.unit,
        "z": told.z,
        "matches": len(pair.matches),
        "rows_px": float(np.median(np.abs(rows))),
    }
    calibration, ground = told.mended
    mend = Mend(
        calibration if calibration is not rig[0] else None,
        ground if ground is not rig[1] else None,
    )
    return Finding(
        fault.code,
        # What is told is what is wrong: the opposite of what mends it.
        msg(fault.title, amount=-told.amount * fault.per_unit),
        msg(fault.fix),
        figures | {"amount": -told.amount * fault.per_unit},
        cost_m,
        alike=told.alike,
        picture=_picture(pair, rig, fault.needs_floor),
        mend=mend if fault.mendable else None,
    )


def _picture(pair: StillPair, rig: Rig, of_floor: bool) -> Picture | None:
    calibration, ground = rig
    if not of_floor or ground is None:
        residual = row_residuals(calibration, pair.matches)
        return draw_rows(calibration, pair.left, pair.right, pair.matches, residual)
    chosen = floor_points(calibration, ground, pair.matches)
    if chosen is None:
        return None
    matches = pair.matches.only(chosen)
    residual = floor_residuals(calibration, ground, matches)
    return draw_floor(calibration, ground, pair.left, matches.first, residual)

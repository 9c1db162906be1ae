"""A recording examined: every check that it allows, dearest finding first."""

from __future__ import annotations

from dataclasses import dataclass, field

from tracking.doctor import floor_check, geometry_check, moved_camera, pairing_checks
from tracking.doctor.evidence import SAMPLES, Samples, read_samples, still_pair
from tracking.doctor.findings import Examination, Finding
from tracking.doctor.floor_points import height_ratio
from tracking.doctor.residuals import focal_px
from tracking.geometry import StereoCalibration
from tracking.progress import Progress, no_progress
from tracking.recording import Recording
from tracking.translation import Message, msg

_MOVED, _PAIRED, _STEPS = SAMPLES + 2, SAMPLES + 3, SAMPLES + 11
"""Of an examination as it is told: the frames that are read, and what each later check takes of
their time; the last steps are those of looking for a floor."""
_LEAST_SAMPLES = 3
"""Images whose median shows no people."""


_MOST_RATIO = 1.6
"""Of heights that can be one another, measured badly: faults are fitted as small ones, and beyond
this all others would be, too."""


@dataclass
class _Findings:
    """What has been found so far, and what could be looked at."""

    found: list[Finding] = field(default_factory=list)
    checked: list[str] = field(default_factory=list)
    unchecked: dict[str, Message] = field(default_factory=dict)

    def add(self, code: str, finding: Finding | None) -> None:
        """A check that was made."""
        self.checked.append(code)
        if finding is not None:
            self.found.append(finding)

    def leave(self, why: Message, *codes: str) -> None:
        """Checks that cannot be made."""
        self.unchecked |= dict.fromkeys(codes, why)


def examine(recording: Recording, tell: Progress = no_progress) -> Examination:
    """Look for what is wrong with a recording's pairing, calibration and floor.

    Raises:
        RecordingError: a frame cannot be read.
    """
    calibration = recording.calibration if recording.is_stereo else None
    if calibration is not None and calibration.right is None:
        calibration = None
    samples = read_samples(recording, lambda done, _: tell(done, _STEPS))
    findings = _Findings()
    focal = None if calibration is None else focal_px(calibration)
    baseline = None if calibration is None else calibration.baseline_m
    moved, before = moved_camera.check_moved(samples, focal, baseline)
    findings.add(moved_camera.CODE, moved)
    tell(_MOVED, _STEPS)
    if recording.has_depth:
        found, why = floor_check.check_depth_floor(recording, _of_floor(tell))
        if why is None:
            findings.add(floor_check.DEPTH_FLOOR, found)
        else:
            findings.leave(why, floor_check.DEPTH_FLOOR)
    elif calibration is None:
        findings.leave(
            msg("needs two calibrated cameras"),
            pairing_checks.LAG, pairing_checks.SWAPPED, geometry_check.ROWS, geometry_check.FLOOR,
        )  # fmt: skip
    else:
        findings.add(pairing_checks.LAG, pairing_checks.check_lag(recording, calibration))
        tell(_PAIRED, _STEPS)
        _check_rig(findings, recording, calibration, _unmoved(samples, before), _of_floor(tell))
    tell(_STEPS, _STEPS)
    dearest_first = sorted(findings.found, key=lambda one: -one.cost_m)
    return Examination(tuple(dearest_first), tuple(findings.checked), findings.unchecked)


def _of_floor(tell: Progress) -> Progress:
    """How the search for a floor is told as a part of the examination."""
    return lambda done, total: tell(_PAIRED + done * (_STEPS - _PAIRED) // max(total, 1), _STEPS)


def _unmoved(samples: Samples, before: int) -> Samples:
    """Those before the camera moved, as it was set up; those after it where these are too few."""
    if before >= _LEAST_SAMPLES:
        return samples.part(0, before)
    return samples.part(before % len(samples.numbers), len(samples.numbers))


def _check_rig(
    findings: _Findings,
    recording: Recording,
    calibration: StereoCalibration,
    samples: Samples,
    tell: Progress,
) -> None:
    pair = still_pair(samples)
    geometry = (geometry_check.ROWS, geometry_check.FLOOR)
    if len(pair.matches) < geometry_check.FEWEST_MATCHES:
        why = msg("only {n} points are seen in both cameras", n=len(pair.matches))
        findings.leave(why, pairing_checks.SWAPPED, *geometry)
        return
    swapped = pairing_checks.check_swapped(pair, calibration)
    findings.add(pairing_checks.SWAPPED, swapped)
    if swapped is not None:
        # Everything else would be told about cameras that are not these.
        findings.leave(msg("needs cameras that are not swapped"), *geometry)
        return
    ground = recording.ground
    if ground is None:
        findings.leave(msg("the recording does not say where the floor is"), geometry_check.FLOOR)
    elif _is_another(height_ratio(calibration, ground, pair.matches)):
        # Nothing else is told of a floor that is not where it is given: all would be blamed.
        other, unknown = floor_check.check_other_floor(recording, tell)
        ground = None
        if unknown is None:
            findings.add(geometry_check.FLOOR, other)
        else:
            findings.leave(unknown, geometry_check.FLOOR)
    else:
        findings.checked.append(geometry_check.FLOOR)
    findings.found += geometry_check.check_geometry(pair, (calibration, ground))
    findings.checked.append(geometry_check.ROWS)


def _is_another(ratio: float | None) -> bool:
    """Whether the floor that is seen is no more the given one with a small fault."""
    return ratio is None or not 1 / _MOST_RATIO < ratio < _MOST_RATIO

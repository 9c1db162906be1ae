"""An examination in words for the doctor's page; without Qt."""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import dataclass, replace
from pathlib import Path

from app.core.i18n import N_, count_text, joined, sentence, strip_full_stop, tr
from app.features.doctor.scene import DoctorScene, FindingScene, State
from tracking.doctor import Examination, Finding, Mended, examine, mend_undoably, undo_mend
from tracking.progress import Progress
from tracking.recording import OpenOptions, Recording, open_from_manifest, open_recording

_SMALL_M = 0.005
"""Errors below it are no centimetre."""
_CHECKS: Mapping[str, str] = {
    "camera-moved": N_("whether a camera moved"),
    "cameras-out-of-step": N_("whether one camera is late"),
    "depth-floor": N_("the floor, by depth"),
    "cameras-swapped": N_("whether left and right are swapped"),
    "rows": N_("the calibration of the pair"),
    "floor": N_("where the floor is"),
}
"""By their codes."""
_FIGURES: Mapping[str, str] = {
    "matches": N_("Points seen in both cameras"),
    "rows_px": N_("Their rows differ by (px)"),
    "camera": N_("Camera"),
    "shift_px": N_("The image moved by (px)"),
    "sigma_px": N_("Standard deviation (px)"),
    "behind": N_("Points behind the cameras"),
    "behind_if_swapped": N_("The same with the cameras swapped"),
    "lag": N_("Lag measured (frames)"),
    "told": N_("Lag in recording.toml (frames)"),
    "seconds": N_("Lag measured (s)"),
    "height_m": N_("Height measured (m)"),
    "height_told_m": N_("Height in recording.toml (m)"),
    "tilt_deg": N_("Tilt measured (degrees)"),
    "tilt_told_deg": N_("Tilt in recording.toml (degrees)"),
    "roll_deg": N_("Roll measured (degrees)"),
    "roll_told_deg": N_("Roll in recording.toml (degrees)"),
}
"""By their names in the evidence, where that is no word."""
_AMOUNT = ("amount", "sigma", "unit")
_LEFT_OUT = frozenset((*_AMOUNT, "z"))
"""Told together, or for whoever writes programs."""


@dataclass(frozen=True, slots=True)
class Place:
    """Where a recording that is open in the window is opened once more, as its files are now.

    Attributes:
        path: what was opened.
        folder: what its manifest is relative to.
        manifest: as options and what was found made it up; None: the folder's recording.toml.
        allow_outside: that manifest may name files outside the folder.
    """

    path: Path
    folder: Path
    manifest: str | None
    allow_outside: bool

    @classmethod
    def of(cls, recording: Recording) -> Place:
        """That of an open recording."""
        manifest = None if recording.own_manifest else recording.manifest_text
        return cls(recording.path, recording.folder, manifest, recording.trusted)

    @property
    def options(self) -> OpenOptions:
        """What was allowed when it was opened."""
        return OpenOptions(allow_outside=self.allow_outside)

    def open(self) -> Recording:
        """Open it. Raises RecordingError, CalibrationError."""
        if self.manifest is None:
            return open_recording(self.path, self.options)
        return open_from_manifest(self.folder, self.manifest, self.options)


def examined(place: Place, progress: Progress) -> Examination:
    """Examine a recording as its files are now; on any thread.

    Where it has no recording.toml of its own there is nothing to write a mend into.

    Raises RecordingError, CancelledError.
    """
    with place.open() as recording:
        found = examine(recording, progress)
    if place.manifest is None:
        return found
    return replace(found, findings=tuple(replace(one, mend=None) for one in found.findings))


def mended(place: Place, finding: Finding) -> Mended:
    """Mend a finding in the files; on any thread. Raises RecordingError, OutputError."""
    with place.open() as recording:
        return mend_undoably(recording, finding)


def undone(files: Mended) -> tuple[Path, ...]:
    """Take a mend back. Raises RecordingError, OutputError."""
    return undo_mend(files)


def working() -> DoctorScene:
    """While the recording is examined."""
    return DoctorScene(State.WORKING, tr("The recording is being checked."))


def cancelled() -> DoctorScene:
    """After Cancel."""
    return DoctorScene(State.CANCELLED, tr("The check was cancelled. Check again starts it anew."))


def failed(reason: str) -> DoctorScene:
    """Where it cannot be examined."""
    return DoctorScene(State.FAILED, reason)


def scene_of(examination: Examination, mended_last: str = "") -> DoctorScene:
    """What was found, dearest first."""
    findings = tuple(map(_finding, examination.findings))
    why = [f"{_check(code)} ({tr(reason)})" for code, reason in examination.unchecked.items()]
    unchecked = tr("Not checked: {checks}", checks=joined("; ", why)) if why else ""
    if findings:
        text = count_text(
            len(findings), "{n} finding, dearest first", "{n} findings, dearest first"
        )
        return DoctorScene(State.FOUND, text, findings, unchecked, mended_last)
    text = tr("Nothing is wrong, as far as the images tell.")
    if examination.is_partial:
        text = tr(
            "Nothing was found, but {count} of {all} checks could not be made.",
            count=len(examination.unchecked),
            all=len(examination.unchecked) + len(examination.checked),
        )
    if examination.checked:
        made = joined(", ", list(map(_check, examination.checked)))
        text += "\n" + tr("Checked: {checks}", checks=made)
    return DoctorScene(State.WELL, text, (), unchecked, mended_last)


def _finding(found: Finding) -> FindingScene:
    return FindingScene(
        code=found.code,
        title=strip_full_stop(sentence(found.title)),
        cost=_cost(found.cost_m),
        meaning=_meaning(found.cost_m),
        fix=sentence(found.fix),
        figures=_figures(found.evidence),
        alike=joined(", ", list(found.alike)),
        picture=found.picture,
        mendable=found.mend is not None,
    )


def _cost(cost_m: float) -> str:
    if not math.isfinite(cost_m):
        return tr("no position is right")
    if cost_m < _SMALL_M:
        return tr("less than 1 cm on the floor")
    return tr("{metres} m on the floor", metres=f"{cost_m:.2f}")


def _meaning(cost_m: float) -> str:
    if not math.isfinite(cost_m):
        return tr("No position on the floor is right.")
    if cost_m < _SMALL_M:
        return tr("A person at 5 m is hardly misplaced: by less than 1 cm.")
    return tr("A person at 5 m is misplaced by {metres} m on the floor.", metres=f"{cost_m:.2f}")


def _check(code: str) -> str:
    return tr(_CHECKS[code]) if code in _CHECKS else code


def _figures(evidence: Mapping[str, float | int | str]) -> tuple[tuple[str, str], ...]:
    """Names and values that people read; an amount with its uncertainty and unit in one."""
    rows = []
    if "amount" in evidence:
        amount, sigma, unit = (evidence.get(name, "") for name in _AMOUNT)
        said = _figure(amount) if sigma == "" else _measured(amount, sigma)
        rows.append((tr("Amount"), f"{said} {tr(str(unit))}".strip()))
    for name, value in evidence.items():
        if name not in _LEFT_OUT:
            rows.append((tr(_FIGURES.get(name, name)), _figure(value)))
    return tuple(rows)


def _measured(amount: float | int | str, sigma: float | int | str) -> str:
    """An amount with as many decimals as its uncertainty has, of which one digit is said."""
    if isinstance(amount, str) or isinstance(sigma, str) or not 0 < sigma < math.inf:
        return f"{_figure(amount)} ± {_figure(sigma)}"
    decimals = max(0, -math.floor(math.log10(sigma)))
    return f"{amount:.{decimals}f} ± {sigma:.{decimals}f}"


def _figure(value: float | int | str) -> str:
    return f"{value:.3g}" if isinstance(value, float) else str(value)

"""An examination in words for the doctor's page; without Qt."""

from __future__ import annotations

import math
from collections.abc import Mapping
from pathlib import Path

from app.core.i18n import N_, count_text, joined, tr
from app.features.doctor.scene import DoctorScene, FindingScene, State
from tracking.doctor import Examination, Finding, Mended, examine, mend_undoably, undo_mend
from tracking.progress import Progress
from tracking.recording import open_recording

_SMALL_M = 0.005
"""Errors below it are no centimetre."""
_CHECKS: Mapping[str, str] = {
    "camera-moved": N_("whether a camera moved"),
    "cameras-out-of-step": N_("whether one camera is late"),
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
}
"""By their names in the evidence, where that is no word."""
_AMOUNT = ("amount", "sigma", "unit")
_LEFT_OUT = frozenset((*_AMOUNT, "z"))
"""Told together, or for whoever writes programs."""


def examined(place: Path, progress: Progress) -> Examination:
    """Examine a recording as its files are now; on any thread.

    Raises RecordingError, CancelledError.
    """
    with open_recording(place) as recording:
        return examine(recording, progress)


def mended(place: Path, finding: Finding) -> Mended:
    """Mend a finding in the files; on any thread. Raises RecordingError, OutputError."""
    with open_recording(place) as recording:
        return mend_undoably(recording, finding)


def undone(files: Mended) -> tuple[Path, ...]:
    """Take a mend back. Raises RecordingError, OutputError."""
    return undo_mend(files)


def working(text: str = "") -> DoctorScene:
    """While the recording is examined."""
    return DoctorScene(State.WORKING, text or tr("The recording is being checked."))


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
    if examination.checked:
        made = joined(", ", list(map(_check, examination.checked)))
        text += "\n" + tr("Checked: {checks}", checks=made)
    return DoctorScene(State.WELL, text, (), unchecked, mended_last)


def _finding(found: Finding) -> FindingScene:
    return FindingScene(
        code=found.code,
        title=_sentence(tr(found.title)),
        cost=_cost(found.cost_m),
        meaning=_meaning(found.cost_m),
        fix=_sentence(tr(found.fix)),
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


def _sentence(text: str) -> str:
    """With a capital, as a line of its own begins."""
    return text[:1].upper() + text[1:]


def _figures(evidence: Mapping[str, float | int | str]) -> tuple[tuple[str, str], ...]:
    """Names and values that people read; an amount with its uncertainty and unit in one."""
    rows = []
    if "amount" in evidence:
        amount, sigma, unit = (evidence.get(name, "") for name in _AMOUNT)
        said = _figure(amount) if sigma == "" else f"{_figure(amount)} ± {_figure(sigma)}"
        rows.append((tr("Amount"), f"{said} {tr(str(unit))}".strip()))
    for name, value in evidence.items():
        if name not in _LEFT_OUT:
            rows.append((tr(_FIGURES.get(name, name)), _figure(value)))
    return tuple(rows)


def _figure(value: float | int | str) -> str:
    return f"{value:.3g}" if isinstance(value, float) else str(value)

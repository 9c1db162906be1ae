"""A finding mended in the recording's files."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

from tracking.atomic_output import replace_with
from tracking.doctor.finding import Finding, Mend
from tracking.errors import RecordingError
from tracking.geometry import StereoCalibration, write_calibration
from tracking.recording import (
    MANIFEST_NAME,
    Manifest,
    Recording,
    read_manifest,
    write_manifest,
)
from tracking.recording.ground_writer import write_ground

BACKUP = ".bak"
"""After the name of a file as it was before; the newest one is kept."""
_MENDED = "calibration-mended.yaml"
"""Beside files that are of another kind, or several: they stay as they are."""


def mend(recording: Recording, finding: Finding) -> tuple[Path, ...]:
    """Write what a finding says should be; gives the files that were written.

    Each file that is replaced is kept under its name and ".bak".

    Raises:
        RecordingError: it cannot be mended from the pictures, or there is no recording.toml.
        OutputError: a file cannot be written.
    """
    if finding.mend is None:
        raise RecordingError(
            "{code}: the pictures do not say what is right; {fix}",
            code=finding.code,
            fix=finding.fix,
        )
    folder = recording.folder
    if not recording.own_manifest:
        raise RecordingError(
            "{path}: without a {name} there is nothing to mend; set the recording up first",
            path=recording.path,
            name=MANIFEST_NAME,
        )
    told = finding.mend
    manifest = _mended_manifest(read_manifest(folder), told)
    written = []
    if told.ground is not None and told.calibration is None:
        # The rest of the text stays as its writer has it.
        _keep(folder / MANIFEST_NAME)
        write_ground(folder, told.ground)
        return (folder / MANIFEST_NAME,)
    if finding.mend.calibration is not None:
        name = _calibration_name(manifest)
        # First the calibration: a manifest must never name one that is not there.
        written.append(_write_calibration(folder / name, finding.mend.calibration))
        manifest = replace(manifest, calibration=(name,))
    if manifest != read_manifest(folder):
        path = folder / MANIFEST_NAME
        _keep(path)
        write_manifest(folder, manifest)
        written.append(path)
    return tuple(written)


def _mended_manifest(manifest: Manifest, mended: Mend) -> Manifest:
    if mended.ground is not None:
        manifest = replace(manifest, ground=mended.ground)
    if mended.lag is not None:
        manifest = replace(manifest, right_lag=mended.lag)
    if mended.swapped and manifest.right is not None:
        lag = None if manifest.right_lag is None else -manifest.right_lag
        manifest = replace(manifest, left=manifest.right, right=manifest.left, right_lag=lag)
    elif mended.swapped:
        manifest = replace(manifest, first="right" if manifest.first == "left" else "left")
    return manifest


def _calibration_name(manifest: Manifest) -> str:
    """Our own YAML is written anew; files of another kind stay, and one beside them is written."""
    files = manifest.calibration
    ours = len(files) == 1 and Path(files[0]).suffix.lower() in (".yaml", ".yml")
    return files[0] if ours and "/" not in files[0] else _MENDED


def _write_calibration(path: Path, calibration: StereoCalibration) -> Path:
    _keep(path)
    write_calibration(path, calibration)
    return path


def _keep(path: Path) -> None:
    """A copy of the file as it is, if it is there."""
    if path.is_file():
        replace_with(path.with_name(path.name + BACKUP), path.read_bytes())

"""A finding mended in the recording's files."""

from __future__ import annotations

import json
from collections.abc import Mapping
from dataclasses import dataclass, replace
from pathlib import Path

from tracking.atomic_output import replace_with
from tracking.doctor.findings import Finding, Mend
from tracking.errors import RecordingError
from tracking.geometry import StereoCalibration, write_calibration
from tracking.recording import (
    MANIFEST_NAME,
    Manifest,
    Recording,
    read_manifest,
    write_manifest,
)
from tracking.recording.ground_writer import rounded_ground, with_ground, write_ground
from tracking.recording.manifest import manifest_text, parse_manifest
from tracking.recording.manifest_editor import with_values

BACKUP = ".bak"
"""After the name of a file as it was before; the newest one is kept."""
_MENDED = "calibration-mended.yaml"
"""Beside files that are of another kind, or several: they stay as they are."""


@dataclass(frozen=True, slots=True, eq=False)
class Mended:
    """Files that were mended.

    Attributes:
        written: those that were written, in order.
        before, after: their bytes, and those of files beside them that could have been; None: there
            was no such file.
    """

    written: tuple[Path, ...]
    before: Mapping[Path, bytes | None]
    after: Mapping[Path, bytes | None]


def mend_undoably(recording: Recording, finding: Finding) -> Mended:
    """As `mend`, with what `undo_mend` needs."""
    folder = recording.folder
    names = {MANIFEST_NAME, _MENDED}
    if recording.own_manifest:
        names.add(_calibration_name(read_manifest(folder)))
    files = [folder / name for name in sorted(names)]
    before = {path: _content(path) for path in files}
    written = mend(recording, finding)
    return Mended(written, before, {path: _content(path) for path in files})


def undo_mend(mended: Mended) -> tuple[Path, ...]:
    """Bring the files back to what they were; gives those that changed.

    Raises:
        RecordingError: a file is no longer as it was mended; nothing is changed then.
        OutputError: a file cannot be written.
    """
    for path, content in mended.after.items():
        if _content(path) != content:
            raise RecordingError(
                "{path} has changed since it was mended; as it was before it is beside it, with "
                "{ending} after its name",
                path=path,
                ending=BACKUP,
            )
    changed = [path for path in mended.before if mended.before[path] != mended.after[path]]
    for path in changed:
        content = mended.before[path]
        if content is None:
            path.unlink()
        else:
            replace_with(path, content)
    return tuple(changed)


def _content(path: Path) -> bytes | None:
    return path.read_bytes() if path.is_file() else None


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
        _rewrite(folder, manifest, told)
        written.append(path)
    return tuple(written)


def _rewrite(folder: Path, manifest: Manifest, told: Mend) -> None:
    """Write the manifest into its own text; as a whole where that text does not allow it."""
    text = manifest_text(folder)
    changed = with_values(text, _values(manifest, told))
    if told.ground is not None:
        changed = with_ground(changed, rounded_ground(told.ground))
        manifest = replace(manifest, ground=rounded_ground(told.ground))
    path = folder / MANIFEST_NAME
    try:
        kept = parse_manifest(changed, str(path), folder.name) == manifest
    except RecordingError:
        kept = False
    if kept:
        replace_with(path, changed.encode())
    else:
        write_manifest(folder, manifest)


def _values(manifest: Manifest, told: Mend) -> dict[tuple[str, str], str]:
    """What the manifest's text says anew, by table and key."""
    values: dict[tuple[str, str], str] = {}
    both = "stereo" if manifest.layout is not None else "right"
    if told.swapped and manifest.right is not None:
        values["left", "source"] = json.dumps(manifest.left, ensure_ascii=False)
        values["right", "source"] = json.dumps(manifest.right, ensure_ascii=False)
    elif told.swapped:
        values["stereo", "first"] = json.dumps(manifest.first)
    if manifest.right_lag is not None and (told.swapped or told.lag is not None):
        values[both, "lag"] = str(manifest.right_lag)
    if told.calibration is not None:
        values["calibration", "file"] = json.dumps(manifest.calibration[0], ensure_ascii=False)
    return values


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

"""What a session knows of the recording it was made from; the pictures stay where they are."""

from __future__ import annotations

import hashlib
import os
from dataclasses import dataclass, replace
from pathlib import Path, PurePosixPath, PureWindowsPath
from typing import TYPE_CHECKING

from tracking.geometry import says_rough
from tracking.recording import Fingerprint

if TYPE_CHECKING:
    from tracking.recording import Recording


@dataclass(frozen=True, slots=True)
class RecordingReference:
    """The recording of a session.

    Attributes:
        name, fps, frame_count, size (width, height px), is_stereo: of the recording.
        path: the folder that the manifest's paths are relative to, seen from the session's folder,
            with forward slashes.
        manifest, calibration: their text, so that a session explains itself without them.
        own_manifest: whether the manifest was the folder's recording.toml; else it was made up of
            what was found there and what the user said, and stands nowhere but here.
        sources: fingerprints, by which the recording is known again.
    """

    name: str
    path: str
    fps: float
    frame_count: int
    size: tuple[int, int]
    is_stereo: bool
    manifest: str
    own_manifest: bool
    calibration: str
    sources: tuple[Fingerprint, ...]

    @property
    def is_inside(self) -> bool:
        """Whether the path stays in the session's folder: only then it is followed unasked."""
        return stays_inside(self.path)

    @property
    def is_rough(self) -> bool:
        """Whether its metres come from a rough calibration, and may be off by a tenth."""
        return says_rough(self.calibration)

    @property
    def key(self) -> str:
        """One digest over all sources and the manifest: the recording wherever it stands."""
        parts = [f"{part.size_bytes} {part.sha256}" for part in self.sources]
        return hashlib.sha256("\n".join([*parts, self.manifest]).encode()).hexdigest()

    @property
    def footage(self) -> str:
        """What the pictures alone are known by, whatever the recording is called."""
        return " ".join(part.sha256 for part in self.sources)

    def relocated_to(self, recording: Recording, session_folder: Path) -> RecordingReference:
        """The reference by which it is found again as it was opened now.

        Of a recording.toml it goes on to say what the tracks were made with.
        """
        path = relative(recording.folder, session_folder)
        if self.own_manifest and recording.own_manifest:
            return replace(self, path=path)
        return replace(
            self,
            path=path,
            manifest=recording.manifest_text,
            own_manifest=recording.own_manifest,
        )


def refer_to(recording: Recording, session_folder: Path) -> RecordingReference:
    """The reference a session in that folder holds to a recording."""
    return RecordingReference(
        name=_writable(recording.name),
        path=relative(recording.folder, session_folder),
        fps=float(recording.fps),
        frame_count=int(recording.frame_count),
        size=(int(recording.size[0]), int(recording.size[1])),
        is_stereo=bool(recording.is_stereo),
        manifest=recording.manifest_text,
        own_manifest=bool(recording.own_manifest),
        calibration=recording.calibration_text,
        sources=tuple(
            replace(one, source=_writable(one.source)) for one in recording.fingerprints()
        ),
    )


def stays_inside(path: str) -> bool:
    """Whether a path of a file is relative on every system and does not climb out."""
    parts = PurePosixPath(path.replace("\\", "/")).parts
    absolute = PurePosixPath(path).is_absolute() or PureWindowsPath(path).drive
    return not (absolute or ".." in parts or path.startswith(("/", "\\", "~")))


def relative(path: Path, folder: Path) -> str:
    """The path as seen from a folder, with forward slashes."""
    try:
        seen = Path(os.path.relpath(path.resolve(), folder.resolve()))
    except ValueError:  # another drive: there is no relative path
        seen = path.resolve()
    return _writable(seen.as_posix())


def _writable(text: str) -> str:
    """The text as a file can hold it: bytes of a name that are no UTF-8 become question marks."""
    return text.encode("utf-8", "replace").decode("utf-8")

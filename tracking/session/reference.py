"""What a session knows of the recording it was made from; the pictures stay where they are."""

from __future__ import annotations

import hashlib
import os
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from pathlib import Path, PurePosixPath, PureWindowsPath
from typing import Protocol

from tracking.errors import TrackwrightError
from tracking.session.errors import RecordingMissing

_PARENTS_SEARCHED = 3


class Footage(Protocol):
    """What is asked of a recording; `tracking.recording.Recording` is one."""

    @property
    def path(self) -> Path:
        """The folder or file it was opened from."""

    @property
    def name(self) -> str:
        """As people call it."""

    @property
    def fps(self) -> float:
        """Frames a second."""

    @property
    def frame_count(self) -> int:
        """How many frames there are."""

    @property
    def size(self) -> tuple[int, int]:
        """Width and height in pixels."""

    @property
    def is_stereo(self) -> bool:
        """Whether there are two eyes."""

    @property
    def manifest_text(self) -> str:
        """The manifest as written."""

    @property
    def calibration_text(self) -> str:
        """The calibration as written; "" where there is none."""

    def fingerprints(self) -> Sequence[Fingerprint]:
        """One of each source."""


class Fingerprint(Protocol):
    """What tells one source from another; `tracking.recording`'s is one."""

    @property
    def source(self) -> str:
        """The source as the manifest names it."""

    @property
    def size_bytes(self) -> int:
        """Its size."""

    @property
    def sha256(self) -> str:
        """Hash of its first and last MiB."""


@dataclass(frozen=True, slots=True)
class SourceFingerprint:
    """The fingerprint of a source, as it stands in a session file."""

    source: str
    size_bytes: int
    sha256: str


@dataclass(frozen=True, slots=True)
class RecordingReference:
    """The recording of a session.

    Attributes:
        name, fps, frame_count, size (width, height px), is_stereo: of the recording.
        path: where it stands, relative to the session's folder, with forward slashes.
        manifest, calibration: their text, so that a session explains itself without them.
        sources: fingerprints, by which the recording is known again.
    """

    name: str
    path: str
    fps: float
    frame_count: int
    size: tuple[int, int]
    is_stereo: bool
    manifest: str
    calibration: str
    sources: tuple[SourceFingerprint, ...]

    @property
    def is_inside(self) -> bool:
        """Whether the path stays in the session's folder: only then it is followed unasked."""
        return stays_inside(self.path)

    @property
    def key(self) -> str:
        """One digest over all sources: the recording's identity wherever it stands."""
        parts = "\n".join(f"{part.size_bytes} {part.sha256}" for part in self.sources)
        return hashlib.sha256(parts.encode()).hexdigest()


def refer_to(recording: Footage, session_folder: Path) -> RecordingReference:
    """The reference a session in that folder holds to a recording."""
    return RecordingReference(
        name=recording.name,
        path=relative(recording.path, session_folder),
        fps=float(recording.fps),
        frame_count=int(recording.frame_count),
        size=(int(recording.size[0]), int(recording.size[1])),
        is_stereo=bool(recording.is_stereo),
        manifest=recording.manifest_text,
        calibration=recording.calibration_text,
        sources=_plain(recording.fingerprints()),
    )


def fingerprints_at(place: Path) -> tuple[SourceFingerprint, ...]:
    """The fingerprints of the recording at a place. Raises RecordingError where there is none."""
    # Imported here: the decoders behind it take longer to load than a session to open.
    from tracking.recording import open_recording

    with open_recording(place) as recording:
        return _plain(recording.fingerprints())


def stays_inside(path: str) -> bool:
    """Whether a path of a file is relative on every system and does not climb out."""
    parts = PurePosixPath(path.replace("\\", "/")).parts
    absolute = PurePosixPath(path).is_absolute() or PureWindowsPath(path).drive
    return not (absolute or ".." in parts or path.startswith(("/", "\\", "~")))


def locate(
    reference: RecordingReference,
    session_folder: Path,
    search: Sequence[Path] = (),
    known: Path | None = None,
    *,
    allow_outside: bool = False,
) -> Path:
    """Where the recording stands now, checked against the fingerprints.

    Looks, in this order: in the places the user named (search: the recording itself or a folder
    it stands in), where this user had it last (known), at the session's own path (where it climbs
    out of the session's folder only if allow_outside), and under the same name in the session's
    folder and the three above it.

    Raises RecordingMissing, which says where it was and how to name its place.
    """
    places = [place for named in search for place in (named, named / _name(reference))]
    places += [known] if known is not None else []
    if reference.is_inside or allow_outside:
        places.append(session_folder / reference.path)
    others = []
    for place in dict.fromkeys([*places, *_same_name(reference, session_folder)]):
        if place.exists():
            if _is_it(reference, place):
                return Path(os.path.normpath(place))
            others.append(place)
    raise RecordingMissing(_missing(reference, others))


def _is_it(reference: RecordingReference, place: Path) -> bool:
    """Whether the recording with these fingerprints stands there, whatever its files are called."""
    try:
        found = fingerprints_at(place)
    except TrackwrightError:
        return False
    wanted = [(part.size_bytes, part.sha256) for part in reference.sources]
    return wanted == [(part.size_bytes, part.sha256) for part in found]


def _missing(reference: RecordingReference, others: Sequence[Path]) -> str:
    found = f"; what stands at {others[0]} is another one" if others else ""
    if reference.is_inside:
        was = f"was at {reference.path}, beside the session, and is gone"
    else:
        was = f"is at {reference.path}, outside the session's folder, and is not opened unasked"
    return f'recording "{reference.name}" {was}{found}; name its place (--recording PATH)'


def _same_name(reference: RecordingReference, session_folder: Path) -> Iterator[Path]:
    """The name is a single part of a path, so these places are ours, not the file's."""
    name = _name(reference)
    folder = session_folder.resolve()
    for parent in [folder, *folder.parents][: 1 + _PARENTS_SEARCHED]:
        if stays_inside(name) and name not in ("", "."):
            yield parent / name


def _name(reference: RecordingReference) -> str:
    return PurePosixPath(reference.path.replace("\\", "/")).name


def _plain(fingerprints: Sequence[Fingerprint]) -> tuple[SourceFingerprint, ...]:
    return tuple(
        SourceFingerprint(part.source, int(part.size_bytes), part.sha256) for part in fingerprints
    )


def relative(path: Path, folder: Path) -> str:
    """The path as seen from a folder, with forward slashes."""
    try:
        return Path(os.path.relpath(path.resolve(), folder.resolve())).as_posix()
    except ValueError:  # another drive: there is no relative path
        return path.resolve().as_posix()

"""A session's recording: where it stands now, opened as the session saw it."""

from __future__ import annotations

import os
from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass, fields
from functools import partial
from pathlib import Path, PurePosixPath
from typing import TYPE_CHECKING

from tracking.errors import RecordingError, TrackwrightError
from tracking.session.errors import RecordingMissing
from tracking.session.reference import RecordingReference, stays_inside
from tracking.translation import Message, joined, msg

if TYPE_CHECKING:
    from tracking.recording import Recording

# The decoders behind `tracking.recording` take longer to load than a session to open: they are
# imported where a recording is opened.

_PARENTS_SEARCHED = 3
_MANIFEST = "recording.toml"


@dataclass(frozen=True, slots=True)
class FoundRecording:
    """A recording that was found.

    Attributes:
        recording: opened.
        place: where it was looked for with success; looked for there again, it is found again.
        notes: what the user should be told, a line each.
    """

    recording: Recording
    place: Path
    notes: tuple[Message, ...]


def find_recording(
    reference: RecordingReference,
    session_folder: Path,
    search: Sequence[Path] = (),
    known: Path | None = None,
    *,
    allow_outside: bool = False,
) -> FoundRecording:
    """Find a session's recording, check it against the fingerprints and open it.

    Looks, in this order: in the places the user named (search: the recording itself or a folder
    it stands in), at the session's own path (where it climbs out of the session's folder only if
    allow_outside) and under the same name in the session's folder, where this user had it last
    (known), and under the same name in the three folders above. So a session that is copied
    together with its recording opens the copy.

    A folder's own recording.toml counts as it is now; where that is not what the session was made
    with, a note says so. Anything else is opened by the manifest the session keeps. A manifest
    that leads out of its folder is followed only if allow_outside, and at the known place, where
    this user had the very same one open before.

    Raises RecordingMissing, which says where it was and how to name its place.
    """
    problems: list[Message] = []
    trusted = None if known is None else _plain(known)
    for place in _places(reference, session_folder, search, trusted, allow_outside):
        recording, failures = _opened(reference, place, allow_outside, place == trusted)
        if recording is not None:
            moved = _moved(reference, session_folder, search, place)
            return FoundRecording(
                recording, place, (*failures, *moved, *_changes(reference, recording))
            )
        problems += failures
    raise _missing(reference, problems).advising("name its place", option="--recording PATH")


def _opened(
    reference: RecordingReference, place: Path, allow_outside: bool, trusted: bool
) -> tuple[Recording | None, list[Message]]:
    """The session's recording at a place, None where it is not there; and what failed before."""
    failures: list[Message] = []
    for way in _ways(reference, place, allow_outside, trusted):
        try:
            recording = way()
        except TrackwrightError as why:
            failures.append(why.message)
            continue
        if _is_it(reference, recording):
            return recording, failures
        recording.close()
        failures.append(msg("what stands at {place} is another one", place=place))
    return None, failures


def _places(
    reference: RecordingReference,
    session_folder: Path,
    search: Sequence[Path],
    known: Path | None,
    allow_outside: bool,
) -> list[Path]:
    """Where to look, in order, each place once; only what exists."""
    name = _name(reference)
    places = [place for named in search for place in _named(named, name)]
    if reference.is_inside or allow_outside:
        places.append(session_folder / reference.path)
    around = _around(reference, session_folder, name)
    places += around[:1]
    places += [known] if known is not None else []
    places += around[1:]
    return [place for place in dict.fromkeys(map(_plain, places)) if place.exists()]


def _named(place: Path, name: str) -> tuple[Path, ...]:
    """What a user who names a place may mean."""
    if place.name == _MANIFEST:
        return (place.parent,)
    return (place, place / name) if name else (place,)


def _around(reference: RecordingReference, session_folder: Path, name: str) -> Sequence[Path]:
    """Places that the session's own folder, first, and those above it suggest.

    Only single parts of paths are taken from the file, so none of these places is its choice.
    """
    folder = session_folder.resolve()
    near = [folder, *folder.parents][: 1 + _PARENTS_SEARCHED]
    if name:
        return [parent / name for parent in near]
    return near if _lies_flat(reference) else ()


def _lies_flat(reference: RecordingReference) -> bool:
    """Whether all its files stand in one folder, not below it."""
    from tracking.recording import parse_manifest

    try:
        manifest = parse_manifest(reference.manifest, _MANIFEST, "")
    except RecordingError:
        return False
    cameras = filter(None, (manifest.left, manifest.right, manifest.depth))
    files = [*cameras, *manifest.calibration]
    return all(stays_inside(file) and len(PurePosixPath(file).parts) == 1 for file in files)


def _ways(
    reference: RecordingReference, place: Path, allow_outside: bool, trusted: bool
) -> Sequence[Callable[[], Recording]]:
    """The ways to open what stands at a place, the likeliest first."""
    as_kept = partial(_open_as_kept, reference, place, allow_outside or trusted)
    if not (place / _MANIFEST).is_file():
        return (as_kept,)
    as_it_is = partial(_open_as_it_is, reference, place, allow_outside, trusted)
    return (as_it_is, as_kept) if reference.own_manifest else (as_kept, as_it_is)


def _open_as_kept(reference: RecordingReference, place: Path, allow_outside: bool) -> Recording:
    from tracking.recording import OpenOptions, open_from_manifest

    options = OpenOptions(allow_outside=allow_outside)
    return open_from_manifest(place, reference.manifest, options)


def _open_as_it_is(
    reference: RecordingReference, place: Path, allow_outside: bool, trusted: bool
) -> Recording:
    from tracking.recording import OpenOptions, manifest_text, open_recording

    same = trusted and manifest_text(place) == reference.manifest
    return open_recording(place, OpenOptions(allow_outside=allow_outside or same))


def _is_it(reference: RecordingReference, recording: Recording) -> bool:
    """Whether it has the session's fingerprints, whatever its files are called."""
    wanted = [(part.size_bytes, part.sha256) for part in reference.sources]
    return wanted == [(part.size_bytes, part.sha256) for part in recording.fingerprints()]


def _moved(
    reference: RecordingReference, session_folder: Path, search: Sequence[Path], place: Path
) -> Iterator[Message]:
    """Where it was found, if neither where the session says nor where the user does."""
    expected = [session_folder / reference.path]
    expected += [named for asked in search for named in _named(asked, _name(reference))]
    # The file's own path is only compared, never looked at: it may lead to another machine.
    if os.path.abspath(place) not in map(os.path.abspath, expected):  # noqa: PTH100
        yield msg(
            'recording "{name}" has moved; it was found at {place}',
            name=reference.name,
            place=place,
        )


def _changes(reference: RecordingReference, recording: Recording) -> Iterator[Message]:
    """What is not as it was when the session was made, in words."""
    if recording.own_manifest:
        changed = _changed_parts(reference.manifest, recording.manifest_text)
        if changed:
            yield (
                msg(
                    "{folder} has changed since the tracks were made ({changed}); it "
                    "counts as it is now",
                    folder=recording.folder / _MANIFEST,
                    changed=joined(", ", changed),
                )
            )
    if recording.calibration_text != reference.calibration:
        yield msg("the calibration has changed since the tracks were made; it counts as it is now")


def _changed_parts(then: str, now: str) -> Sequence[str]:
    """What two manifests say differently."""
    from tracking.recording import parse_manifest

    try:
        before, after = (parse_manifest(text, _MANIFEST, "") for text in (then, now))
    except RecordingError:
        return (msg("all of it"),)
    names = [field.name for field in fields(before)]
    return [name for name in names if getattr(before, name) != getattr(after, name)]


def _missing(reference: RecordingReference, problems: Sequence[Message]) -> RecordingMissing:
    if not reference.is_inside:
        was = msg(
            'recording "{name}" is at {path}, outside the session\'s folder: for safety it is '
            "opened only where you name it",
            name=reference.name,
            path=reference.path,
        )
    elif problems:
        was = msg(
            'recording "{name}" was at {path}, beside the session',
            name=reference.name,
            path=reference.path,
        )
    else:
        was = msg(
            'recording "{name}" was at {path}, beside the session, and is gone',
            name=reference.name,
            path=reference.path,
        )
    return RecordingMissing(joined("; ", (was, *problems[:1])))


def _name(reference: RecordingReference) -> str:
    """The recording's own name in its folder; "" where it has none that is safe to look for."""
    name = PurePosixPath(reference.path.replace("\\", "/")).name
    return name if stays_inside(name) and name != "." else ""


def _plain(place: Path) -> Path:
    return Path(os.path.normpath(place))

"""Opening whatever a recording may be."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

from tracking.errors import RecordingError
from tracking.recording.bags.bag_pictures import BagDepth, BagPictures, is_bag, open_bag
from tracking.recording.depth_pictures import DepthSource, check_fits
from tracking.recording.image_pairs import ImagePairs, OneCamera, Side, TwoSources, both_cameras
from tracking.recording.locate import Located, from_manifest, locate
from tracking.recording.manifest import MANIFEST_NAME
from tracking.recording.options import OpenOptions
from tracking.recording.pictures import PictureSource
from tracking.recording.places import (
    is_pattern,
    open_depth,
    open_pictures,
    place_inside,
)
from tracking.recording.recording import Recording
from tracking.recording.recording_calibration import read_calibrated
from tracking.recording.tar_pictures import TarDepth, TarImages, is_tar
from tracking.translation import msg


def open_recording(path: Path, options: OpenOptions | None = None) -> Recording:
    """Open a recording.

    Args:
        path: a folder with recording.toml, a bare video, an image folder, a KITTI sequence
            folder, or a folder with left and right videos or image folders. With `options.left`
            given it only names the recording.
        options: what to take instead of what the recording says.

    Raises:
        RecordingError: missing, unreadable, empty, or cameras that do not belong together.
        CalibrationError: the calibration is unreadable or does not fit the pictures.
    """
    options = options or OpenOptions()
    return _open(locate(path, options), options)


def open_from_manifest(place: Path, text: str, options: OpenOptions | None = None) -> Recording:
    """Open a recording whose manifest was kept elsewhere, as in a session.

    Args:
        place: what the manifest's paths are relative to (`Recording.folder`); or the left (or
            only) camera's pictures, by whatever name they have now, with all else beside them.
        text: the manifest (`Recording.manifest_text`).
        options: only `allow_outside` counts.

    Raises:
        RecordingError, CalibrationError: as `open_recording`.
    """
    return _open(from_manifest(place, text), options or OpenOptions())


def _open(located: Located, options: OpenOptions) -> Recording:
    inside = located.trusted or options.allow_outside
    cameras = _open_sources(located, inside)
    files = list(options.calibration) or [
        place_inside(located.folder, file, inside) for file in located.manifest.calibration
    ]
    depth = _open_depth(located, cameras.sources[0], inside)
    if depth is not None:
        check_fits(depth, cameras.sources[0])
    calibrated = read_calibrated(
        files,
        cameras.size,
        cameras.is_stereo,
        located.manifest.ground,
        depth=depth is not None,
        topics=located.manifest.topics,
    )
    return Recording(replace(located, trusted=inside), cameras, calibrated, depth, files)


def _open_depth(located: Located, left: PictureSource, allow_outside: bool) -> DepthSource | None:
    manifest = located.manifest
    if manifest.depth is None:
        return None
    place = place_inside(located.folder, manifest.depth, allow_outside)
    if is_tar(place):
        folder = manifest.topics[2] or "depth"
        return TarDepth(place, folder, manifest.depth, manifest.depth_scale_m)
    if is_bag(place):
        bag = open_bag(place, manifest.topics)
        return BagDepth(bag, manifest.depth, manifest.depth_scale_m, left.stamps_ns)
    return open_depth(place, manifest.depth, manifest.depth_scale_m)


def _open_sources(located: Located, allow_outside: bool) -> ImagePairs:
    manifest = located.manifest
    left = _opened(located, manifest.left, "left", allow_outside)
    if manifest.layout is not None:
        return both_cameras(left, manifest.layout, manifest.first)
    if manifest.right is None:
        return OneCamera(left)
    return TwoSources(left, _opened(located, manifest.right, "right", allow_outside))


def _opened(located: Located, source: str, side: Side, allow_outside: bool) -> PictureSource:
    """The pictures of a camera."""
    place = place_inside(located.folder, source, allow_outside)
    if located.own and (lacking := _lacking(place)):
        instead = msg(", or leave [right] out for one camera") if side == "right" else ""
        raise RecordingError(
            "{folder}: {called} is {lacking}: {place}",
            "put it there{instead}",
            folder=located.folder / MANIFEST_NAME,
            called=_called(located, side),
            lacking=lacking,
            place=place,
            instead=instead,
        )
    if is_tar(place):
        topic = located.manifest.topics[side == "right"]
        return TarImages(place, topic or side, source)
    if is_bag(place):
        return BagPictures(open_bag(place, located.manifest.topics), source, right=side == "right")
    folders = (located.folder, place.parent) if allow_outside else (located.folder,)
    return open_pictures(place, source, folders)


def _called(located: Located, side: Side) -> str:
    """What a source shows, in the words of its manifest."""
    if located.manifest.layout is not None:
        return msg("the video of both cameras")
    return (
        msg("the video") if located.manifest.right is None else msg("the {side} camera", side=side)
    )


def _lacking(place: Path) -> str:
    """What is wrong with a file that recording.toml names, before anything is read; "": nothing."""
    if not place.exists():
        return "" if is_pattern(str(place)) else msg("missing, no such video")
    return "" if place.is_dir() or place.stat().st_size else "empty"

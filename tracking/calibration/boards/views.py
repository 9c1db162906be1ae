"""Images of a board: pictures paired by name, or sharp and varied frames chosen from video."""

from __future__ import annotations

import re
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from pathlib import Path

import cv2
import numpy as np

from tracking.calibration.boards.board import Board
from tracking.calibration.boards.detection import (
    BoardView,
    GrayImage,
    find_board,
    same_way_round,
)
from tracking.calibration.boards.sharpness import sharpness
from tracking.errors import CalibrationError, RecordingError
from tracking.progress import Progress
from tracking.recording.frame import Image
from tracking.recording.images import image_files
from tracking.recording.pictures import PictureSource
from tracking.recording.places import is_pattern, open_pictures
from tracking.recording.spread_frames import spread_frames
from tracking.recording.video import VideoSource
from tracking.translation import Message, msg

_MOST_PICTURES = 400
_LOOKED_AT = 240
"""Frames of a video in which the board is looked for, evenly over its length."""
_KEPT = 40
"""Views of a video that are kept: more change nothing but the time it takes."""
_SHARPNESS_SHARE = 0.5
"""Of the usual sharpness of the views: less of it is motion blur."""
_BLURRED_SHARE, _SHARP_QUANTILE = 0.4, 0.9
"""Of the sharpness of the sharpest tenth: views with less are told to be blurred."""
_DIGITS = re.compile(r"\d+")


@dataclass(frozen=True, slots=True, eq=False)
class PairedView:
    """A board as seen in one image, or at one instant by both cameras.

    Attributes:
        name: of the picture, or the number of the frame. left, right: None where not found, or
            where there is no right camera. sharpness: of the left image's edges, the same
            for boards near and far.
    """

    name: str
    left: BoardView
    right: BoardView | None
    sharpness: float


@dataclass(frozen=True, slots=True, eq=False)
class Views:
    """What was found in all images.

    Attributes:
        views: with the board found, in both images where there are two cameras.
        size: width and height of the images in px. missed: names of those without a board.
        unpaired: names of pictures without a partner. notes: what else is odd, in words.
    """

    views: tuple[PairedView, ...]
    size: tuple[int, int]
    missed: tuple[str, ...]
    unpaired: tuple[str, ...]
    notes: tuple[Message, ...]


@dataclass(frozen=True, slots=True)
class _Instant:
    """Images of one instant; left None: not readable."""

    name: str
    left: GrayImage | None
    right: GrayImage | None


def find_views(left: str, right: str | None, board: Board, progress: Progress) -> Views:
    """The board in all pictures, or in a choice of frames of a video.

    Args:
        left, right: a video, an image folder or a pattern such as left/*.png.

    Raises:
        RecordingError: nothing is there, or it cannot be read.
        CalibrationError: pictures without partners, or of several sizes.
    """
    sides = [_pictures(name) for name in (left, right) if name is not None]
    is_video = any(isinstance(side, VideoSource) for side in sides)
    try:
        sizes = {side.size for side in sides if isinstance(side, VideoSource)}
        videos = sum(isinstance(side, VideoSource) for side in sides)
        if is_video and (len(sizes) != 1 or videos < len(sides)):
            raise CalibrationError(
                "calibration: {left} and {right} are not two videos of one size; give two videos, "
                "or two sets of pictures",
                left=left,
                right=right,
            )
        if is_video:
            instants, total = _frames(sides), _LOOKED_AT
            unpaired: tuple[str, ...] = ()
        else:
            paired, unpaired = _pairs([side for side in sides if isinstance(side, list)])
            instants, total = _read(paired), len(paired)
        # A video has more views than are needed, and most of its frames may have no board.
        found = _look(instants, board, progress, (total, not is_video))
    finally:
        for side in sides:
            if isinstance(side, VideoSource):
                side.close()
    return _chosen(found, unpaired) if is_video else Views(*found, unpaired, ())


def first_images(named: str, count: int = 12) -> list[GrayImage]:
    """Some images of a source, evenly over it, to learn from what is on the board."""
    source = _pictures(named)
    if isinstance(source, VideoSource):
        images = [_gray(source.read(at)) for at in spread_frames(source.frame_count, count)]
        source.close()
        return images
    read = _read([(file,) for file in source[:count]])
    return [instant.left for instant in read if instant.left is not None]


def _pictures(named: str) -> VideoSource | list[Path]:
    path = Path(named)
    if is_pattern(path.name) and not path.exists():
        files = image_files([file for file in path.parent.glob(path.name) if file.is_file()])
    elif path.is_dir():
        files = image_files([file for file in path.iterdir() if file.is_file()])
    else:
        source: PictureSource = open_pictures(path, path.name)
        if isinstance(source, VideoSource):
            return source
        files = list(source.files)
    if not files:
        raise RecordingError("{name}: no images found; check the pattern or the folder", name=named)
    if len(files) > _MOST_PICTURES:
        raise CalibrationError(
            "{name}: {count} pictures, at most {most} are looked at; give fewer, or a video",
            name=named,
            count=len(files),
            most=_MOST_PICTURES,
        )
    return files


def _pairs(sides: Sequence[list[Path]]) -> tuple[list[tuple[Path, ...]], tuple[str, ...]]:
    """Pictures of the same number, or where there are none in order; names without a partner."""
    if len(sides) == 1:
        return [(file,) for file in sides[0]], ()
    keyed = [{_number(file): file for file in side} for side in sides]
    if all(len(by) == len(side) and "" not in by for by, side in zip(keyed, sides, strict=True)):
        both = [key for key in keyed[0] if key in keyed[1]]
        alone = [file.name for by in keyed for key, file in by.items() if key not in both]
        pairs: list[tuple[Path, ...]] = [(keyed[0][key], keyed[1][key]) for key in both]
    elif len(sides[0]) == len(sides[1]):
        pairs, alone = list(zip(*sides, strict=True)), []
    else:
        raise CalibrationError(
            "calibration: {left} left and {right} right pictures whose names have no numbers; give "
            "as many of each, or number them alike",
            left=len(sides[0]),
            right=len(sides[1]),
        )
    if not pairs:
        raise CalibrationError(
            "calibration: no left picture has a right one of the same number; number them alike, "
            "as left01.png and right01.png"
        )
    return pairs, tuple(alone)


def _number(file: Path) -> str:
    digits = _DIGITS.findall(file.stem)
    return str(int(digits[-1])) if digits else ""


def _read(pairs: Sequence[tuple[Path, ...]]) -> Iterator[_Instant]:
    for files in pairs:
        found = [_read_gray(file) for file in files]
        images = [image for image in found if image is not None]
        if len(images) < len(found):
            yield _Instant(files[0].name, None, None)
            continue
        yield _Instant(files[0].name, images[0], images[1] if len(images) > 1 else None)


def _read_gray(file: Path) -> GrayImage | None:
    image = cv2.imread(str(file), cv2.IMREAD_GRAYSCALE)
    return None if image is None else np.asarray(image, np.uint8)


def _gray(image: Image) -> GrayImage:
    return np.asarray(cv2.cvtColor(image, cv2.COLOR_BGR2GRAY), np.uint8)


def _frames(sides: Sequence[VideoSource | list[Path]]) -> Iterator[_Instant]:
    videos = [side for side in sides if isinstance(side, VideoSource)]
    count = min(video.frame_count for video in videos)
    for number in spread_frames(count, _LOOKED_AT):
        gray = [_gray(video.read(number)) for video in videos]
        yield _Instant(str(number), gray[0], gray[1] if len(gray) > 1 else None)


def _look(
    instants: Iterator[_Instant], board: Board, progress: Progress, asked: tuple[int, bool]
) -> tuple[tuple[PairedView, ...], tuple[int, int], tuple[str, ...]]:
    found: list[PairedView] = []
    missed: list[str] = []
    size: tuple[int, int] | None = None
    total, thorough = asked
    for done, instant in enumerate(instants):
        for image in (instant.left, instant.right):
            size = _same_size(size, image, instant.name) if image is not None else size
        view = _view(instant, board, thorough)
        if view is None:
            missed.append(instant.name)
        else:
            found.append(view)
        progress(min(done + 1, total), total)
    return tuple(found), size or (0, 0), tuple(missed)


def _same_size(size: tuple[int, int] | None, image: GrayImage, name: str) -> tuple[int, int]:
    own = image.shape[1], image.shape[0]
    if size not in (None, own):
        raise CalibrationError(
            "{name}: {width} x {height} px, unlike the pictures before it; give pictures of one "
            "size",
            name=name,
            width=own[0],
            height=own[1],
        )
    return own


def _view(instant: _Instant, board: Board, thorough: bool) -> PairedView | None:
    if instant.left is None:
        return None
    left = find_board(instant.left, board, thorough=thorough)
    if left is None:
        return None
    seen_sharp = sharpness(instant.left, left)
    if instant.right is None:
        return PairedView(instant.name, left, None, seen_sharp)
    right = find_board(instant.right, board, thorough=thorough)
    if right is None:
        return None
    if board.kind in ("chessboard", "circles"):
        right = same_way_round(left, right)
    both = np.intersect1d(left.point, right.point)
    if len(both) < min(len(left), len(right), 6):
        return None
    return PairedView(instant.name, left.only(both), right.only(both), seen_sharp)


def blurred_views(views: Sequence[PairedView]) -> tuple[str, ...]:
    """Names of the views that are much less sharp than the sharpest ones."""
    if not views:
        return ()
    sharp = float(np.quantile([view.sharpness for view in views], _SHARP_QUANTILE))
    return tuple(view.name for view in views if view.sharpness < _BLURRED_SHARE * sharp)


def _chosen(
    found: tuple[tuple[PairedView, ...], tuple[int, int], tuple[str, ...]],
    unpaired: tuple[str, ...],
) -> Views:
    """Of a video: the sharp views, and of these the most varied ones."""
    views, size, missed = found
    if not views:
        return Views((), size, missed, unpaired, ())
    usual = float(np.median([view.sharpness for view in views]))
    sharp = [view for view in views if view.sharpness >= _SHARPNESS_SHARE * usual]
    looks = np.array([_pose_signs(view.left, size) for view in sharp])
    kept = [int(np.argmax([view.sharpness for view in sharp]))]
    apart = np.full(len(sharp), np.inf)
    while len(kept) < min(_KEPT, len(sharp)):
        apart = np.minimum(apart, np.hypot.reduce(looks - looks[kept[-1]], axis=1))
        kept.append(int(apart.argmax()))
    note = msg(
        "{kept} of {found} frames with the board are used: sharp ones, as varied as there are",
        kept=len(kept),
        found=len(views),
    )
    return Views(tuple(sharp[row] for row in sorted(kept)), size, missed, unpaired, (note,))


def _pose_signs(view: BoardView, size: tuple[int, int]) -> np.ndarray:
    """(5,) where a board is in the image, how large, and how it is turned; each about 0 to 1."""
    middle = view.pixel.mean(axis=0) / size
    spread = np.cov((view.pixel / max(size)).T)
    scale = np.sqrt(np.sqrt(max(float(np.linalg.det(spread)), 0.0))) * 3
    narrow = spread[0, 0] / max(spread[0, 0] + spread[1, 1], 1e-9)
    skew = spread[0, 1] / max(spread[0, 0] + spread[1, 1], 1e-9)
    return np.array([*middle, scale, narrow, skew])

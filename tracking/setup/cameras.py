"""What two files, or one, show: a pair of cameras, which is left, one camera, both in one image."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path

import numpy as np

from tracking.calibration.rough import MatchedViews, RelativePose, match_images, pose_of_matches
from tracking.errors import RecordingError
from tracking.recording import open_recording
from tracking.recording.frame import Image
from tracking.recording.image_pairs import Layout
from tracking.recording.interleaved_video import field_of
from tracking.recording.pictures import PictureSource
from tracking.recording.places import open_pictures
from tracking.setup.files import is_container
from tracking.setup.pair_names import pair_by_name
from tracking.translation import N_, Message, joined, msg

_LOOKS = 5
"""Instants at which the cameras' images are compared."""
_SAME_SCENE = 40
"""Matched points on which both views agree, over all looks: fewer are by chance."""
_SURELY_SAME = 400
"""With fewer it is looked whether one is mirrored, which many agree on then."""
_SURELY_LEFT = 3.0
"""The right camera stands that many times more to the side than above or behind the left one."""
_LEAST_SHIFT = 3.0
"""Images of cameras that look the same way are shifted so much more along rows than across."""
_SAME_SIZE = 0.6
"""Of the matches of two whole views, those that the halves of one image have at least."""
_TURNED_DEG, _UPSIDE_DOWN_DEG = 45.0, 150.0
_DARK = 12
"""Mean grey level of a black image."""
_DARK_LOOKS = (1, 2, 5, 10, 20, 50, 100, 200)
"""Frames at which it is looked whether the image is still black."""
_LENGTHS_DIFFER = 0.02
_BY_TURNS: tuple[Layout, ...] = ("row-interleaved", "frame-sequential")
_BY_TURNS_RATIO, _LEAST_APART_PX = 1.15, 1.0
"""Neighbours of two cameras differ so much more than those of one, which differ less the nearer
they are; and two cameras see the scene so far apart. Lamps that flicker do not."""
_NOISE = 0.5
"""Grey levels by which still images differ."""
_LAYOUT_WORDS: Mapping[Layout, str] = {
    "side-by-side": N_("side by side"),
    "top-bottom": N_("one above the other"),
    "row-interleaved": N_("rows by turns"),
    "frame-sequential": N_("images by turns"),
}


@dataclass(frozen=True, slots=True)
class CameraFindings:
    """What was found of the cameras' files.

    Attributes:
        left, right: files; right None: one camera, or both in `left`.
        layout: how both lie in one image; None: one camera an image.
        left_first: in one image that holds both, the left camera is on the left or at the top.
        swapped: the files were given, or are named, the other way round.
        same_scene: both show one place; None: there is but one camera.
        notes: what was found, in words; doubts: what is likely wrong.
    """

    left: Path
    right: Path | None = None
    layout: Layout | None = None
    left_first: bool = True
    swapped: bool = False
    same_scene: bool | None = None
    notes: tuple[Message, ...] = ()
    doubts: tuple[Message, ...] = ()


def find_cameras(left: Path, right: Path | None) -> CameraFindings:
    """Look into one file, or into two that may be a pair.

    Args:
        left, right: videos, image folders or patterns; which of the two is left is found.

    Raises:
        RecordingError: a file cannot be read.
    """
    if right is None and is_container(left):
        return _of_container(left)
    source = open_pictures(left, left.name)
    try:
        if right is None:
            return _one_file(left, source)
        other = open_pictures(right, right.name)
        try:
            return _two_files(left, right, source, other)
        finally:
            other.close()
    finally:
        source.close()


def _of_container(path: Path) -> CameraFindings:
    """The cameras that a bag or a tar says it holds."""
    with open_recording(path) as recording:
        note = (
            msg("{name} holds both cameras", name=path.name)
            if recording.is_stereo
            else msg("{name} holds one camera and depth", name=path.name)
            if recording.has_depth
            else msg("{name} is of one camera", name=path.name)
        )
        right = path if recording.is_stereo else None
        same_scene = True if recording.is_stereo else None
        return CameraFindings(path, right, same_scene=same_scene, notes=(note,))


def _two_files(
    left: Path, right: Path, source: PictureSource, other: PictureSource
) -> CameraFindings:
    _check_sizes(source, other)
    notes, doubts = _rates_and_lengths(source, other)
    count = min(source.frame_count, other.frame_count)
    views = [(source.read(number), other.read(number)) for number in _numbers(count)]
    notes += _black(source, other)
    matched = match_images(views)
    found = pose_of_matches(matched)
    if found is None or found.agreeing < _SURELY_SAME:
        unlike = _unlike(left, right, views, found, (*notes,), (*doubts,))
        if unlike is not None:
            return unlike
        assert found is not None, "no matches are unlike"
    turned = _turned(source, other, found.roll_deg)
    if turned is not None:
        doubts = [*doubts, turned]
        return CameraFindings(left, right, same_scene=True, notes=(*notes,), doubts=(*doubts,))
    swapped, note, doubted = _sides(left, right, (source.name, other.name), found)
    files = (right, left) if swapped else (left, right)
    notes, doubts = [*notes, note], [*doubts, *doubted]
    return CameraFindings(
        *files, swapped=swapped, same_scene=True, notes=(*notes,), doubts=(*doubts,)
    )


def _turned(source: PictureSource, other: PictureSource, turn_deg: float) -> Message | None:
    """What is said of cameras one of which is turned; None: neither is."""
    if abs(turn_deg) > _UPSIDE_DOWN_DEG:
        return msg(
            "{right} is turned by {turn:.0f} degrees against {left}: one of them is upside down; "
            "turn its images",
            right=other.name,
            left=source.name,
            turn=abs(turn_deg),
        )
    if abs(turn_deg) > _TURNED_DEG:
        return msg(
            "{right} is turned by {turn:.0f} degrees against {left}: turn its images",
            right=other.name,
            left=source.name,
            turn=turn_deg,
        )
    return None


def _sides(
    left: Path, right: Path, names: tuple[str, str], found: RelativePose
) -> tuple[bool, Message, tuple[Message, ...]]:
    """Whether the cameras are given the other way round, what is said of it, and the doubts.

    Names that tell the sides count for more than images that do not tell them for sure.
    """
    swapped, sure = _is_swapped(found)
    named = pair_by_name((left, right))
    by_name = not sure and named is not None and named.sides_told
    if by_name and named is not None:
        swapped = named.left == right
    taken, beside = names[::-1] if swapped else names
    agree = msg(
        "{left} and {right} show one place ({count} points agree)",
        left=taken,
        right=beside,
        count=found.agreeing,
    )
    if sure:
        return swapped, joined("; ", (agree, msg("{left} is the left camera", left=taken))), ()
    doubt = msg("which camera is left is not sure from the images: {left} is taken", left=taken)
    why = (
        msg("as the names say")
        if by_name
        else msg("look at both, and exchange them if that is wrong")
    )
    return swapped, agree, (joined("; ", (doubt, why)),)


def _is_swapped(found: RelativePose) -> tuple[bool, bool]:
    """Whether the first camera stands on the right, and whether that is sure.

    Over a flat scene the pose alone is not: the images of two cameras that look the same way say
    it, too, as everything is farther right in the left one's.
    """
    side, off_side = float(found.direction[0]), float(np.hypot(*found.direction[1:]))
    if abs(side) >= _SURELY_LEFT * off_side:
        return side > 0, True
    shift = float(found.shift_px[0])
    parallel = abs(shift) > _LEAST_SHIFT * max(found.row_scatter_px, abs(found.shift_px[1]), 0.5)
    return (shift < 0, True) if parallel else (side > 0, False)


def _check_sizes(source: PictureSource, other: PictureSource) -> None:
    if source.size != other.size:
        raise RecordingError(
            "{left} is {width} x {height} px, {right} {width2} x {height2}; a pair has one size",
            left=source.name,
            right=other.name,
            width=source.size[0],
            height=source.size[1],
            width2=other.size[0],
            height2=other.size[1],
        )


def _rates_and_lengths(
    source: PictureSource, other: PictureSource
) -> tuple[list[Message], list[Message]]:
    notes: list[Message] = []
    doubts: list[Message] = []
    if source.fps and other.fps and abs(source.fps / other.fps - 1.0) > 0.001:
        doubts.append(
            msg(
                "{left} has {fps:g} frames per second, {right} {fps2:g}: frames drift apart",
                left=source.name,
                right=other.name,
                fps=source.fps,
                fps2=other.fps,
            )
        )
    counts = source.frame_count, other.frame_count
    if abs(counts[0] - counts[1]) > _LENGTHS_DIFFER * max(counts):
        notes.append(
            msg(
                "{left} has {count} frames, {right} {count2}: the shorter one counts",
                left=source.name,
                right=other.name,
                count=counts[0],
                count2=counts[1],
            )
        )
    return notes, doubts


def _numbers(count: int) -> list[int]:
    looks = np.linspace(0, count - 1, min(count, _LOOKS + 2))
    return [int(number) for number in (looks[1:-1] if len(looks) > 2 else looks)]


def _black(*sources: PictureSource) -> list[Message]:
    """Cameras whose first image is black, and where it ends to be."""
    notes = []
    for source in sources:
        if source.read(0).mean() >= _DARK:
            continue
        looks = [number for number in _DARK_LOOKS if number < source.frame_count]
        first = next((at for at in looks if source.read(at).mean() >= _DARK), None)
        notes.append(
            msg(
                "{name} is black at first, until frame {frame} or before",
                name=source.name,
                frame=first,
            )
            if first is not None
            else msg("{name} is black at first", name=source.name)
        )
    return notes


def _unlike(
    left: Path,
    right: Path,
    views: list[tuple[Image, Image]],
    found: RelativePose | None,
    notes: tuple[Message, ...],
    doubts: tuple[Message, ...],
) -> CameraFindings | None:
    """Two that show no common place, unless one of them is mirrored; None: they are a pair."""
    agreeing = 0 if found is None else found.agreeing
    mirrored = pose_of_matches(match_images([(one, other[:, ::-1]) for one, other in views]))
    names = {"left": left.name, "right": right.name}
    if mirrored is not None and mirrored.agreeing >= max(_SAME_SCENE, 2 * agreeing):
        doubt = msg("{right} is mirrored against {left}: mirror its images", **names)
        return CameraFindings(left, right, same_scene=True, notes=notes, doubts=(*doubts, doubt))
    if agreeing >= _SAME_SCENE:
        return None
    doubt = msg("{left} and {right} do not show the same place", **names)
    return CameraFindings(left, right, same_scene=False, notes=notes, doubts=(*doubts, doubt))


def _one_file(path: Path, source: PictureSource) -> CameraFindings:
    """One camera, or both cameras in one image, or in images by turns."""
    views, agreeing = _most_alike(source)
    pose = None if views is None else pose_of_matches(views[1])
    if views is None or pose is None or agreeing < _SAME_SCENE:
        note = msg("{name} is of one camera", name=source.name)
        return CameraFindings(path, notes=(note, *_black(source)))
    layout = views[0]
    # Cameras of one device look the same way: everything is farther right in the left one's image.
    is_left = pose.shift_px[0] > 0 if layout in _BY_TURNS else pose.direction[0] < 0
    left_first = bool(is_left)
    note = msg(
        "{name} holds both cameras, {layout} ({count} points agree); the left camera is {place}",
        name=source.name,
        layout=msg(_LAYOUT_WORDS[layout]),
        count=pose.agreeing,
        place=msg("first") if left_first else msg("second"),
    )
    notes = (note, *_black(source))
    return CameraFindings(path, None, layout, left_first, same_scene=True, notes=notes)


def _most_alike(source: PictureSource) -> tuple[tuple[Layout, MatchedViews] | None, int]:
    """How a source holds both cameras, as far as it does, and the points that agree on it."""
    numbers = _numbers(source.frame_count)
    images = [source.read(number) for number in numbers]
    if _has_other_rows(images):
        fields = [(field_of(image, 0), field_of(image, 1)) for image in images]
        return _agreeing("row-interleaved", match_images(fields))
    triples = [
        [source.read(2 * (number // 2) + after) for after in range(3)]
        for number in numbers
        if 2 * (number // 2) + 2 < source.frame_count
    ]
    if _has_other_images(triples):
        return _agreeing("frame-sequential", match_images([(one[0], one[1]) for one in triples]))
    height, width = images[0].shape[:2]
    halves: dict[Layout, MatchedViews] = {
        "side-by-side": match_images([(i[:, : width // 2], i[:, width // 2 :]) for i in images]),
        "top-bottom": match_images([(i[: height // 2], i[height // 2 :]) for i in images]),
    }
    found = [_agreeing(layout, views) for layout, views in halves.items() if _alike(views)]
    return max(found, key=lambda one: one[1], default=(None, 0))


def _agreeing(layout: Layout, views: MatchedViews) -> tuple[tuple[Layout, MatchedViews], int]:
    pose = pose_of_matches(views)
    if pose is None:
        return (layout, views), 0
    offset = np.abs(views.points[:, 0] - views.points[:, 1]).max(axis=1)
    is_one = float(np.median(offset)) < _LEAST_APART_PX
    return (layout, views), 0 if is_one else pose.agreeing


def _has_other_rows(images: Sequence[Image]) -> bool:
    """Whether rows resemble those after the next more than the next ones, all over the image."""
    shares = []
    for image in images:
        rows = image.astype(np.int16)
        next_one = np.abs(rows[1:-1] - rows[:-2]).mean()
        after_next = np.abs(rows[2:] - rows[:-2]).mean()
        shares.append(next_one / max(float(after_next), 1e-6))
    return float(np.median(shares)) > _BY_TURNS_RATIO


def _has_other_images(triples: Sequence[Sequence[Image]]) -> bool:
    """Whether images resemble those after the next more than the next ones."""
    shares = []
    for first, second, third in triples:
        one, two, three = (image.astype(np.int16) for image in (first, second, third))
        next_one, after_next = np.abs(two - one).mean(), np.abs(three - one).mean()
        shares.append((next_one + _NOISE) / (float(after_next) + _NOISE))
    return bool(shares) and float(np.median(shares)) > _BY_TURNS_RATIO


def _alike(views: MatchedViews) -> bool:
    """Whether matches lie at about the same places of both halves, as views of a pair have it."""
    if not len(views.points):
        return False
    offset = views.points[:, 0] - views.points[:, 1]
    near = np.abs(offset - np.median(offset, axis=0)) < 0.25 * np.array(views.size)
    return float(near.all(axis=1).mean()) > _SAME_SIZE

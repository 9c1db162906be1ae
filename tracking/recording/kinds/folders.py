"""What the folders of several kinds have in common."""

from __future__ import annotations

from pathlib import Path

from tracking.recording.images import VIDEO_SUFFIXES, image_files


def images_in(folder: Path) -> Path | None:
    """The folder, or the `data` folder in it, that has images."""
    for place in (folder, folder / "data"):
        if place.is_dir() and image_files([f for f in place.iterdir() if f.is_file()]):
            return place
    return None


def camera_in(folder: Path, side: str) -> Path | None:
    """A video or an image folder with a camera's name."""
    images = images_in(folder / side)
    if images is not None:
        return images
    videos = [f for f in folder.glob(f"{side}.*") if f.suffix.lower() in VIDEO_SUFFIXES]
    return min(videos, default=None)


def first_file(*places: tuple[Path, str]) -> tuple[Path, ...]:
    """The first of some files (folder, name) that is there; none where no one is."""
    return next(((place / name,) for place, name in places if (place / name).is_file()), ())

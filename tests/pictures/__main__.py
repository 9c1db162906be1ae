"""Make `docs/images/*.png`: the welcome page, a recording playing, a swap waiting for Enter.

The window is drawn on the screen of `DISPLAY`; `make pictures` gives it a virtual one.
"""

from __future__ import annotations

import os
import sys
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from pathlib import Path
from tempfile import TemporaryDirectory

import cv2
import numpy as np
from numpy.typing import NDArray
from PySide6.QtCore import Qt
from PySide6.QtGui import QImage, QPixmap

from app.cli.display import why_no_window
from app.core.look.theme import Look
from app.shell.application import borrowed_window, show_document, wait_until
from app.shell.main_window import MainWindow
from app.shell.recording_controller import RecordingController
from tracking.synthesis import render_recording

IMAGES = Path(__file__).parents[2] / "docs" / "images"
SIZE = (1600, 1000)
LOOKS = (Look.DARK, Look.LIGHT)
_PATIENCE_MS = 300_000
_COLOURS = 255
_SAMPLES = 40_000


def main() -> int:
    """Make all pictures; names given on the command line make only those."""
    if missing := why_no_window():
        sys.exit(missing)
    wanted = set(sys.argv[1:])
    IMAGES.mkdir(parents=True, exist_ok=True)
    with TemporaryDirectory(prefix="trackwright-") as own:
        os.environ |= {"HOME": own, "XDG_DATA_HOME": own, "XDG_CONFIG_HOME": own}
        for name, make in PICTURES.items():
            if not wanted or name in wanted:
                make(name, Path(own))
    return 0


def welcome(name: str, own: Path) -> None:
    """The first page, with some recordings opened before."""
    with borrowed_window(LOOKS[0].value, SIZE) as window:
        for folder in ("Lobby, camera 3", "Square, market day"):
            place = own / "Recordings" / folder
            place.mkdir(parents=True, exist_ok=True)
            window.remembered.add_recent(place)
        window.show_welcome()
        window.show()
        _shoot(window, name)


def playing(scene: str, frame: int) -> Callable[[str, Path], None]:
    """A recording that plays as it is tracked; what was told of the tracking is dismissed."""

    def make(name: str, own: Path) -> None:
        with _playing(_recording(scene, own), frame) as window:
            window.notice.hide()
            _shoot(window, name)

    return make


def swap_preview(name: str, own: Path) -> None:
    """Two people who met, and the swap that would change their ids over."""
    with _playing(_recording("plaza", own), 120) as window:
        controller = window.controller
        assert controller is not None
        wait_until(lambda: not controller.live.running and not window.work.busy, _PATIENCE_MS)
        controller.playback.pause()
        a, b, frame = _who_met(controller)
        controller.playback.go(frame)
        controller.editing.rename(a, "red coat")
        controller.editing.pick(a)
        window.run_command("tracks.swap")
        controller.editing.pick(b)
        _shoot(window, name)


PICTURES: dict[str, Callable[[str, Path], None]] = {
    "welcome": welcome,
    "playing-plaza": playing("plaza", 215),
    "swap-preview": swap_preview,
}


def _recording(scene: str, own: Path) -> Path:
    """A built-in scene, rendered once: pictures show nobody who lives."""
    folder = own / scene
    if not folder.is_dir():
        render_recording(folder, scene, 20.0, 11, 4)
    return folder


@contextmanager
def _playing(recording: Path, frame: int) -> Iterator[MainWindow]:
    """The window while it plays and tracks, once it has come to the frame."""
    with borrowed_window(LOOKS[0].value, SIZE) as window:
        show_document(window, recording, 0)
        controller = window.controller
        assert controller is not None
        window.run_command("play.toggle")
        wait_until(lambda: controller.playback.number >= frame, _PATIENCE_MS)
        yield window


def _who_met(controller: RecordingController) -> tuple[int, int, int]:
    """The two long tracks of clearly different colours that came closest to each other."""
    tracks = controller.document.tracks
    nearest = (np.inf, 0, 0, 0)
    for frame in range(100, controller.document.recording.frame_count - 100, 5):
        rows = tracks.of_frame(frame)
        lasting = [len(tracks.of_track(int(one))["frame"]) > 120 for one in rows["track"]]
        ids, x, y = (rows[name][lasting] for name in ("track", "x", "y"))
        apart = np.hypot(x[:, None] - x, y[:, None] - y)
        colours = np.array([controller.document.colour_of(int(one)) for one in ids]).astype(float)
        alike = np.linalg.norm(colours[:, None] - colours, axis=2) < 150
        apart[alike] = np.inf
        if len(x) > 1 and apart.min() < nearest[0]:
            i, j = np.unravel_index(int(apart.argmin()), apart.shape)
            nearest = (float(apart.min()), int(ids[i]), int(ids[j]), frame)
    return nearest[1:]


def _shoot(window: MainWindow, name: str) -> None:
    """Draw the window in both looks."""
    for look in LOOKS:
        window.look_choice.choose(look)
        wait_until(lambda: False, 400)
        path = IMAGES / f"{name}-{look.value}.png"
        save_small(window.grab(), path)
        print(f"{path.name}: {path.stat().st_size // 1000} kB", file=sys.stderr)


def save_small(pixmap: QPixmap, path: Path) -> None:
    """Save with a palette of its own colours, dithered; about a third of the size."""
    image = pixmap.toImage().convertToFormat(QImage.Format.Format_RGB32)
    table = [0xFF000000 | int(r) << 16 | int(g) << 8 | int(b) for b, g, r in _palette(image)]
    indexed = image.convertToFormat(
        QImage.Format.Format_Indexed8, table, Qt.ImageConversionFlag.ThresholdDither
    )
    if not indexed.save(str(path), "PNG", 0):
        raise SystemExit(f"{path} cannot be written")


def _palette(image: QImage) -> NDArray[np.uint8]:
    """(n, 3) blue, green, red of the colours that matter most in the picture."""
    rows = np.frombuffer(image.constBits(), np.uint8).reshape(image.height(), -1, 4)
    pixels = rows[:, : image.width(), :3].reshape(-1, 3)
    rng = np.random.default_rng(0)
    chosen = pixels[rng.integers(0, len(pixels), _SAMPLES)].astype(np.float32)
    common, counts = np.unique(pixels, axis=0, return_counts=True)
    flat = common[np.argsort(counts)[-48:]]  # the window's own plain colours stay exact
    cv2.setRNGSeed(0)
    stop = (cv2.TERM_CRITERIA_MAX_ITER, 12, 0.0)
    flags = cv2.KMEANS_PP_CENTERS
    _, _, centres = cv2.kmeans(chosen, _COLOURS - len(flat), None, stop, 1, flags)
    return np.concatenate((flat, centres.round().astype(np.uint8)))


if __name__ == "__main__":
    sys.exit(main())

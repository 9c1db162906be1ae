"""Bare videos to metres in the window: `python -m tests.benchmarks.setup [--only NAME ...]`.

Each recording's videos are copied without recording.toml and set up with mouse and keys in the
real window (offscreen), until a tracker tracks in metres. Their lenses are kept as a file beside
them, but for `roughly-rendered-lobby`, where there is none. Said are minutes of the whole way
(and of the processor), actions, how far the floor is from the one given, and what the window says
of a floor that is not sure. Beside it stands what it costs to decode the same videos once,
measured just before, as a measure of the machine and of what else it does.
"""

from __future__ import annotations

import os
import shutil
import sys
import time
from dataclasses import dataclass
from pathlib import Path
from tempfile import TemporaryDirectory

import av

from tests.benchmarks.command import parser_of, real_data, tell
from tracking.geometry import Ground
from tracking.recording import open_recording, read_manifest
from tracking.setup.calibration_facts import field_of_view_deg

_REAL = (
    "overhead-real",
    "pets-s2l1-real",
    "towncentre-real",
    "office-camera0-real",
    "office-camera2-real",
)
_ROUGHLY = "roughly-"
_RENDERED = "rendered-lobby"
_NAMES = (_ROUGHLY + _RENDERED, _RENDERED, *_REAL)
_PATIENCE_MS = 900_000
_CARD = ("GX010035", "GX010034")
"""The left camera's file and the right one's, whose names say the contrary."""


@dataclass(frozen=True, slots=True)
class _Case:
    """Videos as they come. Attributes: truth: the floor given. fov_deg, baseline_mm: for rough."""

    videos: list[Path]
    truth: Ground
    fov_deg: float = 0.0
    baseline_mm: float = 0.0


def main() -> None:
    """Read the command line, measure and print."""
    parser = parser_of("setup", __doc__)
    parser.add_argument("--only", nargs="+", choices=_NAMES, default=_NAMES, metavar="NAME")
    parser.add_argument("--data", type=Path, default=real_data(), help="folder of recordings")
    asked = parser.parse_args()
    os.environ.setdefault("QT_QPA_PLATFORM", "offscreen")
    for name in asked.only:
        with TemporaryDirectory(prefix="trackwright-") as own:
            os.environ |= {"HOME": own, "XDG_DATA_HOME": own, "XDG_CONFIG_HOME": own}
            folder = asked.data / name.removeprefix(_ROUGHLY)
            made = _case(Path(own), folder, rough=name.startswith(_ROUGHLY))
            if made is None:
                tell(f"{name}: not at {asked.data}")
                continue
            decoded = _decoded(made.videos)
            print(f"{_measured(name, made)}  ({decoded})", flush=True)


def _case(own: Path, folder: Path, *, rough: bool) -> _Case | None:
    """Copies of a recording's videos, named as cameras name theirs, and of its lenses."""
    if not folder.is_dir():
        return None
    manifest = read_manifest(folder)
    card = own / "card"
    card.mkdir()
    sources = [name for name in (manifest.left, manifest.right) if name is not None]
    videos = []
    for source, called in zip(sources, _CARD, strict=False):
        videos.append(card / (called + Path(source).suffix))
        shutil.copyfile(folder / source, videos[-1])
    with open_recording(folder) as recording:
        calibration, ground = recording.calibration, recording.ground
    assert calibration is not None, "it is given"
    assert ground is not None, "it is given"
    if not rough:
        for file in manifest.calibration:
            shutil.copyfile(folder / file, card / Path(file).name)
        return _Case(sorted(videos), ground)
    fov_deg = float(round(field_of_view_deg(calibration.left)))
    return _Case(sorted(videos), ground, fov_deg, 1000 * calibration.baseline_m)


def _decoded(videos: list[Path]) -> str:
    """Seconds, and those of the processor, that all frames of the videos take without a window."""
    began_s, spent_s, frames = time.monotonic(), time.process_time(), 0
    for video in videos:
        with av.open(str(video)) as container:
            frames += sum(1 for _ in container.decode(video=0))
    lasted_s, spent_s = time.monotonic() - began_s, time.process_time() - spent_s
    return f"decoding its {frames} frames: {lasted_s:.1f} s, processor {spent_s:.1f} s"


def _measured(name: str, case: _Case) -> str:
    from app.shell.application import borrowed_window, wait_until
    from tests.benchmarks.setup.user import SetupUser, set_up_roughly, set_up_with_file

    with borrowed_window("dark", (1400, 900)) as window:
        window.show()
        began_s = time.process_time()
        user = SetupUser(window, lambda ready: wait_until(ready, _PATIENCE_MS))
        try:
            if case.baseline_mm:
                set_up_roughly(user, case.videos, case.fov_deg, case.baseline_mm)
            else:
                set_up_with_file(user, case.videos)
        except AssertionError as error:
            dialog = window.files.setup.dialog
            told = dialog.editor.scene.problems if dialog is not None else {}
            return f"{name:22s} stopped after {user.actions} actions: {error} {told}"
        controller = window.controller
        assert controller is not None, "the recording is open"
        wait_until(lambda: bool(controller.live.running), 60_000)
        wait_until(lambda: controller.playback.number >= 1, 60_000)
        ground = controller.document.recording.ground
        spent_s = time.process_time() - began_s
        line = _line(name, (user.seconds, spent_s), user.actions, ground, case.truth)
        controller.tracking.stop()
        return f"{line}  told: {user.doubt}" if user.doubt else line


def _line(
    name: str, seconds: tuple[float, float], actions: int, ground: Ground | None, truth: Ground
) -> str:
    whole, own = seconds[0] / 60, seconds[1] / 60
    head = f"{name:22s} {whole:4.1f} min ({own:.1f}) {actions:3d} actions"
    if ground is None:
        return f"{head}  no floor"
    height = 100 * (ground.height_m / truth.height_m - 1)
    tilt, roll = ground.tilt_deg - truth.tilt_deg, ground.roll_deg - truth.roll_deg
    return f"{head}  height {height:+6.1f} %, tilt {tilt:+6.2f}, roll {roll:+6.2f} degrees"


if __name__ == "__main__":
    sys.exit(main())

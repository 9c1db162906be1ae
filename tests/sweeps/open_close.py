"""Open and close a session again and again in the window, and watch the memory.

`python -m tests.sweeps.open_close [CYCLES] [--session FILE] [--most MIB]`. Each time the session
opens, a second and a half of it plays, and it closes. A line after every
tenth says what the process has in memory. The exit status says whether that stayed below `--most`
and, from the first tenth of the cycles on, grew by less than 0.05 MiB a cycle.
"""

from __future__ import annotations

import argparse
import sys
import tempfile
import threading
import time
from pathlib import Path

import numpy as np
from PySide6.QtCore import QObject, QSettings

from app.memory import map_large_blocks
from app.views.application import start_application, wait_until
from app.views.files.files import GIVE_BACK_MS
from app.views.recording.recording_controller import RecordingController
from app.views.widgets.user_settings import UserSettings
from app.views.window.main_window import MainWindow
from app.views.window.shutdown_signals import take_down
from tests.sweeps.long_run import resident_mb
from tests.sweeps.shown_session import session_with_particles

CYCLES = 200
MOST_MIB = 450
"""The window with nothing open has 280 MiB."""
MOST_GROWTH_MIB = 0.05
FRAMES_PLAYED = 30
_MIB = 1.048576  # MB


def main() -> int:
    """Run it; the exit status."""
    parser = argparse.ArgumentParser(description=(__doc__ or "").splitlines()[0])
    parser.add_argument("cycles", type=int, nargs="?", default=CYCLES)
    parser.add_argument("--session", type=Path, help="made of a rendered recording if left out")
    parser.add_argument("--most", type=int, default=MOST_MIB, help="MiB that are allowed")
    asked = parser.parse_args()
    with tempfile.TemporaryDirectory(prefix="trackwright-") as folder:
        session = asked.session or session_with_particles(Path(folder))
        sizes = resident_after(session, asked.cycles, Path(folder))
    return verdict(sizes, asked.most)


def resident_after(session: Path, cycles: int, folder: Path) -> list[float]:
    """What the process has in memory, in MiB, after each cycle."""
    map_large_blocks()
    remembered = UserSettings(QSettings(str(folder / "settings.ini"), QSettings.Format.IniFormat))
    start_application(remembered)
    window = MainWindow(remembered)
    window.resize(1600, 1000)
    window.show()
    sizes = []
    for cycle in range(1, cycles + 1):
        open_and_close(window, session)
        sizes.append(resident_mb("self") / _MIB)
        if cycle % 10 == 0:
            count = len(window.findChildren(QObject))
            print(f"after {cycle:4} cycles {sizes[-1]:6.1f} MiB, {count} objects", flush=True)
    take_down(window)
    return sizes


def open_and_close(window: MainWindow, session: Path) -> None:
    """One cycle."""
    window.files.open_path(session)
    assert wait_until(lambda: window.controller is not None), "the session did not open"
    play(window.controller)
    window.files.close_without_asking()
    window.show_welcome()
    gone_s = time.monotonic() + 3 * GIVE_BACK_MS / 1000
    wait_until(lambda: time.monotonic() > gone_s and threading.active_count() == 1)


def play(controller: RecordingController | None) -> None:
    """Play the first frames; nothing holds the controller after that."""
    assert controller is not None
    controller.playback.toggle()
    played = wait_until(lambda: controller.playback.clock.frame >= FRAMES_PLAYED)
    assert played, "it does not play"


def verdict(sizes: list[float], most_mib: int) -> int:
    """Say how it went; 0 where it stayed within bounds."""
    begun = len(sizes) // 10
    growth = 0.0
    if len(sizes) > begun + 10:
        growth = float(np.polyfit(np.arange(begun, len(sizes)), sizes[begun:], 1)[0])
    print(f"{len(sizes)} cycles: at most {max(sizes):.0f} MiB ({most_mib} are allowed)")
    print(f"{growth:.3f} MiB more with each cycle ({MOST_GROWTH_MIB} are allowed)")
    return int(max(sizes) > most_mib or growth > MOST_GROWTH_MIB)


if __name__ == "__main__":
    sys.exit(main())

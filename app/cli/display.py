"""Is there a screen to open a window on?"""

from __future__ import annotations

import os
import sys
from collections.abc import Mapping

_OFF_SCREEN = ("offscreen", "minimal", "vnc")


def has_display(environment: Mapping[str, str] = os.environ, system: str = sys.platform) -> bool:
    """Whether a window would be seen: on Linux a display is named, elsewhere there is one."""
    if environment.get("QT_QPA_PLATFORM", "").split(":")[0] in _OFF_SCREEN:
        return False
    if system in ("win32", "darwin"):
        return True
    return bool(environment.get("DISPLAY") or environment.get("WAYLAND_DISPLAY"))

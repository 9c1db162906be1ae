"""Can a window be opened on a screen here?

Qt aborts the whole process where it cannot, with a page of its own words. So it is tried first,
part by part, without Qt's own start.
"""

from __future__ import annotations

import ctypes
import os
import sys
from collections.abc import Callable, Mapping
from pathlib import Path

from app.cli.system_libraries import INSTALL
from tracking.translation import msg

_OFF_SCREEN = ("offscreen", "minimal", "vnc")
_X11_PLUGIN = Path("Qt", "plugins", "platforms", "libqxcb.so")
"""Qt's part for X11 screens, below the folder of PySide6."""


def has_display(environment: Mapping[str, str] = os.environ, system: str = sys.platform) -> bool:
    """Whether a window would be seen: on Linux a display is named, elsewhere there is one."""
    if environment.get("QT_QPA_PLATFORM", "").split(":")[0] in _OFF_SCREEN:
        return False
    if system in ("win32", "darwin"):
        return True
    return bool(environment.get("DISPLAY") or environment.get("WAYLAND_DISPLAY"))


def why_no_window(
    environment: Mapping[str, str] = os.environ,
    system: str = sys.platform,
    load: Callable[[str], object] = ctypes.CDLL,
) -> str:
    """Why no window can be opened, in a line; "" where one can.

    Args:
        load: loads a system library by its path; OSError where a part of it is missing.
    """
    if not has_display(environment, system):
        return msg("there is no display to open a window on")
    if system in ("win32", "darwin"):
        return ""
    try:
        from PySide6 import QtWidgets

        if _has_wayland(environment):
            return ""
        load(str(Path(QtWidgets.__file__).parent / _X11_PLUGIN))
    except (ImportError, OSError) as error:
        return msg(
            "a system library that Qt needs is missing: {reason}; on Debian and Ubuntu "
            "run: sudo {packages}",
            reason=_first_line(error),
            packages=" ".join(INSTALL),
        )
    display = environment.get("DISPLAY", "")
    if not _answers(display):
        return msg(
            "the display {display} does not answer",
            display=display or environment["WAYLAND_DISPLAY"],
        )
    return ""


def _has_wayland(environment: Mapping[str, str]) -> bool:
    """Whether a Wayland display is there, unless Qt is told to use X11."""
    wanted = environment.get("QT_QPA_PLATFORM", "").split(":")[0]
    name = environment.get("WAYLAND_DISPLAY", "")
    if not name or wanted.startswith("xcb"):
        return False
    return Path(environment.get("XDG_RUNTIME_DIR", ""), name).is_socket()


def _answers(display: str) -> bool:
    """Whether an X11 display takes connections."""
    if not display:
        return False
    xcb = ctypes.CDLL("libxcb.so.1")
    xcb.xcb_connect.argtypes = [ctypes.c_char_p, ctypes.c_void_p]
    xcb.xcb_connect.restype = ctypes.c_void_p
    xcb.xcb_connection_has_error.argtypes = [ctypes.c_void_p]
    xcb.xcb_disconnect.argtypes = [ctypes.c_void_p]
    connection = xcb.xcb_connect(display.encode(), None)
    refused = bool(xcb.xcb_connection_has_error(connection))
    xcb.xcb_disconnect(connection)
    return not refused


def _first_line(error: Exception) -> str:
    return str(error).partition("\n")[0]

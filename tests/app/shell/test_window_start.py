"""What a window has loaded once it stands: nothing of what only some windows need."""

from __future__ import annotations

import subprocess
import sys
from pathlib import Path

_ROOT = Path(__file__).parents[3]
_LATE = ("tracking.batch", "tracking.project", "app.features.project.page", "sklearn", "jinja2")


def test_what_projects_need_is_loaded_with_the_first_project() -> None:
    code = (
        "import sys, app.shell.main_window;"
        f"print(*(name for name in {_LATE!r} if name in sys.modules))"
    )
    done = subprocess.run(
        [sys.executable, "-c", code], cwd=_ROOT, capture_output=True, text=True, check=True
    )
    assert done.stdout.split() == []


def test_the_page_of_projects_is_made_with_the_first_project(window) -> None:
    assert window._project_page is None
    assert not window.files.projects.is_open
    window.close()
    assert window._project_page is None

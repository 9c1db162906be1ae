"""The program that looks a file over is started at every opening: it loads what it needs."""

from __future__ import annotations

import os
import subprocess
import sys
from pathlib import Path

from tracking.session import inspection


def test_looking_a_file_over_loads_neither_video_nor_science(tmp_path: Path) -> None:
    file = tmp_path / "s.h5"
    file.write_bytes(b"no session")
    root = str(Path(inspection.__file__).parents[2])
    done = subprocess.run(
        [sys.executable, "-P", "-X", "importtime", inspection.__file__, str(file)],
        env={**os.environ, "PYTHONPATH": root},
        capture_output=True,
        text=True,
        check=True,
    )
    loaded = {line.rsplit("|", 1)[-1].strip() for line in done.stderr.splitlines()}
    assert "refused" in done.stdout
    assert {"h5py", "tracking.session.layout"} <= loaded
    assert not loaded & {"scipy", "cv2", "av", "PySide6", "tracking.session.document"}

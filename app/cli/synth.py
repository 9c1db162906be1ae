"""`synth`: a rendered recording with exact truth."""

from __future__ import annotations

from pathlib import Path

from app.cli.destination import check_folder, nearest_folder
from app.cli.output import print_json, progress
from tracking.synthesis import check_seconds, render_recording

_BYTES_A_SECOND = 1 << 20


def run_synth(
    out: Path,
    scene: str,
    seconds: float | None,
    people: int | None,
    seed: int,
    *,
    as_json: bool,
) -> None:
    """Render the recording and print where it stands."""
    check_seconds(seconds)
    check_folder(nearest_folder(out.parent), int((seconds or 0) * _BYTES_A_SECOND))
    with progress(f"rendering {scene}") as advance:
        folder = render_recording(out, scene, seconds, people, seed, advance)
    if as_json:
        print_json({"recording": str(folder)})
    else:
        print(folder)

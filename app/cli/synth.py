"""`synth`: a rendered recording with exact truth."""

from __future__ import annotations

import contextlib
from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path

from app.cli.destination import check_folder, nearest_folder
from app.cli.output import print_json, print_line, progress
from tracking.progress import Progress
from tracking.synthesis import Disturbances, check_seconds, render_recording
from tracking.translation import msg

_BYTES_A_SECOND = 1 << 20


@dataclass(frozen=True, slots=True)
class SynthRequest:
    """What is rendered.

    Attributes:
        scene: its name.
        seconds, people: the scene's own if None.
        seed: of all random numbers.
        depth: exact depth in place of the right camera.
        begin_s, dimmed_s, bumped_s: as `Disturbances` has them.
    """

    scene: str
    seconds: float | None
    people: int | None
    seed: int
    begin_s: float = 0.0
    dimmed_s: float | None = None
    bumped_s: float | None = None
    depth: bool = False


def run_synth(out: Path, request: SynthRequest, *, as_json: bool) -> None:
    """Render the recording and print where it stands."""
    check_seconds(request.seconds)
    disturbances = Disturbances(request.begin_s, request.dimmed_s, request.bumped_s)
    check_folder(nearest_folder(out.parent), int((request.seconds or 0) * _BYTES_A_SECOND))
    with _begun(msg("rendering {scene}", scene=request.scene)) as advance:
        folder = render_recording(
            out,
            request.scene,
            request.seconds,
            request.people,
            request.seed,
            advance,
            disturbances=disturbances,
            depth=request.depth,
        )
    if as_json:
        print_json({"recording": str(folder)})
    else:
        print_line(folder)


@contextlib.contextmanager
def _begun(what: str) -> Iterator[Progress]:
    """Progress that says nothing before there is some: what is asked for may be refused first."""
    with contextlib.ExitStack() as shown:
        bars: list[Progress] = []

        def advance(done: int, total: int) -> None:
            if not bars:
                bars.append(shown.enter_context(progress(what)))
            bars[0](done, total)

        yield advance

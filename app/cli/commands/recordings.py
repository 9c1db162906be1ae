"""Commands that make, open and describe recordings."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated

import typer

from app.cli import options
from app.cli.commands.program import program
from app.cli.help_pages import HelpCommand
from app.cli.option_groups import Bare, expand_groups

SCENE_NAMES = (
    "lobby",
    "plaza",
    "square",
    "indoor",
    "outdoor",
    "uniforms",
    "pillars",
    "ceiling",
    "corridor",
    "walkway",
    "crouching",
    "marks",
    "marks-walking",
    "marks-pairs",
    "lane",
    "two-way",
    "situations",
    *(f"situation-{number}" for number in range(1, 16)),
)
"""Of `tracking.synthesis.SCENES`, which takes too long to import for a page of help."""


def _scenes(incomplete: str) -> list[str]:
    """What a shell proposes for --scene."""
    return [name for name in SCENE_NAMES if name.startswith(incomplete)]


@program.command(cls=HelpCommand)
def demo(
    out: Annotated[
        Path | None,
        typer.Option("--out", help="Folder to make the recording in.", show_default="data folder"),
    ] = None,
    no_gui: Annotated[bool, typer.Option("--no-gui", help="Do not open the window.")] = False,
    json: options.Json = False,
) -> None:
    """Make the built-in stereo recording, track it and open it in the window."""
    from app.cli.demo import run_demo

    run_demo(out, gui=not no_gui, as_json=json)


@program.command(name="open", cls=HelpCommand)
@expand_groups
def open_window(
    path: Annotated[Path | None, typer.Argument(help="A recording or a session.")] = None,
    *,
    bare: Bare,
    recording: Annotated[
        Path | None, typer.Option(help="Where the session's recording is now.")
    ] = None,
) -> None:
    """Open the window."""
    from app.cli.open_window import run_open

    run_open(path, bare, recording)


@program.command(cls=HelpCommand)
@expand_groups
def info(
    path: Annotated[Path | None, typer.Argument(help="A recording or a session.")] = None,
    *,
    bare: Bare,
    json: options.Json = False,
) -> None:
    """Show what a recording or a session holds."""
    from app.cli.info import run_info

    run_info(path, bare, as_json=json)


@program.command(cls=HelpCommand)
def synth(
    out: Annotated[Path, typer.Argument(help="Folder to make the recording in.")],
    scene: Annotated[
        str,
        typer.Option(
            help=f"Scene to render: {', '.join(SCENE_NAMES)}.",
            autocompletion=_scenes,
        ),
    ],
    seconds: Annotated[
        float | None,
        typer.Option(help="Length of the recording, s.", show_default="the scene's own"),
    ] = None,
    people: Annotated[
        int | None, typer.Option(help="Number of people.", show_default="the scene's own")
    ] = None,
    seed: options.Seed = 0,
    begin: Annotated[
        float,
        typer.Option(
            help="Leave out this many seconds at the start, so that the first frame shows people."
        ),
    ] = 0.0,
    dim: Annotated[
        float | None,
        typer.Option(help="Second at which some of the lights go out.", show_default="never"),
    ] = None,
    bump: Annotated[
        float | None,
        typer.Option(help="Second at which something bumps the camera.", show_default="never"),
    ] = None,
    depth: Annotated[
        bool,
        typer.Option("--depth", help="Write exact depth in place of the right camera."),
    ] = False,
    json: options.Json = False,
) -> None:
    """Render a recording of people with exact ground truth; the scene has one camera or two."""
    from app.cli.synth import SynthRequest, run_synth

    request = SynthRequest(scene, seconds, people, seed, begin, dim, bump, depth)
    run_synth(out, request, as_json=json)

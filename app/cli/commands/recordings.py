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
        Path | None, typer.Option("--out", help="Where to make it.", show_default="data folder")
    ] = None,
    no_gui: Annotated[bool, typer.Option("--no-gui", help="Do not open the window.")] = False,
    json: options.Json = False,
) -> None:
    """Make the built-in stereo recording, track it and open the window on it."""
    from app.cli.demo import run_demo

    run_demo(out, gui=not no_gui, as_json=json)


@program.command(name="open", cls=HelpCommand)
@expand_groups
def open_window(
    path: Annotated[Path | None, typer.Argument(help="A recording or a session.")] = None,
    *,
    bare: Bare,
    recording: Annotated[
        Path | None, typer.Option(help="Where a session's recording has moved to.")
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
    """Say what a recording or a session holds."""
    from app.cli.info import run_info

    run_info(path, bare, as_json=json)


@program.command(cls=HelpCommand)
def synth(
    out: Annotated[Path, typer.Argument(help="The recording's folder, made by this command.")],
    scene: Annotated[
        str,
        typer.Option(
            help=f"Which kind of place: {', '.join(SCENE_NAMES)}.",
            autocompletion=_scenes,
        ),
    ],
    seconds: Annotated[
        float | None, typer.Option(help="How long.", show_default="the scene's own")
    ] = None,
    people: Annotated[
        int | None, typer.Option(help="How many.", show_default="the scene's own")
    ] = None,
    seed: options.Seed = 0,
    begin: Annotated[
        float, typer.Option(help="Leave out so many seconds: it begins with people in it.")
    ] = 0.0,
    dim: Annotated[
        float | None,
        typer.Option(help="Second at which a part of the light goes out.", show_default="never"),
    ] = None,
    bump: Annotated[
        float | None,
        typer.Option(help="Second at which the camera is knocked.", show_default="never"),
    ] = None,
    json: options.Json = False,
) -> None:
    """Render a recording of people with exact truth, with one camera or two as the scene has it."""
    from app.cli.synth import SynthRequest, run_synth

    request = SynthRequest(scene, seconds, people, seed, begin, dim, bump)
    run_synth(out, request, as_json=json)

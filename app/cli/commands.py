"""The commands and their options.

What a command does stands in the module of its name and is imported when the command runs, so
that help comes at once and no command waits for libraries it does not use.
"""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path
from typing import Annotated, Literal

import typer

import tracking
from app.cli import options

program = typer.Typer(
    name="trackwright",
    help="A workbench for people tracked in recorded stereo footage.",
    no_args_is_help=True,
    add_completion=False,
    pretty_exceptions_enable=False,
    context_settings={"help_option_names": ["-h", "--help"]},
)

Recording = Annotated[
    Path | None, typer.Argument(help="A recording's folder, a video or an image folder.")
]


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
)
"""Of `tracking.synthesis.SCENES`, which takes too long to import for a page of help."""


def _say_version(asked: bool) -> None:
    if asked:
        print(f"trackwright {tracking.__version__}")
        raise typer.Exit


@program.callback()
def every_command(
    debug: Annotated[bool, typer.Option("--debug", help="Show the traceback of an error.")] = False,
    version: Annotated[
        bool,
        typer.Option(
            "--version", help="Say which one it is.", callback=_say_version, is_eager=True
        ),
    ] = False,
) -> None:
    """A workbench for people tracked in recorded stereo footage."""


@program.command()
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


@program.command(name="open")
def open_window(
    path: Annotated[Path | None, typer.Argument(help="A recording or a session.")] = None,
    left: options.Left = None,
    right: options.Right = None,
    calibration: options.Calibration = None,
    height: options.Height = None,
    tilt: options.Tilt = None,
    roll: options.Roll = None,
    fps: options.Fps = None,
    layout: options.Layout = None,
    first: options.First = None,
    allow_outside: options.Outside = False,
    recording: Annotated[
        Path | None, typer.Option(help="Where a session's recording has moved to.")
    ] = None,
) -> None:
    """Open the window."""
    from app.cli.open_window import run_open
    from app.cli.recordings import Bare

    eyes = Bare(left, right, calibration, height, tilt, roll, fps, layout, first, allow_outside)
    run_open(path, eyes, recording)


@program.command()
def info(
    path: Annotated[Path | None, typer.Argument(help="A recording or a session.")] = None,
    left: options.Left = None,
    right: options.Right = None,
    calibration: options.Calibration = None,
    height: options.Height = None,
    tilt: options.Tilt = None,
    roll: options.Roll = None,
    fps: options.Fps = None,
    layout: options.Layout = None,
    first: options.First = None,
    allow_outside: options.Outside = False,
    json: options.Json = False,
) -> None:
    """Say what a recording or a session holds."""
    from app.cli.info import run_info
    from app.cli.recordings import Bare

    eyes = Bare(left, right, calibration, height, tilt, roll, fps, layout, first, allow_outside)
    run_info(path, eyes, as_json=json)


@program.command()
def synth(
    out: Annotated[Path, typer.Argument(help="The recording's folder, made by this command.")],
    scene: Annotated[str, typer.Option(help=f"Which kind of place: {', '.join(SCENE_NAMES)}.")],
    seconds: Annotated[
        float | None, typer.Option(help="How long.", show_default="the scene's own")
    ] = None,
    people: Annotated[
        int | None, typer.Option(help="How many.", show_default="the scene's own")
    ] = None,
    seed: options.Seed = 0,
    json: options.Json = False,
) -> None:
    """Render a stereo recording of people with exact truth."""
    from app.cli.synth import run_synth

    run_synth(out, scene, seconds, people, seed, as_json=json)


@program.command()
def trackers(json: options.Json = False) -> None:
    """List the trackers and their settings."""
    from app.cli.trackers import run_trackers

    run_trackers(as_json=json)


@program.command()
def track(
    recording: Recording = None,
    out: Annotated[
        Path | None, typer.Option("--out", "-o", help="The session to make: NAME.h5.")
    ] = None,
    tracker: Annotated[
        str | None, typer.Option(help="Its name.", show_default="best for the recording")
    ] = None,
    setting: Annotated[
        list[str] | None, typer.Option("--set", help="KEY=VALUE, see trackers.")
    ] = None,
    frames: Annotated[
        str | None, typer.Option(help="A:B, from 0, B not included.", show_default="all")
    ] = None,
    seed: options.Seed = 0,
    detector: Annotated[Path | None, typer.Option(help="A failure detector made by train.")] = None,
    occluders: Annotated[
        Path | None, typer.Option(help="A session in which what hides people is drawn.")
    ] = None,
    again: options.Again = None,
    start: options.From = None,
    until: options.Until = None,
    accept: options.Accept = False,
    force: options.Force = False,
    left: options.Left = None,
    right: options.Right = None,
    calibration: options.Calibration = None,
    height: options.Height = None,
    tilt: options.Tilt = None,
    roll: options.Roll = None,
    fps: options.Fps = None,
    layout: options.Layout = None,
    first: options.First = None,
    allow_outside: options.Outside = False,
    json: options.Json = False,
) -> None:
    """Run a tracker over a recording, or again from a frame of a corrected session on."""
    from app.cli.recordings import Bare
    from app.cli.track import Order, run_track
    from app.cli.track_again import asked_again, run_track_again

    eyes = Bare(left, right, calibration, height, tilt, roll, fps, layout, first, allow_outside)
    order = Order(tracker, tuple(setting or ()), frames, seed, detector, occluders)
    if (wish := asked_again(again, start, until, accept=accept)) is not None:
        wish = replace(wish, recording=recording or left, out=out, allow_outside=allow_outside)
        run_track_again(wish, order, force=force, as_json=json)
        return
    if out is None:
        raise typer.BadParameter("name the session to make", param_hint="--out")
    run_track(recording, eyes, out, order, force=force, as_json=json)


@program.command()
def score(
    result: Annotated[Path, typer.Argument(help="A session or MOT text.")],
    truth: Annotated[
        Path, typer.Option("--truth", help="A session, MOT text or a recording with truth.txt.")
    ],
    match: Annotated[
        Literal["box", "floor"], typer.Option(help="Pair by overlap or by floor distance.")
    ] = "box",
    radius: Annotated[
        float, typer.Option(help="Greatest distance on the floor, m; with --match floor.")
    ] = 0.5,
    report: Annotated[Path | None, typer.Option(help="A folder for a report.")] = None,
    json: options.Json = False,
) -> None:
    """Measure a result against truth."""
    from app.cli.score import run_score

    run_score(result, truth, match, radius, report, as_json=json)


@program.command()
def compare(
    a: Annotated[Path, typer.Argument(help="A session.")],
    b: Annotated[Path, typer.Argument(help="Another person's session of the same recording.")],
    match: Annotated[
        Literal["either", "box", "floor"],
        typer.Option(help="Pair by overlap, by floor distance, or by whichever fits better."),
    ] = "either",
    radius: Annotated[float, typer.Option(help="Greatest distance on the floor, m.")] = 0.5,
    json: options.Json = False,
) -> None:
    """Say how far two people's sessions agree on who is who."""
    from app.cli.compare import run_compare

    run_compare(a, b, match, radius, as_json=json)


@program.command()
def review(
    session: Annotated[Path, typer.Argument(help="A session.")],
    order: Annotated[
        Literal["yield", "worth", "likelihood", "time"],
        typer.Option(
            help="Yield finds most for the time watched; worth is likelihood times what would be"
            " wrong."
        ),
    ] = "yield",
    most: Annotated[
        int | None, typer.Option(min=1, help="How many at most.", show_default="all")
    ] = None,
    json: options.Json = False,
) -> None:
    """List where a session's tracks are likely wrong, and why."""
    from app.cli.review import run_review

    run_review(session, order, most, as_json=json)


@program.command()
def export(
    session: Annotated[Path, typer.Argument(help="A session.")],
    out: Annotated[Path, typer.Option("--out", "-o", help="The file to make.")],
    file_format: Annotated[
        str,
        typer.Option(
            "--format",
            help="mot; of body parts: labels (CSV), or samples (OUT ends in .csv, .h5, .libsvm).",
        ),
    ],
    run: Annotated[
        int | None,
        typer.Option(min=0, help="A tracker's run, from 0.", show_default="the corrected tracks"),
    ] = None,
    json: options.Json = False,
) -> None:
    """Write a session's tracks for other tools."""
    from app.cli.export import run_export

    run_export(session, out, file_format, run, as_json=json)


@program.command()
def train(
    sources: Annotated[
        list[Path], typer.Argument(help="Sessions with labelled body parts, or samples as CSV.")
    ],
    out: Annotated[Path, typer.Option("--out", "-o", help="The detector to make: NAME.h5.")],
    report: Annotated[
        Path | None, typer.Option(help="A folder for a page with curves and mistakes.")
    ] = None,
    false_alarms: Annotated[
        float,
        typer.Option(min=0.0, max=0.5, help="Share of good parts that may be taken for failed."),
    ] = 0.02,
    from_truth: Annotated[
        bool,
        typer.Option("--from-truth", help="Label by the truth beside rendered recordings instead."),
    ] = False,
    allow_outside: options.Outside = False,
    seed: options.Seed = 0,
    json: options.Json = False,
) -> None:
    """Train the detector of lost body parts from labels."""
    from app.cli.taught import How
    from app.cli.train import Wish, run_train

    how = How(from_truth, allow_outside)
    wish = Wish(tuple(sources), out, report, false_alarms, seed, how)
    run_train(wish, as_json=json)


@program.command()
def import_labels(
    labels: Annotated[
        Path, typer.Argument(help="CSV: frame, track, part, on, and where known a rectangle.")
    ],
    session: Annotated[Path, typer.Argument(help="The session to take them into.")],
    author: Annotated[
        str | None, typer.Option(help="Who gave them, where the table does not say.")
    ] = None,
    json: options.Json = False,
) -> None:
    """Take labels of body parts made elsewhere into a session."""
    from app.cli.import_labels import run_import_labels

    run_import_labels(labels, session, author, as_json=json)


@program.command()
def log(
    session: Annotated[Path, typer.Argument(help="A session.")],
    csv: Annotated[Path | None, typer.Option(help="Write it to this file as CSV.")] = None,
    json: options.Json = False,
) -> None:
    """Print what people did to a session, oldest first; with --json all rows and labels of it."""
    from app.cli.log import run_log

    run_log(session, csv, as_json=json)


@program.command()
def restore(
    session: Annotated[Path, typer.Argument(help="A session.")],
    generation: Annotated[
        int, typer.Option(min=1, help="Which older one: 1 is the one saved last before this.")
    ] = 1,
    only_list: Annotated[
        bool, typer.Option("--list", help="Only list the ones that are kept.")
    ] = False,
    json: options.Json = False,
) -> None:
    """Put an older generation in a session's place; what it is now is kept as the newest one."""
    from app.cli.restore import run_restore

    run_restore(session, generation, only_list=only_list, as_json=json)


@program.command()
def bench(
    only: Annotated[str | None, typer.Option(help="One group of them.")] = None,
    json: options.Json = False,
) -> None:
    """Measure speed, as ratios against peers; from a checkout of the source."""
    from app.cli.bench import run_bench

    run_bench(only, as_json=json)

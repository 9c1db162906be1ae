"""Options that belong together, as values: a command takes the group, not each option of it."""

from __future__ import annotations

import functools
import inspect
from collections.abc import Callable, Iterable, Iterator
from dataclasses import dataclass, fields
from pathlib import Path
from typing import Annotated, Any, Literal, get_type_hints

import typer

from app.cli import completions, options


@dataclass(frozen=True, slots=True)
class Bare:
    """What the options say about a recording without recording.toml; None where they are silent.

    Attributes:
        left, right: videos. calibration: one or two files.
        height, tilt, roll: where the floor is, m and degrees.
        fps: of images. layout, first: of a video that holds both cameras.
        region, mask: outlines x,y:x,y:x,y within which alone, or never, people are looked for.
        allow_outside: follow paths out of the recording's folder.
    """

    left: options.Left = None
    right: options.Right = None
    calibration: options.Calibration = None
    height: options.Height = None
    tilt: options.Tilt = None
    roll: options.Roll = None
    fps: options.Fps = None
    layout: options.Layout = None
    first: options.First = None
    region: options.LookRegion = None
    mask: options.LookMask = None
    allow_outside: options.Outside = False


@dataclass(frozen=True, slots=True)
class TrackerChoice:
    """The tracker that is wanted, as typed.

    Attributes:
        tracker: name; None: the best one for the recording.
        setting: KEY=VALUE each. seed: of all random numbers. detector: of part failures.
        model: a network that finds people.
    """

    tracker: Annotated[
        str | None,
        typer.Option(
            help="Name of the tracker.",
            show_default="best for the recording",
            autocompletion=completions.complete_trackers,
        ),
    ] = None
    setting: Annotated[
        list[str] | None,
        typer.Option(
            "--set",
            help="KEY=VALUE; trackwright trackers lists the settings.",
            autocompletion=completions.complete_settings,
        ),
    ] = None
    seed: options.Seed = 0
    detector: Annotated[
        Path | None, typer.Option(help="A part-failure detector made by train.")
    ] = None
    model: Annotated[
        Path | None,
        typer.Option(
            help="A network that finds people, of all cameras: the TOML beside an ONNX file, or "
            "their folder."
        ),
    ] = None


@dataclass(frozen=True, slots=True)
class Order(TrackerChoice):
    """What is to be tracked and how, as typed.

    Attributes:
        frames: A:B; None: all. occluders: a session in which they are drawn.
        detections, detections_right: boxes of another program, of the left (or only) camera and of
            the right one.
    """

    frames: Annotated[
        str | None, typer.Option(help="Frames A:B, counted from 0, without B.", show_default="all")
    ] = None
    occluders: Annotated[Path | None, typer.Option(help="A session with drawn occluders.")] = None
    detections: Annotated[
        Path | None,
        typer.Option(
            help="Boxes of another program: MOT det.txt, COCO JSON or a folder of YOLO text; of "
            "the left camera."
        ),
    ] = None
    detections_right: Annotated[Path | None, typer.Option(help="The same of the right camera.")] = (
        None
    )


@dataclass(frozen=True, slots=True)
class EachRecording:
    """What is taken from and made of each recording of a batch, as typed.

    Attributes:
        detections, detections_right: patterns of files of boxes, of both cameras.
        export: names of formats. no_pages: no page on each score.
    """

    detections: Annotated[
        str | None,
        typer.Option(
            help="Boxes of another program: a file in each recording's folder, or a path with "
            "{folder}, {name} or {stem}; * fits one file."
        ),
    ] = None
    detections_right: Annotated[str | None, typer.Option(help="The same of the right camera.")] = (
        None
    )
    export: Annotated[
        list[str] | None,
        typer.Option(help="Write the tracks in this format, too; may be repeated."),
    ] = None
    no_pages: Annotated[
        bool,
        typer.Option("--no-pages", help="Score, but write no page on each score."),
    ] = False


_SHARING = "How the work is shared out"


@dataclass(frozen=True, slots=True)
class Sharing:
    """Who works on a batch, as typed.

    Attributes:
        workers: None: one for each core. scheduler: of a cluster; None: this machine.
        shard: "i/n"; None: all. job_array: print a script for so many shards instead; None: work.
    """

    workers: Annotated[
        int | None,
        typer.Option(
            min=1,
            help="Processes on this machine, of one thread each.",
            show_default="one for each core",
            rich_help_panel=_SHARING,
        ),
    ] = None
    scheduler: Annotated[
        str | None,
        typer.Option(
            help="Address of a Dask scheduler, such as tcp://host:8786.", rich_help_panel=_SHARING
        ),
    ] = None
    shard: Annotated[
        str | None,
        typer.Option(
            help="i/n: work on the i-th of n parts; others work on the other parts.",
            rich_help_panel=_SHARING,
        ),
    ] = None
    job_array: Annotated[
        int | None,
        typer.Option(
            min=1,
            help="Print a SLURM script that does this with so many shards, and do nothing else.",
            rich_help_panel=_SHARING,
        ),
    ] = None


_COST = "What one recording may cost"


@dataclass(frozen=True, slots=True)
class Cost:
    """What one recording of a batch may cost, as typed; 0: no limit, None: the usual one."""

    time_limit: Annotated[
        float | None,
        typer.Option(min=0, help="Longest time, s.", show_default="none", rich_help_panel=_COST),
    ] = None
    stall_limit: Annotated[
        float,
        typer.Option(
            min=0, help="Longest time without progress, s; 0: any.", rich_help_panel=_COST
        ),
    ] = 1800.0
    memory_limit: Annotated[
        int | None,
        typer.Option(
            min=0,
            help="Most memory, MB; 0: any.",
            show_default="an equal part of the machine's",
            rich_help_panel=_COST,
        ),
    ] = None


_BOARD = "The board"


@dataclass(frozen=True, slots=True)
class BoardSquares:
    """What is on a board, as typed: its kind, its square and its marker in m, its dictionary."""

    square: Annotated[
        float | None,
        typer.Option(
            help="Side of a square, or distance of two circles, m; needed for two cameras, and "
            "for a floor.",
            rich_help_panel=_BOARD,
        ),
    ] = None
    kind: Annotated[
        Literal["chessboard", "charuco", "circles", "asymmetric-circles"],
        typer.Option(help="What is on the board.", rich_help_panel=_BOARD),
    ] = "chessboard"
    marker: Annotated[
        float | None,
        typer.Option(
            help="Side of a ChArUco marker, m.",
            show_default="three quarters of a square",
            rich_help_panel=_BOARD,
        ),
    ] = None
    dictionary: Annotated[
        str,
        typer.Option(
            help="Dictionary of the ChArUco markers, as 5X5_100.",
            show_default="found",
            rich_help_panel=_BOARD,
        ),
    ] = ""


_ROUGH = "Without a board"


@dataclass(frozen=True, slots=True)
class Roughly:
    """How to calibrate without a board, as typed: field of view in degrees, distance in m."""

    rough: Annotated[
        bool,
        typer.Option(
            "--rough",
            help="No board: find from matched points how two cameras stand, or take one to have no "
            "distortion. Metres are rough.",
            rich_help_panel=_ROUGH,
        ),
    ] = False
    fov: Annotated[
        float | None,
        typer.Option(
            help="Horizontal field of view, degrees.",
            show_default="65, as of most cameras",
            rich_help_panel=_ROUGH,
        ),
    ] = None
    baseline: Annotated[
        float | None,
        typer.Option(help="Distance of the two cameras, m.", rich_help_panel=_ROUGH),
    ] = None


@dataclass(frozen=True, slots=True)
class Onward:
    """From where to track again, as typed; see `options`."""

    again: options.Again = None
    start: options.From = None
    until: options.Until = None
    accept: options.Accept = False


_PICTURE = "In the image, where there is no calibration"


@dataclass(frozen=True, slots=True)
class OnFloor:
    """Lines and regions on the floor, as typed.

    Attributes:
        line: NAME:x1,y1:x2,y2 each. region: NAME:x,y:x,y:x,y... each.
        jitter: what is no passage, m.
    """

    line: Annotated[
        list[str] | None,
        typer.Option(
            help="NAME:x1,y1:x2,y2 on the floor, m. Seen from the first point towards the second,"
            " forward is from left to right.",
            show_default="drawn in the session",
        ),
    ] = None
    region: Annotated[
        list[str] | None,
        typer.Option(
            help="NAME:x,y:x,y:x,y... on the floor, m.", show_default="drawn in the session"
        ),
    ] = None
    jitter: Annotated[
        float,
        typer.Option(help="Ignore re-crossings within this distance of a line, m."),
    ] = 0.0


@dataclass(frozen=True, slots=True)
class InPicture:
    """The same in the left picture as recorded, px."""

    picture_line: Annotated[
        list[str] | None,
        typer.Option(
            help="NAME:u1,v1:u2,v2 in px of the left image; the foot of a box must cross it.",
            rich_help_panel=_PICTURE,
        ),
    ] = None
    picture_region: Annotated[
        list[str] | None,
        typer.Option(help="NAME:u,v:u,v:u,v... in px.", rich_help_panel=_PICTURE),
    ] = None
    jitter_px: Annotated[
        float, typer.Option(help="The same for lines in the image, px.", rich_help_panel=_PICTURE)
    ] = 0.0


def expand_groups(command: Callable[..., None]) -> Callable[..., None]:
    """The command with the options of a group, one by one, in the place of each group it takes.

    A parameter is a group where its type is one of this module's.
    """
    own = inspect.signature(command, eval_str=True)
    groups = {p.name: p.annotation for p in own.parameters.values() if _is_group(p.annotation)}

    @functools.wraps(command)
    def obey(**typed: Any) -> None:
        for name, group in groups.items():
            typed[name] = group(**{each.name: typed.pop(each.name) for each in fields(group)})
        command(**typed)

    listed = list(_options_of(own.parameters.values()))
    obey.__signature__ = own.replace(parameters=listed)  # type: ignore[attr-defined] # read by typer
    return obey


def _is_group(annotation: Any) -> bool:
    return isinstance(annotation, type) and annotation.__module__ == __name__


def _options_of(parameters: Iterable[inspect.Parameter]) -> Iterator[inspect.Parameter]:
    for parameter in parameters:
        keyword = parameter.replace(kind=inspect.Parameter.KEYWORD_ONLY)
        if not _is_group(parameter.annotation):
            yield keyword
            continue
        kinds = get_type_hints(parameter.annotation, include_extras=True)
        for each in fields(parameter.annotation):
            yield keyword.replace(name=each.name, default=each.default, annotation=kinds[each.name])

"""Options that belong together, as values: a command takes the group, not each option of it."""

from __future__ import annotations

import functools
import inspect
from collections.abc import Callable, Iterable, Iterator
from dataclasses import dataclass, fields
from pathlib import Path
from typing import Annotated, Any, get_type_hints

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
class Order:
    """What is to be tracked and how, as typed.

    Attributes:
        tracker: name; None: the best one for the recording.
        setting: KEY=VALUE each. frames: A:B; None: all. seed: of all random numbers.
        detector: of part failures. occluders: a session in which they are drawn.
        detections, detections_right: boxes of another program, of the left (or only) camera and of
            the right one.
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
    frames: Annotated[
        str | None, typer.Option(help="Frames A:B, counted from 0, without B.", show_default="all")
    ] = None
    seed: options.Seed = 0
    detector: Annotated[
        Path | None, typer.Option(help="A part-failure detector made by train.")
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
    model: Annotated[
        Path | None,
        typer.Option(
            help="A network that finds people, of all cameras: the TOML beside an ONNX file, or "
            "their folder."
        ),
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

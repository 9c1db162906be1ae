"""`setup`: cameras found, and recording.toml written beside them."""

from __future__ import annotations

import shlex
from dataclasses import dataclass, replace
from pathlib import Path
from typing import Any, Literal

import typer

from app.cli.floor import as_document as floor_as_document
from app.cli.floor import rows_of_floor
from app.cli.option_groups import Bare
from app.cli.output import print_json, print_line, print_table, progress, say
from app.cli.recordings import options_of
from tracking.calibration.floor import (
    FloorEstimate,
    floor_by_people,
    floor_by_stereo,
    with_calibration,
)
from tracking.errors import RecordingError
from tracking.people.first_lag import first_lag
from tracking.recording import MANIFEST_NAME, OpenOptions, open_recording
from tracking.recording.image_pairs import Side
from tracking.setup import CameraFindings, SetupPlan, find_cameras, pair_by_name, write_setup
from tracking.setup.files import calibration_beside, is_container, sources_in
from tracking.setup.plan import (
    CALIBRATION_NAME,
    options_of_plan,
    plan_of_container,
    plan_of_known,
    setup_text,
    with_lag,
)
from tracking.translation import Message, msg, tr


@dataclass(frozen=True, slots=True)
class SetupRequest:
    """What was typed.

    Attributes:
        sources: files or a folder. name: of the recording. lag: None: found.
        as_given: nothing is found. floor: how it is found; None: as given. force: replace.
    """

    sources: tuple[Path, ...]
    name: str
    lag: int | None
    as_given: bool
    floor: Literal["stereo", "people"] | None
    force: bool


def run_setup(request: SetupRequest, bare: Bare, *, as_json: bool) -> None:
    """Find what is to be found, write the manifest, and tell."""
    given = options_of(bare)
    plan, found = _cameras(request, given)
    plan = _as_typed(plan, request, given)
    target = plan.folder / MANIFEST_NAME
    if target.exists() and not request.force:
        raise RecordingError(
            "{path} exists; open that recording, or replace it", option="--force", path=target
        )
    for note in (*found.notes, *found.doubts, *plan.notes):
        say(note)
    if found.same_scene is False:
        raise RecordingError(
            "{left} and {right} do not show the same place; give a pair, or take them as they are",
            option="--as-given",
            left=found.left,
            right=found.right,
        )
    plan, floor = _completed(plan, request)
    text, copied = setup_text(plan), plan.calibration_file
    path = write_setup(plan, replace_old=request.force)
    if as_json:
        print_json({"recording": str(path.parent), **_document(plan, found, floor)})
        return
    for line in text.splitlines():
        print_line(line)
    if floor is not None:
        print_line("")
        print_table(rows_of_floor(floor))
    say(msg("written: {path}", path=path))
    if copied is not None:
        say(msg("written: {path}", path=copied))
        if copied.name != CALIBRATION_NAME:
            say(msg("{name} there is another one, and stays", name=CALIBRATION_NAME))
    say(_next_step(plan, path.parent))


def _next_step(plan: SetupPlan, folder: Path) -> Message:
    """The command that comes next: what metres still lack, else the window."""
    quoted = shlex.quote(str(folder))
    if not plan.calibration:
        way = "stereo" if plan.is_stereo else "people"
        again = f"trackwright setup {quoted} --floor {way} --force"
        return msg(
            "next, for metres: trackwright calibrate, from a board or with --rough from these "
            "videos, -o {file}; then {again}. Without metres: trackwright open {folder}",
            file=shlex.quote(str(folder / CALIBRATION_NAME)),
            again=again,
            folder=quoted,
        )
    if plan.ground is None:
        return msg("next: trackwright floor {folder} --write, for metres", folder=quoted)
    return msg("next: trackwright open {folder}", folder=quoted)


def _cameras(request: SetupRequest, given: OpenOptions) -> tuple[SetupPlan, CameraFindings]:
    """The sources as a plan, by what the files show, or as given."""
    old = request.sources[0] if len(request.sources) == 1 else None
    known = None
    if old is not None and given.left is None:
        known = plan_of_known(old, OpenOptions(fps=given.fps))
    if old is not None and known is not None:
        known = _as_asked(known, given)
        if is_container(old):
            return known, find_cameras(old, None)
        return known, CameraFindings(known.left, known.right)
    left, right = _files(request, given)
    if right is None and is_container(left):
        plan = plan_of_container(left, OpenOptions(fps=given.fps))
        return plan, find_cameras(left, None)
    if request.as_given or given.layout is not None:
        found = CameraFindings(left, right, given.layout)
    else:
        with progress(msg("looking at the cameras")):
            found = find_cameras(left, right)
    first: Side = "left" if found.left_first else "right"
    plan = SetupPlan(found.left, found.right, layout=found.layout, first=given.first or first)
    return plan, found


def _as_asked(known: SetupPlan, given: OpenOptions) -> SetupPlan:
    """What is set up again, with how one video holds both cameras as it was typed now."""
    if given.layout is None and given.first is None:
        return known
    if known.right is not None:
        raise RecordingError(
            "{path}: has a source for each camera; leave --layout and --first out",
            path=known.folder,
        )
    return replace(known, layout=given.layout or known.layout, first=given.first or known.first)


def _files(request: SetupRequest, given: OpenOptions) -> tuple[Path, Path | None]:
    sources = request.sources
    if given.left is not None:
        return given.left, given.right
    if len(sources) == 1 and sources[0].is_dir():
        sources = sources_in(sources[0])
    if not sources:
        raise typer.BadParameter(msg("name one or two videos, or a folder with them"))
    for path in sources:
        if not path.exists() and not any(sign in path.name for sign in "*?["):
            raise RecordingError("{path}: no such file; check the path", path=path)
    if len(sources) == 1:
        return sources[0], None
    pair = pair_by_name(sources)
    if pair is not None:
        return pair.left, pair.right
    if len(sources) == 2:
        return sources[0], sources[1]
    raise RecordingError(
        "{count} files are given, and by their names no two are a pair; name the two with --left "
        "and --right",
        count=len(sources),
    )


def _as_typed(plan: SetupPlan, request: SetupRequest, given: OpenOptions) -> SetupPlan:
    """The plan with what was typed in place of what was found."""
    return replace(
        plan,
        name=request.name or plan.name,
        lag=plan.lag if request.lag is None else request.lag,
        fps=given.rate(plan.fps),
        calibration=given.calibration or plan.calibration or _beside(plan, request),
        ground=given.ground(plan.ground),
        region=given.region(plan.region),
    )


def _beside(plan: SetupPlan, request: SetupRequest) -> tuple[Path, ...]:
    if request.as_given:
        return ()
    found, told = calibration_beside(plan.left)
    for note in told:
        say(note)
    return found


def _completed(plan: SetupPlan, request: SetupRequest) -> tuple[SetupPlan, FloorEstimate | None]:
    """The plan with lag and floor as they are found, checked by opening the recording."""
    with open_recording(plan.folder, options_of_plan(plan)) as recording:
        if recording.is_stereo and request.lag is None and not request.as_given:
            with progress(msg("looking for the lag")):
                lag = first_lag(recording)
            if lag:
                say(msg("the right camera is {lag} frames late", lag=lag))
            plan = with_lag(plan, lag)
    if request.floor is None:
        return plan, None
    with open_recording(plan.folder, options_of_plan(plan)) as recording:
        find = floor_by_stereo if request.floor == "stereo" else floor_by_people
        with progress(msg("finding the floor")) as tell:
            found: FloorEstimate = find(recording, tell)
            estimate = with_calibration(found, recording.calibration)
    for note in estimate.notes:
        say(note)
    return replace(plan, ground=estimate.ground), estimate


def _document(
    plan: SetupPlan, found: CameraFindings, floor: FloorEstimate | None
) -> dict[str, Any]:
    ground = plan.ground
    return {
        "left": str(plan.left),
        "right": str(plan.right) if plan.right else None,
        "layout": plan.layout,
        "first": plan.first if plan.layout else None,
        "swapped": found.swapped,
        "lag": plan.lag or 0,
        "ground": ground
        and {"height": ground.height_m, "tilt": ground.tilt_deg, "roll": ground.roll_deg},
        "floor": None if floor is None else floor_as_document(floor),
        "notes": [tr(note) for note in found.notes],
        "doubts": [tr(doubt) for doubt in found.doubts],
    }

"""Writes a scene as a recording folder, with its truth beside it."""

from __future__ import annotations

import contextlib
from collections.abc import Callable
from pathlib import Path

import cv2
import numpy as np

from tracking.arrays import Float32s
from tracking.atomic_output import replacing_folder
from tracking.errors import CancelledError, OutputError, SettingsError
from tracking.formats import write_mot
from tracking.geometry import write_calibration
from tracking.progress import Progress
from tracking.recording import Manifest, write_manifest
from tracking.recording.depth_pictures import USUAL_SCALE_M
from tracking.synthesis.disturbances import NO_DISTURBANCES, Disturbances
from tracking.synthesis.scenario import EVERYBODY
from tracking.synthesis.scene import Scene
from tracking.synthesis.scenes import SCENES
from tracking.synthesis.specs import SceneSpec
from tracking.synthesis.truth import CARED_FOR, SceneTruth
from tracking.synthesis.video import VideoWriter
from tracking.tracks import PART_WORDS
from tracking.translation import joined
from tracking.truth import TRUE_PART_COLUMNS, TRUE_PARTS, VISIBILITY, VISIBILITY_COLUMNS

MOST_PEOPLE, LONGEST_S = 200, 3600.0
_SIDES = ("left", "right")


FLOOR, MOMENTS = "floor.csv", "moments.csv"
DEPTH = "depth"
"""The folder of depth images."""


def render_recording(
    folder: Path,
    scene: str | SceneSpec,
    seconds: float | None = None,
    people: int | None = None,
    seed: int = 0,
    progress: Progress | None = None,
    cancelled: Callable[[], bool] | None = None,
    *,
    size: tuple[int, int] | None = None,
    fps: float | None = None,
    cameras: int | None = None,
    disturbances: Disturbances = NO_DISTURBANCES,
    depth: bool = False,
) -> Path:
    """Render a scene into a recording folder with exact truth.

    Nothing stands under `folder` before all of it is written.

    Args:
        folder: where; missing or empty.
        scene: a name in `SCENES`, or a scene of one's own.
        seconds, people: length and number of passers-by; the scene's own if None.
        seed: equal seeds give equal pictures and truth.
        progress: called after each frame.
        cancelled: asked before each frame; True stops.
        size: width and height of the images in px, even; the scene's own if None.
        fps: frames a second; the scene's own if None.
        cameras: 2, or 1 for a recording of the left camera alone; the scene's own if None.
        disturbances: what is out of the ordinary.
        depth: write exact depth beside the left camera, and no right camera.

    Returns:
        The folder.

    Raises:
        SettingsError: there is no such scene, or a number is out of range.
        OutputError: the folder holds something or cannot be written.
        CancelledError: `cancelled` said so.
    """
    spec = _spec_of(scene)
    cameras = 1 if depth else cameras
    fps, cameras = spec.fps if fps is None else fps, spec.cameras if cameras is None else cameras
    _check(seconds, people, spec.size_px if size is None else size, fps, cameras)
    _check_begin(spec, seconds, disturbances)
    with replacing_folder(folder) as part:
        rendered = Scene(
            spec,
            people,
            seed,
            seconds=seconds,
            size=size,
            fps=fps,
            cameras=cameras,
            disturbances=disturbances,
        )
        _write(part, rendered, seed, progress, cancelled, depth=depth)
    return folder


def _spec_of(scene: str | SceneSpec) -> SceneSpec:
    if isinstance(scene, SceneSpec):
        return scene
    if scene not in SCENES:
        raise SettingsError(
            "there is no scene {scene!r}; choose one of {scenes}",
            scene=scene,
            scenes=joined(", ", SCENES),
        )
    return SCENES[scene]


def check_seconds(seconds: float | None) -> None:
    """Raises `SettingsError` for a length no recording can have; None is the scene's own."""
    if seconds is not None and not 0 < seconds <= LONGEST_S:
        raise SettingsError(
            "seconds is {seconds:g}; give more than 0 and up to {longest_s:g}",
            seconds=seconds,
            longest_s=LONGEST_S,
        )


def _check(
    seconds: float | None, people: int | None, size: tuple[int, int], fps: float, cameras: int
) -> None:
    check_seconds(seconds)
    if people is not None and not 0 <= people <= MOST_PEOPLE:
        raise SettingsError(
            "people is {people}; give 0 to {most_people}", people=people, most_people=MOST_PEOPLE
        )
    if not all(32 <= side <= 4096 and side % 2 == 0 for side in size):
        raise SettingsError(
            "size is {width} x {height}; give even numbers from 32 to 4096",
            width=size[0],
            height=size[1],
        )
    if not 1 <= fps <= 240:
        raise SettingsError("fps is {fps:g}; give 1 to 240", fps=fps)
    if cameras not in (1, 2):
        raise SettingsError("cameras is {cameras}; give 1 or 2", cameras=cameras)


def _check_begin(spec: SceneSpec, seconds: float | None, disturbances: Disturbances) -> None:
    if seconds is None and disturbances.begin_s >= spec.seconds:
        raise SettingsError(
            "begin is {begin_s:g}, but the scene {tracker} lasts {seconds:g} seconds; begin "
            "earlier or give seconds",
            begin_s=disturbances.begin_s,
            tracker=spec.name,
            seconds=spec.seconds,
        )


def _write(
    folder: Path,
    scene: Scene,
    seed: int,
    progress: Progress | None,
    cancelled: Callable[[], bool] | None,
    *,
    depth: bool,
) -> None:
    truths: list[SceneTruth] = []
    size = scene.rig.size
    with contextlib.ExitStack() as open_files:
        videos = [
            open_files.enter_context(VideoWriter(folder / f"{side}.mp4", size, scene.fps))
            for side in _SIDES[: scene.cameras]
        ]
        for number in range(scene.frames):
            if cancelled is not None and cancelled():
                raise CancelledError("rendering was stopped; nothing was kept")
            frame, truth = scene.frame(number)
            for video, image in zip(videos, (frame.left, frame.right), strict=False):
                if image is not None:
                    video.write(image)
            if depth:
                write_depth(folder, number, scene.depth(number))
            truths.append(truth)
            if progress is not None:
                progress(number + 1, scene.frames)
    write_truth(folder, truths)
    if scene.spec.scenario or scene.spec.passage is not None:
        write_scenario(folder, scene)
    _write_descriptions(folder, scene, seed, depth=depth)


def write_depth(folder: Path, number: int, depth_m: Float32s) -> None:
    """Write a frame's depth (height, width) m as an image of 16 bits, in mm; 0 beyond 65 m."""
    units = np.rint(depth_m / USUAL_SCALE_M)
    units = np.where(units < np.iinfo(np.uint16).max, units, 0).astype(np.uint16)
    path = folder / DEPTH / f"{number:06d}.png"
    path.parent.mkdir(exist_ok=True)
    fast = (cv2.IMWRITE_PNG_COMPRESSION, 1)
    if not cv2.imwrite(str(path), units, fast):
        raise OutputError("cannot write {path}; make room on the disk", path=path)


def _write_descriptions(folder: Path, scene: Scene, seed: int, *, depth: bool) -> None:
    write_calibration(folder / "calibration.yaml", scene.rig.calibration)
    manifest = Manifest(
        name=f"{scene.spec.name} {seed}",
        left="left.mp4",
        right="right.mp4" if scene.cameras == 2 else None,
        depth=f"{DEPTH}/*.png" if depth else None,
        fps=scene.fps,
        calibration=("calibration.yaml",),
        ground=scene.rig.view.ground,
    )
    write_manifest(folder, manifest)


def write_scenario(folder: Path, scene: Scene) -> None:
    """Write `floor.csv` and, of a scene with a scenario, `moments.csv`.

    `floor.csv`: frame (from 0), id, x, y in metres of everybody on the floor, in view or not.
    `moments.csv`: start and end (frames from 0, half-open), id (0: everybody), kind, name,
    difficulty (0: not rated).
    """
    _write_floor(folder / FLOOR, scene)
    if scene.moments():
        _write_moments(folder / MOMENTS, scene)


def _write_floor(path: Path, scene: Scene) -> None:
    with path.open("w", encoding="utf-8", newline="\n") as stream:
        stream.write("frame,id,x,y\n")
        for frame in range(scene.frames):
            there = scene.on_floor(frame)
            for person, (x, y) in zip(there, scene.places(frame), strict=True):
                stream.write(f"{frame},{person + 1},{x:.4f},{y:.4f}\n")


def _write_moments(path: Path, scene: Scene) -> None:
    with path.open("w", encoding="utf-8", newline="\n") as stream:
        stream.write("start,end,id,kind,name,difficulty\n")
        for moment in scene.moments():
            seconds = moment.start_s, moment.end_s
            start, end = (min(max(round(s * scene.fps), 0), scene.frames) for s in seconds)
            if start == end:
                continue
            who = 0 if moment.person == EVERYBODY else moment.person + 1
            name = f'"{moment.name}"' if "," in moment.name else moment.name
            stream.write(f"{start},{end},{who},{moment.kind},{name},{moment.difficulty}\n")


def write_truth(folder: Path, truths: list[SceneTruth]) -> None:
    """Write the truth of all frames into a recording's folder: tracks, visibility, body parts."""
    counts = [len(truth) for truth in truths]
    frame = np.repeat(np.arange(len(truths), dtype=np.int32), counts)
    box = np.concatenate([truth.box for truth in truths])
    position = np.concatenate([truth.position for truth in truths])
    visibility = np.concatenate([truth.visibility for truth in truths])
    columns = {
        "frame": frame,
        "track": np.concatenate([truth.track for truth in truths]),
        "left": box[:, 0].round(2),
        "top": box[:, 1].round(2),
        "width": box[:, 2].round(2),
        "height": box[:, 3].round(2),
        "confidence": (visibility >= CARED_FOR).astype(np.float64),
        "x": position[:, 0].round(4),
        "y": position[:, 1].round(4),
        "z": np.zeros(len(frame)),
    }
    write_mot(folder / "truth.txt", columns)
    _write_visibility(folder / VISIBILITY, truths)
    _write_parts(folder / TRUE_PARTS, truths)


def _write_visibility(path: Path, truths: list[SceneTruth]) -> None:
    with path.open("w", encoding="utf-8", newline="\n") as stream:
        stream.write(",".join(VISIBILITY_COLUMNS) + "\n")
        for frame, truth in enumerate(truths):
            for track, share in zip(truth.track, truth.visibility, strict=True):
                stream.write(f"{frame},{track},{share:.4f}\n")


def _write_parts(path: Path, truths: list[SceneTruth]) -> None:
    with path.open("w", encoding="utf-8", newline="\n") as stream:
        stream.write(",".join(TRUE_PART_COLUMNS) + "\n")
        for frame, truth in enumerate(truths):
            for row, track in enumerate(truth.track):
                for part, name in enumerate(PART_WORDS):
                    box = ",".join(f"{value:.2f}" for value in truth.part_box[row, part])
                    pixels = truth.part_pixels[row, part]
                    stream.write(f"{frame},{track},{name},{box},{pixels}\n")

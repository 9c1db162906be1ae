"""Writes a scene as a recording folder, with its truth beside it."""

from __future__ import annotations

import contextlib
from collections.abc import Callable
from pathlib import Path

from tracking.atomic_output import replacing_folder
from tracking.errors import CancelledError, SettingsError
from tracking.geometry import write_calibration
from tracking.progress import Progress
from tracking.recording import Manifest, write_manifest
from tracking.synthesis.disturbances import NO_DISTURBANCES, Disturbances
from tracking.synthesis.scenario_writing import write_scenario
from tracking.synthesis.scene import Scene
from tracking.synthesis.scenes import SCENES
from tracking.synthesis.specs import SceneSpec
from tracking.synthesis.truth import SceneTruth
from tracking.synthesis.truth_writing import write_truth
from tracking.synthesis.video import VideoWriter

MOST_PEOPLE, LONGEST_S = 200, 3600.0
_SIDES = ("left", "right")


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

    Returns:
        The folder.

    Raises:
        SettingsError: there is no such scene, or a number is out of range.
        OutputError: the folder holds something or cannot be written.
        CancelledError: `cancelled` said so.
    """
    spec = _spec_of(scene)
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
        _write(part, rendered, seed, progress, cancelled)
    return folder


def _spec_of(scene: str | SceneSpec) -> SceneSpec:
    if isinstance(scene, SceneSpec):
        return scene
    if scene not in SCENES:
        raise SettingsError(f"there is no scene {scene!r}; choose one of {', '.join(SCENES)}")
    return SCENES[scene]


def check_seconds(seconds: float | None) -> None:
    """Raises `SettingsError` for a length no recording can have; None is the scene's own."""
    if seconds is not None and not 0 < seconds <= LONGEST_S:
        raise SettingsError(f"seconds is {seconds:g}; give more than 0 and up to {LONGEST_S:g}")


def _check(
    seconds: float | None, people: int | None, size: tuple[int, int], fps: float, cameras: int
) -> None:
    check_seconds(seconds)
    if people is not None and not 0 <= people <= MOST_PEOPLE:
        raise SettingsError(f"people is {people}; give 0 to {MOST_PEOPLE}")
    if not all(32 <= side <= 4096 and side % 2 == 0 for side in size):
        raise SettingsError(f"size is {size[0]} x {size[1]}; give even numbers from 32 to 4096")
    if not 1 <= fps <= 240:
        raise SettingsError(f"fps is {fps:g}; give 1 to 240")
    if cameras not in (1, 2):
        raise SettingsError(f"cameras is {cameras}; give 1 or 2")


def _check_begin(spec: SceneSpec, seconds: float | None, disturbances: Disturbances) -> None:
    if seconds is None and disturbances.begin_s >= spec.seconds:
        raise SettingsError(
            f"begin is {disturbances.begin_s:g}, but the scene {spec.name} lasts "
            f"{spec.seconds:g} seconds; begin earlier or give seconds"
        )


def _write(
    folder: Path,
    scene: Scene,
    seed: int,
    progress: Progress | None,
    cancelled: Callable[[], bool] | None,
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
            truths.append(truth)
            if progress is not None:
                progress(number + 1, scene.frames)
    write_truth(folder, truths)
    if scene.spec.scenario or scene.spec.passage is not None:
        write_scenario(folder, scene)
    _write_descriptions(folder, scene, seed)


def _write_descriptions(folder: Path, scene: Scene, seed: int) -> None:
    write_calibration(folder / "calibration.yaml", scene.rig.calibration)
    manifest = Manifest(
        name=f"{scene.spec.name} {seed}",
        left="left.mp4",
        right="right.mp4" if scene.cameras == 2 else None,
        fps=scene.fps,
        calibration=("calibration.yaml",),
        ground=scene.rig.view.ground,
    )
    write_manifest(folder, manifest)

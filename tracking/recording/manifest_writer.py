"""recording.toml as it is written; `manifest` reads it."""

from __future__ import annotations

from pathlib import Path

from tracking.atomic_output import replace_with
from tracking.errors import OutputError
from tracking.recording.manifest import FORMAT, MANIFEST_NAME, Manifest
from tracking.recording.region_of_interest import Outline


def format_manifest(manifest: Manifest) -> str:
    """The text of recording.toml; reading it gives the manifest again."""
    lines = [f"format = {FORMAT}", f"name = {_quoted(manifest.name)}"]
    if manifest.fps is not None:
        lines.append(f"fps = {manifest.fps!r}")
    if manifest.layout is not None:
        lines += ["", "[stereo]", f"source = {_quoted(manifest.left)}"]
        lines += [f"layout = {_quoted(manifest.layout)}", f"first = {_quoted(manifest.first)}"]
    else:
        lines += ["", "[left]", f"source = {_quoted(manifest.left)}", *_topic(manifest, 0)]
    if manifest.right is not None:
        lines += ["", "[right]", f"source = {_quoted(manifest.right)}", *_topic(manifest, 1)]
    if manifest.right_lag is not None and (manifest.right or manifest.layout):
        lines.append(f"lag = {manifest.right_lag}")
    if manifest.depth is not None:
        lines += ["", "[depth]", f"source = {_quoted(manifest.depth)}", *_topic(manifest, 2)]
        lines.append(f"scale = {manifest.depth_scale_m!r}")
    if manifest.calibration:
        files = [_quoted(file) for file in manifest.calibration]
        listed = files[0] if len(files) == 1 else f"[{', '.join(files)}]"
        lines += ["", "[calibration]", f"file = {listed}"]
    if manifest.ground is not None:
        ground = manifest.ground
        lines += ["", "[ground]", f"height = {float(ground.height_m)!r}"]
        lines += [f"tilt = {float(ground.tilt_deg)!r}", f"roll = {float(ground.roll_deg)!r}"]
    if manifest.region:
        lines += ["", "[region]"]
        lines += [f"look = {_listed(manifest.region.look)}"] if manifest.region.look else []
        lines += [f"mask = {_listed(manifest.region.mask)}"] if manifest.region.mask else []
    return "\n".join(lines) + "\n"


def _topic(manifest: Manifest, place: int) -> list[str]:
    topic = manifest.topics[place]
    return [f"topic = {_quoted(topic)}"] if topic else []


def write_manifest(folder: Path, manifest: Manifest) -> None:
    """Write a folder's recording.toml, whole or not at all; OutputError where that fails."""
    try:
        replace_with(folder / MANIFEST_NAME, format_manifest(manifest).encode())
    except OutputError as error:
        raise error.advising("choose another folder") from error


def _listed(outlines: tuple[Outline, ...]) -> str:
    """A TOML list of polygons."""
    return repr([[[float(x), float(y)] for x, y in outline] for outline in outlines])


def _quoted(text: str) -> str:
    """A TOML basic string."""
    escaped = text.replace("\\", "\\\\").replace('"', '\\"')
    plain = "".join(c if c.isprintable() else f"\\U{ord(c):08x}" for c in escaped)
    return f'"{plain}"'

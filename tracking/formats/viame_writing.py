"""VIAME's CSV, written; see `viame` for the layout."""

from __future__ import annotations

import io
from collections.abc import Iterator
from pathlib import Path

import numpy as np

import tracking
from tracking.atomic_output import replacing
from tracking.cells import CsvWriter
from tracking.formats.cvat_track import is_occluded
from tracking.formats.label_text import kind_of
from tracking.formats.number_text import short_decimals
from tracking.formats.row_rules import BOX
from tracking.formats.track_writer import Exported
from tracking.formats.viame_class import cell_of_class, cells_of_label
from tracking.progress import Progress
from tracking.tracks import Columns

_HEADER = (
    "# 1: Detection or Track-id",
    "2: Video or Image Identifier",
    "3: Unique Frame Identifier",
    "4-7: Img-bbox(TL_x",
    "TL_y",
    "BR_x",
    "BR_y)",
    "8: Detection or Length Confidence",
    "9: Target Length (0 or -1 if invalid)",
    "10-11+: Repeated Species",
    "Confidence Pairs or Attributes",
)
_NO_LENGTH = "-1"
_CERTAIN = 1.0
_MICROSECONDS = 1_000_000
_SECONDS = 60


def export_viame(path: Path, exported: Exported, report: Progress) -> tuple[Path, ...]:
    """Write tracks that have boxes, one after the other.

    Raises FormatError where no row has a box.
    """
    with replacing(path) as stream:
        metadata = [] if exported.fps is None else [f"fps: {exported.fps!r}"]
        metadata.append(f'exported_by: "trackwright {tracking.__version__}"')
        stream.write(f"{','.join(_HEADER)}\n{_as_csv(['# metadata', *metadata])}")
        for track, rows in exported.tracks_with_boxes(path, "VIAME's CSV", report):
            stream.writelines(_rows(track, rows, exported))
    return (path,)


def _rows(track: int, rows: Columns, exported: Exported) -> Iterator[str]:
    label = exported.label(track)
    kind, cells = _as_csv([cell_of_class(kind_of(label))])[:-1], cells_of_label(label)
    about = f",{_as_csv(cells)[:-1]}" if cells else ""
    hidden = is_occluded(rows["visibility"], rows["predicted"]).tolist()
    boxes = np.column_stack([rows[name] for name in BOX]).astype(np.float64)
    boxes[:, 2:] += boxes[:, :2]
    said = short_decimals(np.asarray(exported.confidence(rows), np.float32))
    confidence = np.where(np.isnan(said), _CERTAIN, said).tolist()
    for frame, (left, top, right, bottom), score, is_hidden in zip(
        rows["frame"].tolist(), boxes.tolist(), confidence, hidden, strict=True
    ):
        occluded = ",(atr) occluded true" if is_hidden else ""
        yield (
            f"{track},{_time_of(frame, exported.fps)},{frame},{left!r},{top!r},{right!r},"
            f"{bottom!r},{score!r},{_NO_LENGTH},{kind},{score!r}{occluded}{about}\n"
        )


def _time_of(frame: int, fps: float | None) -> str:
    """As DIVE writes it, e.g. "00:01:02.500000"; "" where frames a second are not known.

    Hours count on after a day, where DIVE begins again: two frames never have the same time.
    """
    if fps is None:
        return ""
    seconds, micros = divmod(round(frame / fps * _MICROSECONDS), _MICROSECONDS)
    minutes, seconds = divmod(seconds, _SECONDS)
    hours, minutes = divmod(minutes, _SECONDS)
    return f"{hours:02d}:{minutes:02d}:{seconds:02d}.{micros:06d}"


def _as_csv(fields: list[str]) -> str:
    """A line of values, quoted where they need it."""
    text = io.StringIO()
    CsvWriter(text).writerow(fields)
    return text.getvalue()

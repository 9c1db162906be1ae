"""Labels of parts from rendered truth, for experiments."""

from __future__ import annotations

from pathlib import Path

from tracking.editing import Change, plan_label_part
from tracking.errors import EditError
from tracking.failure import labels_from_truth
from tracking.recording import Recording
from tracking.session.provenance import parts_by_now
from tracking.tracks import Labels, Run, TrackTable
from tracking.truth import TRUE_PARTS, read_true_parts


def truth_path(recording: Recording) -> Path | None:
    """Where the true parts of a rendered recording stand; None where they are not known."""
    path = recording.folder / TRUE_PARTS
    return path if path.is_file() else None


def plan_truth_labels(
    recording: Recording, table: TrackTable, run: Run | None, labels: Labels
) -> Change:
    """Label whatever truth knows and nobody has labelled.

    Raises FormatError for a damaged file, EditError where there is nothing to label.
    """
    path = truth_path(recording)
    if path is None or run is None or not len(run.parts["frame"]):
        raise EditError(
            "{name} has no ground truth of parts, or no parts were tracked", name=recording.name
        )
    parts = parts_by_now(table, run, table.track_ids)
    known = labels_from_truth(read_true_parts(path), parts, recording.fps)
    new = [label for label in known if label.key not in labels.parts]
    if not new:
        raise EditError("All tracked parts that are in the ground truth are labelled already")
    return plan_label_part(labels, new)

"""What the pictures show: a rendered recording, its session with all that can be in one, others."""

from __future__ import annotations

import math
import shutil
from contextlib import closing
from dataclasses import dataclass, replace
from pathlib import Path

import cv2
import numpy as np

from app.core.document import document_loader
from app.features.files.export import prepare_export
from tests.app.run_with_parts import with_parts
from tests.batch.walks import make_damaged
from tests.pictures.setup_steps import camera_card
from tests.project.projects import make_project, mark_reviewed
from tracking.editing import (
    plan_add_keyframe,
    plan_delete,
    plan_label_part,
    plan_lines,
    plan_mark_occluded,
    plan_mark_reviewed,
    plan_occluders,
    plan_regions,
    plan_rename,
    plan_set_attribute,
    plan_set_notes,
    plan_split,
    plan_swap,
)
from tracking.formats.catalogue import format_named
from tracking.geometry import read_calibration, write_calibration
from tracking.pipeline import track
from tracking.progress import no_progress
from tracking.recording import Recording, open_recording, read_manifest
from tracking.session import Session
from tracking.synthesis import render_recording
from tracking.tracks import (
    Attribute,
    AttributeType,
    CountingLine,
    Occluder,
    PartLabel,
    Region,
    Run,
)

FPS, SECONDS, PEOPLE, SEED = 10.0, 12.0, 6, 4
MIDDLE = 60
_LONGEST_NAME = "red coat, umbrella"
SCHEMA = (
    Attribute("age", AttributeType.CHOICE, ("child", "adult", "elderly"), "adult", required=True),
    Attribute("bag", AttributeType.CHOICE, ("none", "handbag", "rucksack", "suitcase on wheels")),
    Attribute("umbrella", AttributeType.YES_NO),
    Attribute("height", AttributeType.NUMBER, least=1.0, most=2.2, step=0.05),
    Attribute("with", AttributeType.TEXT),
)
"""Of attributes, one of each type; the session does not have it from the start."""


@dataclass(frozen=True, slots=True)
class Material:
    """Where all of it lies.

    Attributes:
        recording, session: of six people on a square; the session has two runs, body parts,
            labels, edits and two backups. other: another annotator's session of the recording.
        card: bare videos of two cameras. turned: a recording whose calibration is wrong.
        project: a folder of recordings, some tracked, one damaged. tracks: a file of tracks.
    """

    folder: Path

    @property
    def recording(self) -> Path:
        return self.folder / "Market square"

    @property
    def session(self) -> Path:
        return self.folder / "market-square.h5"

    @property
    def other(self) -> Path:
        return self.folder / "market-square-bo.h5"

    @property
    def tracks(self) -> Path:
        return self.folder / "tracks.csv"

    @property
    def card(self) -> Path:
        return self.folder / "card"

    @property
    def turned(self) -> Path:
        return self.folder / "Lobby"

    @property
    def project(self) -> Path:
        return self.folder / "Walks"


def make_material(folder: Path) -> Material:
    """Render, track and label it all; half a minute."""
    made = Material(folder)
    render_recording(made.recording, "plaza", SECONDS, PEOPLE, SEED, fps=FPS)
    _make_sessions(made)
    camera_card(made.card, folder / "made")
    _make_turned(made.turned)
    _make_project(made.project)
    return made


def copied(made: Material, folder: Path) -> Material:
    """A copy that a window may write into; its sessions find the recording in it."""
    shutil.copytree(made.folder, folder, dirs_exist_ok=True)
    copy = Material(folder)
    for path in (copy.session, copy.other):
        with open_recording(copy.recording) as recording, closing(Session.open(path)) as session:
            document_loader.remember_place(session, recording)
    return copy


def _make_sessions(made: Material) -> None:
    with open_recording(made.recording) as recording:
        first, second = (_run(recording, name) for name in ("stereo-direction", "stereo-colour"))
        with closing(Session.create(recording, [with_parts(first)], made.session)) as one:
            one.add_run(second, adopt=False)
            _label(one)
            one.save()
            _edit(one)
            one.save()
            _export(one, made.tracks)
    shutil.copy(made.session, made.other)
    with closing(Session.open(made.other, author="Bo")) as session:
        a, b = session.tracks.of_frame(MIDDLE)["track"].tolist()[:2]
        session.apply(plan_swap(session.tracks, a, b, MIDDLE))
        session.apply(plan_delete(session.tracks, a, 70, 80))
        session.save()


def _run(recording: Recording, tracker: str) -> Run:
    with track(recording, tracker) as tracking:
        for _ in tracking:
            pass
        return tracking.run()


def _label(session: Session) -> None:
    """Names, attributes, shapes, parts: what the panels list."""
    table = session.tracks
    ids = table.of_frame(MIDDLE)["track"].tolist()
    session.apply(plan_rename(table, session.labels, ids[0], _LONGEST_NAME))
    for key, value in (("bag", "rucksack"), ("age", "adult"), ("with", "a child and a dog")):
        session.apply(plan_set_attribute(table, session.labels, ids[0], key, value))
    session.apply(plan_set_notes(table, session.labels, ids[0], "Turns back at the bench."))
    pillar = Occluder("pillar", ((300.0, 120.0), (330.0, 120.0), (330.0, 300.0), (300.0, 300.0)))
    session.apply(plan_occluders(session.labels, [pillar]))
    gate = CountingLine("gate", (1.0, -1.0), (1.2, 9.0))
    door = CountingLine("door", (0.0, 220.0), (640.0, 210.0), in_picture=True)
    session.apply(plan_lines(session.labels, [gate, door]))
    hall = Region("hall", ((-3.0, 2.0), (3.0, 2.0), (3.0, 6.0), (-3.0, 6.0)))
    session.apply(plan_regions(session.labels, [hall]))
    session.apply(plan_label_part(session.labels, list(_parts_as_they_are(session))))


def _parts_as_they_are(session: Session) -> list[PartLabel]:
    rows = session.runs[0].parts
    numbers = zip(*(rows[name].tolist() for name in ("frame", "track", "part")), strict=True)
    boxes = zip(*(rows[name].tolist() for name in ("cx", "cy", "width", "height")), strict=True)
    failed = rows["failed"].tolist()
    return [
        PartLabel(frame, one, part, (u - w / 2, v - h / 2, w, h), not off, "tracker", "Ada")
        for (frame, one, part), (u, v, w, h), off in zip(numbers, boxes, failed, strict=True)
        if frame % 4 == 0
    ]


def _edit(session: Session) -> None:
    """Some edits for the history."""
    table = session.tracks
    ids = table.of_frame(MIDDLE)["track"].tolist()
    session.apply(plan_mark_reviewed(session.labels, 0, 0, 30))
    for frame in (MIDDLE, MIDDLE + 10):
        session.apply(plan_add_keyframe(table, ids[0], frame))
    session.apply(plan_mark_occluded(table, [ids[1]], 40, 50, occluded=True))
    session.apply(plan_delete(table, ids[2], 50, 58))
    session.apply(plan_split(table, ids[3], 80))


def _export(session: Session, path: Path) -> None:
    """The tracks in a file of another program's kind."""
    write = format_named("csv").write
    assert write is not None
    write(path, prepare_export(session)(), no_progress)


def _make_turned(folder: Path) -> None:
    """A recording whose right camera is turned by half a degree in the calibration alone."""
    render_recording(folder, "lobby", 3.0, 3, 11)
    path = folder / read_manifest(folder).calibration[0]
    rig, vector = read_calibration((path,)), np.array([0.0, 0.0, math.radians(0.5)])
    turn = cv2.Rodrigues(vector)[0]
    write_calibration(
        path, replace(rig, rotation=turn @ rig.rotation, translation=turn @ rig.translation)
    )


def _make_project(folder: Path) -> None:
    """Recordings of a project: two sessions of the first, one damaged."""
    make_project(folder, ("Camera 1, morning", "Camera 1, noon", "Camera 2"))
    (folder / "Bo").mkdir()
    first = folder / "Camera 1, morning.h5"
    shutil.copy(first, folder / "Bo" / first.name)
    mark_reviewed(first, "Ada")
    mark_reviewed(folder / "Bo" / first.name, "Bo")
    make_damaged(folder / "Camera 3, broken", 1)


def main() -> int:
    """Make it in the folder that the command line names."""
    import os
    import sys
    from tempfile import TemporaryDirectory

    with TemporaryDirectory(prefix="trackwright-") as own:
        os.environ |= {"HOME": own, "XDG_DATA_HOME": own, "XDG_CONFIG_HOME": own}
        make_material(Path(sys.argv[1]))
    return 0


if __name__ == "__main__":
    raise SystemExit(main())

"""A whole file of each kind the program reads, and the commands that read it."""

from __future__ import annotations

import multiprocessing
import shutil
import sys
from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path

import cv2
import numpy as np

sys.path.insert(0, str(Path(__file__).parents[1] / "session"))
sys.path.insert(0, str(Path(__file__).parents[1] / "formats"))

from made_up_sessions import crashed, make_session
from test_animal_trackers import SCORES, analysis, trajectories
from test_petrack_trc import of_version
from test_sleap_projects import csv_file, project

from tests.sweeps.random_tracks import exported, random_tracks
from tests.sweeps.sessions import SMALL
from tracking.editing import plan_label_part, plan_rename, plan_swap
from tracking.failure.core.samples import samples_from_rows
from tracking.formats import FORMATS, write_samples
from tracking.formats.track_writer import no_progress
from tracking.synthesis import render_recording
from tracking.tracks import PartLabel

_RESOURCES = Path(__file__).parents[2] / "resources"
_HIDDEN = ".s.h5.trackwright"
WINDOW = "the window"
"""In the place of a command: the window is shown, with its settings from that file."""
_SEEN = (
    ("info", "W/s.h5", "--json"),
    ("export", "W/s.h5", "-o", "W/tracks.csv", "--format", "csv"),
    ("export", "W/s.h5", "-o", "W/run.csv", "--format", "csv", "--run", "0"),
    ("log", "W/s.h5", "--json"),
)
"""All that a session says, as far as commands tell it."""
_INFO = (("info", "W/rec", "--json"),)


@dataclass(frozen=True, slots=True)
class Kind:
    """One kind of file.

    Attributes:
        folder: of the kit, copied for each mutant. file: the one in it that is damaged.
        commands: that read it, one after the other up to the first that fails; W/ stands for the
            copy, K/ for the kit.
        whole: what is told of a damaged one is what is told of the whole one, or a note says that
            it is not. locked: another program holds it, a lock.
        slow: reading it takes seconds, so that only one mutant of ten is made.
    """

    folder: str
    file: str
    commands: tuple[tuple[str, ...], ...]
    whole: bool = False
    locked: bool = False
    slow: bool = False


class Kit:
    """The whole files, made by a fork as threads start, and their kinds by name."""

    def __init__(self, folder: Path) -> None:
        self.folder = folder / "kit"
        hear, say = multiprocessing.Pipe(duplex=False)
        fork = multiprocessing.get_context("fork")
        making = fork.Process(target=lambda: say.send(_kinds(self.folder)))
        making.start()
        say.close()
        self.kinds: dict[str, Kind] = hear.recv()
        making.join()

    def word(self, word: str, work: Path) -> str:
        """A word of a command, as it is typed."""
        roots = {"W/": f"{work}/", "K/": f"{self.folder}/"}
        return roots.get(word[:2], word[:2]) + word[2:]


def _kinds(kit: Path) -> dict[str, Kind]:
    return {**of_sessions(kit), **of_recordings(kit), **of_tables(kit), **of_tracks(kit)}


# Sessions and what stands beside them


def of_sessions(kit: Path) -> dict[str, Kind]:
    """A session with two saves and an edit that waits in its journal."""
    session = make_session(kit / "session-being-edited")
    session.apply(plan_swap(session.tracks, 1, 2, 10))
    session.apply(plan_rename(session.tracks, session.labels, 1, "red coat"))
    part = PartLabel(3, 1, 0, (1.0, 2.0, 3.0, 4.0), True, "person")
    session.apply(plan_label_part(session.labels, (part,)))
    session.save()
    for number in range(3):
        session.apply(plan_rename(session.tracks, session.labels, 2, f"waits {number}"))
    crashed(session, kit / "waiting")
    session.save()
    session.close()
    (kit / "session").mkdir()
    shutil.copy(kit / "session-being-edited" / "s.h5", kit / "session")
    shutil.copytree(kit / "session-being-edited", kit / "older")
    shutil.copytree(kit / "older", kit / "locked")
    (kit / "locked" / _HIDDEN / "lock").write_text(' {"process": 12, "computer": "desk"}')
    restored = (("restore", "W/s.h5", "--list", "--json"), ("restore", "W/s.h5"))
    return {
        "session": Kind("session", "s.h5", _SEEN, whole=True),
        "journal": Kind("waiting", f"{_HIDDEN}/journal.sqlite", _SEEN, whole=True),
        "journal-wal": Kind("waiting", f"{_HIDDEN}/journal.sqlite-wal", _SEEN, whole=True),
        "lock": Kind("locked", f"{_HIDDEN}/lock", restored[1:], locked=True),
        "backup": Kind("older", f"{_HIDDEN}/s.1.h5", restored),
    }


# Recordings


def of_recordings(kit: Path) -> dict[str, Kind]:
    """Manifests, calibrations, pictures, videos, what a failure detector is and settings."""
    rec = render_recording(kit / "stereo" / "rec", seconds=2.0, seed=3, **{**SMALL, "people": 2})
    for name in ("xml", "kitti", "ros"):
        shutil.copytree(rec, kit / name / "rec")
    _calibrations(kit)
    pictures = kit / "pictures" / "rec"
    pictures.mkdir(parents=True)
    for number in range(4):
        picture = np.random.default_rng(number).integers(0, 255, (48, 64, 3)).astype(np.uint8)
        cv2.imwrite(str(pictures / f"{number:06d}.png"), picture)
    shutil.copytree(pictures, kit / "jpegs" / "rec")
    for picture in (kit / "jpegs" / "rec").iterdir():
        cv2.imwrite(str(picture.with_suffix(".jpg")), cv2.imread(str(picture)))
        picture.unlink()
    two = ("--frames", "0:2", "-o", "W/out.h5")
    shown = (*_INFO, ("track", "W/rec", *two))
    view_options = tuple((*words, "--fps", "8") for words in shown)
    parts = ("track", "K/stereo/rec", "--tracker", "three-part", *two)
    (kit / "detector").mkdir()
    shutil.copy(_RESOURCES / "part_failures.h5", kit / "detector" / "d.h5")
    (kit / "settings").mkdir()
    show_window(kit / "settings" / "settings.ini", (kit / "session" / "s.h5",))
    return {
        "recording.toml": Kind("stereo", "rec/recording.toml", _INFO),
        "calibration.yaml": Kind("stereo", "rec/calibration.yaml", _INFO),
        "calibration.xml": Kind("xml", "rec/calibration.xml", _INFO),
        "calib.txt": Kind("kitti", "rec/calib.txt", _INFO),
        "camera_info.yaml": Kind("ros", "rec/right.yaml", _INFO),
        "png": Kind("pictures", "rec/000000.png", view_options),
        "jpeg": Kind("jpegs", "rec/000001.jpg", view_options),
        "video": Kind("stereo", "rec/left.mp4", shown),
        "settings": Kind("settings", "settings.ini", ((WINDOW, "W/settings.ini"),), slow=True),
        "detector": Kind("detector", "d.h5", ((*parts, "--detector", "W/d.h5"),)),
    }


def show_window(settings: Path, opened: Sequence[Path] = ()) -> int:
    """Show the window with what it remembers in this file, and close it."""
    from PySide6.QtCore import QCoreApplication, QSettings

    from app.core.widgets.user_settings import Place, UserSettings
    from app.shell.application import start_application
    from app.shell.main_window import MainWindow

    kept = QSettings(str(settings), QSettings.Format.IniFormat)
    remembered = UserSettings(kept)
    for path in opened:
        remembered.add_recent(path)
    if opened:
        remembered.note_open(opened, Place(3, 1))
    start_application(remembered)
    window = MainWindow(remembered)
    window.show()
    QCoreApplication.processEvents()
    window.close()
    kept.sync()
    return 0


def _calibrations(kit: Path) -> None:
    """The same two cameras in the words of other programs."""
    read = cv2.FileStorage(str(kit / "xml" / "rec" / "calibration.yaml"), cv2.FILE_STORAGE_READ)
    written = cv2.FileStorage(str(kit / "xml" / "rec" / "calibration.xml"), cv2.FILE_STORAGE_WRITE)
    for name in ("M1", "D1", "M2", "D2", "R", "T"):
        written.write(name, read.getNode(name).mat())
    for name in ("image_width", "image_height"):
        written.write(name, int(read.getNode(name).real()))
    written.release()
    rows = [f"P{one}: 300 0 160 {-30 * one} 0 300 120 0 0 0 1 0\n" for one in range(4)]
    (kit / "kitti" / "rec" / "calib.txt").write_text("".join(rows))
    for name, offset in (("left", "0"), ("right", "-30")):
        (kit / "ros" / "rec" / f"{name}.yaml").write_text(_ROS.replace("OFFSET", offset))
    named = {"xml": '"calibration.xml"', "kitti": '"calib.txt"'}
    for folder, name in {**named, "ros": '["left.yaml", "right.yaml"]'}.items():
        manifest = kit / folder / "rec" / "recording.toml"
        manifest.write_text(manifest.read_text().replace('"calibration.yaml"', name))


_ROS = """image_width: 320
image_height: 240
camera_name: c
distortion_model: plumb_bob
camera_matrix: {rows: 3, cols: 3, data: [300, 0, 160, 0, 300, 120, 0, 0, 1]}
distortion_coefficients: {rows: 1, cols: 5, data: [0, 0, 0, 0, 0]}
rectification_matrix: {rows: 3, cols: 3, data: [1, 0, 0, 0, 1, 0, 0, 0, 1]}
projection_matrix: {rows: 3, cols: 4, data: [300, 0, 160, OFFSET, 0, 300, 120, 0, 0, 0, 1, 0]}
"""


# Tables of body parts


def of_tables(kit: Path) -> dict[str, Kind]:
    """Samples of the failure detector, labels of body parts, occluders."""
    (kit / "tables").mkdir()
    random = np.random.default_rng(4112)
    rows = [("yard", 1 + at // 6, at, at % 3, at % 2, "Zoë", "unsure", "label") for at in range(12)]
    samples = samples_from_rows(rows, random.normal(size=(12, 36)))
    for name in ("samples.csv", "samples.h5"):
        write_samples(kit / "tables" / name, samples)
    lines = "".join(f"{frame},1,head,1,10,20,30,40\n" for frame in range(1, 6))
    head = "frame,track,part,on,left,top,width,height\n"
    (kit / "tables" / "labels.csv").write_text(f"{head}{lines}")
    shutil.copy(kit / "session" / "s.h5", kit / "tables" / "s.h5")
    # Too few to train from: they are read, then that is told.
    train = {name: ("train", f"W/{name}", "-o", "W/d.h5") for name in ("samples.csv", "samples.h5")}
    label = ("import-labels", "W/labels.csv", "W/s.h5")
    return {
        **{name: Kind("tables", name, (words,)) for name, words in train.items()},
        "part-labels": Kind("tables", "labels.csv", (label,)),
    }


# Tracks of other tools


def of_tracks(kit: Path) -> dict[str, Kind]:
    """A file of each format, as far as it can be written here, and those that are only read."""
    found, how = {}, (exported(random_tracks(5, 12, 3), 12), no_progress)
    made = {
        name: (f"{name}{one.extensions[0]}", lambda path, one=one: one.write(path, *how))
        for name, one in FORMATS.items()
        if one.read is not None and one.write is not None
    }
    for name, (file, make) in {**made, **_ONLY_READ}.items():
        path = kit / f"tracks-{Path(file).stem}" / file
        path.parent.mkdir()
        make(path)
        words = ("import", f"W/{file}", "--recording", "K/stereo/rec", "-o", "W/out.h5")
        damaged = min(path.iterdir()) if path.is_dir() else path  # some are a folder of files
        found[name] = Kind(path.parent.name, str(damaged.relative_to(path.parent)), (words,))
    scored = ("score", "W/mot.txt", "--truth", "K/tracks-mot/mot.txt", "--json")
    return {**found, "scored mot": Kind("tracks-mot", "mot.txt", (scored,))}


_SLEAP_ROWS = ("track_0,0,0.5,,1,2,3,4", "track_0,1,,,5,6,,", "Zoë,1,,,1,1,2,1")
_ONLY_READ = {
    "sleap": ("sleap.h5", lambda path: analysis(path, (1, 3, 2, 0), SCORES.T)),
    "sleap project": ("project.slp", project),
    "sleap csv": ("sleap-table.csv", lambda path: csv_file(path, *_SLEAP_ROWS)),
    "idtracker": ("idtracker.h5", trajectories),
    "petrack-trc": ("petrack-trc.trc", lambda path: path.write_text(of_version(4), "utf-8")),
}

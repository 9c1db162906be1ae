"""Track with detections: which files of boxes, or which network, and how they are used."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from functools import partial
from pathlib import Path
from typing import Any

from PySide6.QtCore import QObject, Qt, Signal
from PySide6.QtGui import QStandardItemModel
from PySide6.QtWidgets import QComboBox, QFormLayout, QHBoxLayout, QPushButton, QWidget

from app.core.error_messages import explain
from app.core.i18n import joined, tr
from app.core.jobs.latest_job import LatestJob
from app.core.widgets.parts import quiet
from app.core.widgets.questions import choose_file
from app.core.widgets.user_settings import UserSettings
from tracking.detections import (
    DetectionSettings,
    RecordingDetections,
    files_beside,
    load_detections,
    outside,
    place_of,
)
from tracking.detections.catalogue import DETECTORS, picture_detectors
from tracking.detections.detector import DetectorSpec
from tracking.detections.settings import BESIDE, ONLY
from tracking.networks.model_file import Model, read_model
from tracking.networks.network_detections import named_detector
from tracking.progress import Progress
from tracking.recording import Recording
from tracking.settings import settings_fields, settings_from

FILE, RIGHT, USE = "detections.file", "detections.file_right", "detections.use"
MODEL, APPEARANCE = "detections.model", "detections.appearance"
FILLED_IN = (FILE, RIGHT, MODEL, USE)
"""Settings of trackers that stand here, not among the others."""
_FILTER = "(*.txt *.json)"
_NETWORK = ".toml"
"""How the name of a network's file ends."""
_FILTER_WITH_NETWORK = "(*.txt *.json *.toml)"
_Read = RecordingDetections | Model | DetectorSpec | None
"""What is chosen, once it is known; None: nothing is."""


class FileChoice(QWidget):
    """A file of detections of one camera, or a network, out of those found or one chosen."""

    def __init__(
        self,
        name: str,
        found: tuple[str, ...],
        remembered: UserSettings,
        parent: QWidget,
        *,
        network: bool = False,
    ) -> None:
        """network: whether a network may be chosen, too."""
        super().__init__(parent)
        self._remembered, self._network = remembered, network
        self._networks: set[str] = set()
        file = tr("Choose MOT text or COCO JSON")
        if network:
            file = tr("Choose MOT text, COCO JSON, or the TOML of a network")
        self.files = QComboBox(self)
        self.files.setAccessibleName(name)
        here = tr("none (found here: {files})", files=joined(", ", found)) if found else tr("none")
        self.files.addItem(here, "")
        for each in found:
            self.files.addItem(each, each)
        line = QHBoxLayout(self)
        line.setContentsMargins(0, 0, 0, 0)
        line.addWidget(self.files, 1)
        self.files.currentIndexChanged.connect(lambda: self.files.setToolTip(self.path))
        for text, told, folder in (
            (tr("File..."), file, False),
            (tr("Folder..."), tr("Choose a folder of YOLO text"), True),
        ):
            button = QPushButton(text, self)
            button.setToolTip(told)
            button.setAccessibleDescription(name)
            button.setAutoDefault(False)
            button.clicked.connect(partial(self._choose, folder))
            line.addWidget(button)

    @property
    def path(self) -> str:
        """What is chosen, from the recording's folder or absolute; "": none."""
        return str(self.files.currentData())

    @property
    def is_network(self) -> bool:
        """Whether what is chosen is a network."""
        is_toml = self._network and self.path.lower().endswith(_NETWORK)
        return is_toml or self.path in self._networks

    def put_network(self, path: str) -> None:
        """Choose a network, by its TOML or the folder of it."""
        self._networks.add(path)
        self.put(path)

    def offer_detector(self, name: str, title: str) -> None:
        """Offer the detector of a plug-in by its title; its name is what is chosen."""
        self._networks.add(name)
        self.files.addItem(tr("{title} (plug-in)", title=title), name)

    def offer_fault(self, name: str, why: str) -> None:
        """Show a plug-in that does not work: greyed, and saying why."""
        self.files.addItem(tr("{name} (does not work)", name=name))
        row, model = self.files.count() - 1, self.files.model()
        assert isinstance(model, QStandardItemModel)
        model.item(row).setEnabled(False)
        self.files.setItemData(row, why, Qt.ItemDataRole.ToolTipRole)

    def put(self, path: str) -> None:
        """Choose a file, which is offered from now on."""
        at = self.files.findData(path)
        if at < 0:
            self.files.addItem(_short(path), path)
            at = self.files.count() - 1
        self.files.setCurrentIndex(at)

    def _choose(self, folder: bool) -> None:
        title = tr("A folder of YOLO text") if folder else tr("Detections of another program")
        endings = _FILTER_WITH_NETWORK if self._network else _FILTER
        filters = "" if folder else f"{tr('Detections')} {endings}"
        last = self._remembered.last_folder("detections")
        choose_file(self, title, filters, lambda path: self.put(str(path)), last, folder=folder)


class DetectionsLine(QObject):
    """Rows of a form that choose detections for one camera or both, and tell what is in them.

    Signals: `usable(yes)`, whether what is chosen can be tracked with; not while it is read.
    """

    usable = Signal(bool)

    def __init__(self, recording: Recording, remembered: UserSettings, parent: QWidget) -> None:
        """The controls; `add_to` gives them their places."""
        super().__init__(parent)
        found = files_beside(recording)
        self._left = FileChoice(tr("Detections"), found, remembered, parent, network=True)
        self._offer_plugins(recording)
        self._right = FileChoice(tr("Detections of the right camera"), (), remembered, parent)
        self._use = QComboBox(parent)
        self._use.setAccessibleName(tr("What people are found by"))
        self._use.addItem(tr("detections and foreground"), BESIDE)
        self._use.addItem(tr("detections only"), ONLY)
        self._told = quiet("", parent)
        self._told.setWordWrap(True)
        self._told.setTextFormat(Qt.TextFormat.PlainText)  # it holds names of files
        self._form: QFormLayout | None = None
        self._taken = True
        self._describes = ""  # the network chosen that describes people, and finds none
        self._is_stereo = self._stereo = recording.is_stereo
        self._look = LatestJob(
            tr("Reading detections"), partial(_reading, recording), self, cancellable=False
        )
        self._look.found.connect(self._tell)
        self._look.failed.connect(self._refuse)
        for box in (self._left.files, self._right.files, self._use):
            box.currentIndexChanged.connect(self._follow)

    def _offer_plugins(self, recording: Recording) -> None:
        """Detectors of plug-ins; where a file is called like one, the file is meant."""
        for each in picture_detectors():
            if named_detector(recording, each.name) is not None:
                self._left.offer_detector(each.name, tr(each.title))
        for fault in DETECTORS.faults:
            self._left.offer_fault(fault.offer.name, tr(fault.error.message))

    def add_to(self, form: QFormLayout) -> None:
        """Put the rows into a form, below those it has."""
        self._form = form
        form.addRow(tr("Detections"), self._left)
        form.addRow(tr("Right detections"), self._right)
        form.addRow(tr("Find people by"), self._use)
        form.addRow("", self._told)
        self._follow()

    def show_for(self, settings_type: type, *, stereo: bool) -> None:
        """Show the rows where a tracker with these settings takes detections.

        Args:
            stereo: whether it looks at both cameras; others have no use for boxes of the right one.
        """
        self._taken = FILE in {field.name for field in settings_fields(settings_type)}
        self._stereo = stereo and self._is_stereo
        self._follow()

    def values(self) -> dict[str, str]:
        """The settings that are not as they come, by their dotted names.

        None of a tracker that takes no detections.
        """
        if not (self._taken and self._left.path):
            return {}
        if self._left.path == self._describes:
            return {APPEARANCE: self._describes}
        chosen = {MODEL if self._left.is_network else FILE: self._left.path}
        if self._stereo and self._right.path and not self._left.is_network:
            chosen[RIGHT] = self._right.path
        if self._use.currentData() != BESIDE:
            chosen[USE] = str(self._use.currentData())
        return chosen

    def put(self, values: Mapping[str, Any]) -> None:
        """Choose what the settings of a run say; files outside of the recording's folder are told.

        These are read where the user chooses them: a session may come from somebody else.
        """
        elsewhere = outside(values)
        if values.get(MODEL) and not elsewhere:
            self._left.put_network(str(values[MODEL]))
        else:
            self._left.put("" if elsewhere else str(values.get(FILE, "")))
        self._right.put("" if elsewhere else str(values.get(RIGHT, "")))
        self._use.setCurrentIndex(max(0, self._use.findData(values.get(USE, BESIDE))))
        if elsewhere:
            told = tr(
                "The tracks were made with {file}, which is not in the folder of the recording: "
                "choose it to use it again.",
                file=elsewhere,
            )
            self._told.setText(told)
            if self._form is not None:
                self._form.setRowVisible(self._told, True)

    def reset(self) -> None:
        """Choose none, used as usual."""
        self.put({})

    def _follow(self) -> None:
        """Show what is to be said of a file once there is one, and have it read."""
        some = self._taken and bool(self._left.path)
        self._describes = ""
        if self._form is not None:
            self._form.setRowVisible(self._left, self._taken)
            of_file = some and not self._left.is_network
            self._form.setRowVisible(self._right, of_file and self._stereo)
            self._form.setRowVisible(self._use, some)
            self._form.setRowVisible(self._told, some)
        self._look.stop()
        self.usable.emit(not some)
        if some:
            self._say(tr("Reading detections..."))
            values = {name.partition(".")[2]: value for name, value in self.values().items()}
            self._look.ask(settings_from(DetectionSettings, values))

    def _tell(self, chosen: _Read) -> None:
        if isinstance(chosen, Model):
            self._tell_network(chosen)
        elif isinstance(chosen, DetectorSpec):
            licence = chosen.licence or tr("no licence is stated")
            self._say(tr("Detector {title} ({licence})", title=tr(chosen.title), licence=licence))
        elif chosen is not None:
            self._say("\n".join(tr(note) for note in chosen.notes), warns=chosen.unused)
        self.usable.emit(True)

    def _tell_network(self, chosen: Model) -> None:
        """Which network it is; one that finds nobody is not asked how its boxes are used."""
        values = {"name": chosen.name, "licence": chosen.licence}
        if not chosen.is_appearance:
            self._say(tr("Network {name} ({licence})", **values))
            return
        self._describes = self._left.path
        if self._form is not None:
            self._form.setRowVisible(self._use, False)
        told = tr("Appearance network {name} ({licence}): tells people apart, finds none", **values)
        self._say(told)

    def _refuse(self, _: object, error: Exception) -> None:
        self._say(explain(error), warns=True)

    def _say(self, text: str, *, warns: bool = False) -> None:
        """Below the rows, in the colour of a warning where it is one."""
        self._told.setText(text)
        self._told.setProperty("role", "warning" if warns else "muted")
        self._told.style().unpolish(self._told)
        self._told.style().polish(self._told)


def _short(path: str) -> str:
    """A path with its name first, which shows however long the folder's is."""
    folder, name = str(Path(path).parent), Path(path).name
    return tr("{file} in {folder}", file=name, folder=folder) if Path(path).is_absolute() else path


def _reading(recording: Recording, settings: DetectionSettings) -> Callable[[Progress], _Read]:
    detector = named_detector(recording, settings.model) if settings.model else None
    if detector is not None:
        return lambda _: detector
    if settings.model:
        return lambda _: read_model(place_of(recording, settings.model))
    return lambda _: load_detections(recording, settings)

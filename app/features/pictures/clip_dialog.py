"""What a clip shows: which frames, cameras and people, how large, how fast."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

from PySide6.QtCore import Signal
from PySide6.QtWidgets import (
    QCheckBox,
    QComboBox,
    QDialog,
    QFormLayout,
    QVBoxLayout,
    QWidget,
)

from app.core.i18n import tr
from app.core.widgets.dialog_ends import dialog_ends
from app.core.widgets.number_boxes import WholeBox
from app.core.widgets.parts import quiet
from app.features.pictures.clip import ClipChoice, ClipKind

_LETTERS = 56
_LEAST_PX, _MOST_PX = 96, 2160
_HEIGHTS = {ClipKind.MP4: 720, ClipKind.GIF: 320}
_RATES = {ClipKind.MP4: 30, ClipKind.GIF: 10}
_MOST_RATE = {ClipKind.MP4: 60, ClipKind.GIF: 25}
"""Browsers show a GIF with more pictures a second slower than it should be."""
_SPEEDS = (0.25, 0.5, 1.0, 2.0, 4.0)


@dataclass(frozen=True, slots=True)
class ClipStretch:
    """Frames that can be chosen by a name: half-open, and whose they are; 0: nobody's."""

    name: str
    start: int
    stop: int
    track: int = 0


@dataclass(frozen=True, slots=True)
class ClipOffer:
    """What there is to choose from.

    Attributes:
        stretches: the most likely one first. fps: of the recording. height_px: of its pictures.
        person: who is selected, in words; "" for nobody. track: their id.
        stereo: whether there is a right camera. floor: whether the overhead view shows one.
    """

    stretches: Sequence[ClipStretch]
    fps: float
    height_px: int
    person: str = ""
    track: int = 0
    stereo: bool = False
    floor: bool = False


class ClipDialog(QDialog):
    """Asks for a :class:`ClipChoice`.

    Signals:
        asked(object): the choice.
    """

    asked = Signal(object)

    def __init__(self, offer: ClipOffer, parent: QWidget, before: str = "") -> None:
        """before: what was chosen the last time: see `remembered`; "" for nothing."""
        super().__init__(parent)
        self._offer = offer
        self._before = dict(word.split("=", 1) for word in before.split() if "=" in word)
        self.setWindowTitle(tr("Export a clip"))
        self.setMinimumWidth(_LETTERS * self.fontMetrics().averageCharWidth())
        rows = QVBoxLayout(self)
        rows.setContentsMargins(20, 20, 20, 16)
        rows.setSpacing(10)
        form = QFormLayout()
        self._build_file(form)
        self._build_pictures(form)
        self._build_drawn(form)
        rows.addLayout(form)
        self._told = quiet("", self)
        self._told.setWordWrap(True)
        self._told.setAccessibleName(tr("How long the clip is"))
        rows.addWidget(self._told)
        rows.addStretch(1)
        rows.addWidget(dialog_ends(self, tr("&Export...")))
        self._take_kind()
        self._take_before()
        for changed in (
            self._stretch.currentIndexChanged,
            self._rate.valueChanged,
            self._speed.currentIndexChanged,
        ):
            changed.connect(self._tell)

    def _build_file(self, form: QFormLayout) -> None:
        self._stretch = QComboBox(self)
        for one in self._offer.stretches:
            self._stretch.addItem(one.name)
        self._kind = QComboBox(self)
        for kind, title in ((ClipKind.MP4, tr("Video (MP4)")), (ClipKind.GIF, tr("Picture (GIF)"))):
            self._kind.addItem(title, kind)
        self._kind.currentIndexChanged.connect(self._take_kind)
        self._height, self._rate = WholeBox(self), WholeBox(self)
        self._height.setRange(_LEAST_PX, _MOST_PX)
        self._height.setSingleStep(40)
        self._height.setSuffix(tr(" px"))
        self._rate.setSuffix(tr(" pictures a second"))
        self._speed = QComboBox(self)
        for speed in _SPEEDS:
            self._speed.addItem(tr("{0:g}x").format(speed), speed)
        self._speed.setCurrentIndex(_SPEEDS.index(1.0))
        form.addRow(tr("&Frames"), self._stretch)
        form.addRow(tr("F&ile"), self._kind)
        form.addRow(tr("&Height"), self._height)
        form.addRow(tr("&Rate"), self._rate)
        form.addRow(tr("&Speed"), self._speed)

    def _build_pictures(self, form: QFormLayout) -> None:
        offer = self._offer
        self._right = self._box(form, tr("Both cameras, side by side"), False, offer.stereo)
        self._floor = self._box(form, tr("The overhead view beside them"), False, offer.floor)
        follow = tr("Cut out and follow {person}", person=offer.person or tr("the selected person"))
        self._follow = self._box(form, follow, False, bool(offer.track))

    def _build_drawn(self, form: QFormLayout) -> None:
        self._people = self._box(form, tr("Boxes, numbers and names"), True)
        self._trails = self._box(form, tr("Trails"), True)
        self._marks = self._box(form, tr("All else that lies over the pictures now"), True)
        self._legends = self._box(form, tr("Legends, and the cameras' names"), True)
        self._stamp = self._box(form, tr("Frame number and time"), True)

    def _box(self, form: QFormLayout, text: str, on: bool, there: bool = True) -> QCheckBox:
        box = QCheckBox(text.replace("&", "&&"), self)
        box.setChecked(on)
        box.setEnabled(there)
        form.addRow("", box)
        return box

    @property
    def choice(self) -> ClipChoice:
        """As it is chosen now."""
        stretch = self._offer.stretches[self._stretch.currentIndex()]
        return ClipChoice(
            self._kind.currentData(),
            stretch.start,
            stretch.stop,
            self._height.value(),
            float(self._rate.value()),
            self._speed.currentData(),
            self._right.isChecked(),
            self._floor.isChecked(),
            self._offer.track if self._follow.isChecked() else 0,
            self._people.isChecked(),
            self._trails.isChecked(),
            self._marks.isChecked(),
            self._legends.isChecked(),
            self._stamp.isChecked(),
        )

    @property
    def _lasting(self) -> dict[str, QCheckBox]:
        """What is ticked the next time, too; whom a clip follows is chosen each time."""
        named = {"right": self._right, "floor": self._floor, "people": self._people}
        return named | {
            "trails": self._trails,
            "marks": self._marks,
            "legends": self._legends,
            "stamp": self._stamp,
        }

    @property
    def remembered(self) -> str:
        """What is chosen, as a text for the next time; what could not be chosen stays."""
        ticks = {
            name: str(int(box.isChecked()))
            for name, box in self._lasting.items()
            if box.isEnabled()
        }
        kind, speed = self._kind.currentIndex(), self._speed.currentIndex()
        sizes = {"height": self._height.value(), "rate": self._rate.value()}
        chosen = self._before | {"kind": kind, "speed": speed, **sizes, **ticks}
        return " ".join(f"{name}={value}" for name, value in chosen.items())

    def _take_before(self) -> None:
        """Choose what was chosen the last time."""
        known = {name: int(text) for name, text in self._before.items() if text.isdecimal()}
        for name, combo in (("kind", self._kind), ("speed", self._speed)):
            if known.get(name, -1) in range(combo.count()):
                combo.setCurrentIndex(known[name])
        for name, box in (("height", self._height), ("rate", self._rate)):
            if name in known:
                box.setValue(min(known[name], box.maximum()))
        for name, tick in self._lasting.items():
            if name in known and tick.isEnabled():
                tick.setChecked(bool(known[name]))

    def _take_kind(self) -> None:
        """Propose what goes with the kind of file: a GIF is large."""
        kind = self._kind.currentData()
        self._rate.setRange(1, _MOST_RATE[kind])
        self._rate.setValue(min(_RATES[kind], max(1, round(self._offer.fps))))
        self._height.setValue(min(_HEIGHTS[kind], self._offer.height_px))
        self._tell()

    def _tell(self) -> None:
        choice = self.choice
        count = choice.picture_count(self._offer.fps)
        text = tr("{seconds:.1f} s, {count} pictures")
        self._told.setText(text.format(seconds=count / choice.fps, count=count))

    def accept(self) -> None:
        """Go on to the place."""
        super().accept()
        self.asked.emit(self.choice)

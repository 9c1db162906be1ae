"""Two versions of the tracks compared: what differs, what of it is taken."""

from __future__ import annotations

from PySide6.QtCore import Signal
from PySide6.QtWidgets import (
    QComboBox,
    QHBoxLayout,
    QLabel,
    QPushButton,
    QVBoxLayout,
    QWidget,
)

from app.core.drawing.preview_legend import PreviewLegend
from app.core.i18n import count_text, tr
from app.core.look.icons import IconButton
from app.core.look.theme import scaled_font
from app.core.widgets.literal import literal
from app.core.widgets.parts import Panel, quiet
from app.core.widgets.work_line import WorkLine
from app.features.comparison.difference_list import DifferenceModel, DifferenceView
from app.features.comparison.differences_scene import DifferenceOrder, DifferencesScene


class DifferencesPanel(Panel):
    """Draws a :class:`DifferencesScene`; hidden without one.

    Signals:
        chosen(int): the number of a difference that was clicked or walked to.
        ticked(int, bool): a difference is to be taken, or not.
        all_ticked(bool): all that are listed.
        person_chosen(int): 0 for all. order_chosen(str): the value of a `DifferenceOrder`.
        taken(int): take what is ticked: 1 from the dashed version, 0 from the solid one.
        cancelled(): compare no further.
        dropped(), closed(): forget the run; leave everything as it is.
    """

    chosen = Signal(int)
    ticked = Signal(int, bool)
    all_ticked = Signal(bool)
    person_chosen = Signal(int)
    order_chosen = Signal(str)
    taken = Signal(int)
    dropped = Signal()
    closed = Signal()
    cancelled = Signal()

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(tr("Differences"), parent)
        self._filling = False
        self._model = DifferenceModel(self)
        self._model.ticked.connect(self.ticked)
        close = IconButton("close", tr("Close the comparison; nothing is changed"), "", self)
        close.clicked.connect(self.closed)
        self._count = quiet("", self)
        self.add_to_heading(self._count)
        self.add_to_heading(close)
        self._legend = PreviewLegend(self)
        self._build_list()
        body = QVBoxLayout()
        body.setSpacing(6)
        body.addWidget(self._legend)
        body.addLayout(self._build_choices())
        body.addWidget(self._list, 1)
        self._text = QLabel(self)
        self._text.setWordWrap(True)
        body.addWidget(self._text)
        self._working = WorkLine(tr("Cancel comparing"), self)
        self._working.cancelled.connect(self.cancelled)
        body.addWidget(self._working)
        body.addLayout(self._build_ticks())
        body.addLayout(self._build_ends())
        body.addStretch(0)
        self.layout_body(body)
        self.hide()

    def _build_list(self) -> None:
        self._list = DifferenceView(self._model, self)
        self._list.setAccessibleName(tr("Differences"))
        self._list.selectionModel().currentChanged.connect(lambda now, _: self._choose(now.row()))
        self._list.clicked.connect(lambda index: self._choose(index.row()))

    def _choose(self, row: int) -> None:
        if row >= 0 and not self._filling:
            self.chosen.emit(self._model.item(row).number)

    def _build_choices(self) -> QHBoxLayout:
        self._people = self._combo(tr("Whose differences are listed"))
        self._people.activated.connect(
            lambda at: self.person_chosen.emit(self._people.itemData(at))
        )
        self._orders = self._combo(tr("Order of the differences"))
        self._orders.addItem(tr("by time"), DifferenceOrder.TIME.value)
        self._orders.addItem(tr("by person"), DifferenceOrder.PERSON.value)
        self._orders.activated.connect(lambda at: self.order_chosen.emit(self._orders.itemData(at)))
        line = QHBoxLayout()
        line.addWidget(self._people, 1)
        line.addWidget(self._orders)
        return line

    def _combo(self, name: str) -> QComboBox:
        combo = QComboBox(self)
        combo.setAccessibleName(name)
        combo.setToolTip(name)
        combo.setFont(scaled_font(self.font(), 0.92))
        combo.setSizeAdjustPolicy(QComboBox.SizeAdjustPolicy.AdjustToMinimumContentsLengthWithIcon)
        combo.setMinimumContentsLength(6)
        return combo

    def _build_ticks(self) -> QHBoxLayout:
        line = QHBoxLayout()
        self._ticks = quiet("", self)
        self._tick_line: list[QWidget] = [self._ticks]
        line.addWidget(self._ticks, 1)
        for text, name, on in (
            (tr("Tick all"), tr("Tick all in the list"), True),
            (tr("None"), tr("Untick all in the list"), False),
        ):
            button = QPushButton(text, self)
            button.setProperty("link", True)
            button.setAccessibleName(name)
            button.setToolTip(name)
            button.clicked.connect(lambda _=False, on=on: self.all_ticked.emit(on))
            line.addWidget(button)
            line.addSpacing(8)
            self._tick_line.append(button)
        return line

    def _build_ends(self) -> QVBoxLayout:
        self._take_dashed = QPushButton(self)
        self._take_dashed.setProperty("primary", True)
        self._take_dashed.setAccessibleName(tr("Take what is ticked from the dashed version"))
        self._take_dashed.clicked.connect(lambda: self.taken.emit(1))
        self._take_solid = QPushButton(self)
        self._take_solid.setAccessibleName(tr("Take what is ticked from the solid version"))
        self._take_solid.clicked.connect(lambda: self.taken.emit(0))
        self._drop = QPushButton(tr("Delete this run"), self)
        self._drop.setToolTip(tr("Delete the run; otherwise it is kept among the runs"))
        self._drop.clicked.connect(self.dropped)
        self._close = QPushButton(tr("Close"), self)
        self._close.setToolTip(tr("Take nothing more; the run is kept among the runs"))
        self._close.clicked.connect(self.closed)
        rows = QVBoxLayout()
        rows.setSpacing(6)
        rows.addWidget(self._take_dashed)
        rows.addWidget(self._take_solid)
        line = QHBoxLayout()
        line.addWidget(self._drop)
        line.addStretch(1)
        line.addWidget(self._close)
        rows.addLayout(line)
        return rows

    def show_scene(self, scene: DifferencesScene | None) -> None:
        """Show another comparison, or none."""
        self.setVisible(scene is not None)
        if scene is None:
            return
        self._filling = True
        self._model.take(scene.items)
        self._select(scene.current)
        self._show_people(scene)
        self._filling = False
        self._orders.setCurrentIndex(self._orders.findData(scene.order.value))
        self._legend.set_words(scene.dashed.short, scene.solid.short)
        self._count.setText(str(len(scene.items)) if scene.items else "")
        listed = bool(scene.items)
        for widget in (self._legend, self._list, self._people, self._orders):
            widget.setVisible(listed)
        for part in self._tick_line:
            part.setVisible(scene.takeable > 0)
        self._text.setText(scene.text)
        self._text.setVisible(bool(scene.text))
        self._working.show_work(scene.doing, scene.share)
        self._ticks.setText(_ticks_of(scene))
        self._show_ends(scene)

    def _show_ends(self, scene: DifferencesScene) -> None:
        take = tr("Take {0} from {1}")
        self._take_dashed.setText(literal(take.format(scene.ticked, scene.dashed.short)))
        self._take_solid.setText(literal(take.format(scene.ticked, scene.solid.short)))
        self._take_dashed.setVisible(scene.takeable > 0)
        self._take_solid.setVisible(scene.takeable > 0 and scene.solid.can_give)
        for button in (self._take_dashed, self._take_solid):
            button.setEnabled(scene.ticked > 0 and not scene.doing)
        self._drop.setVisible(scene.can_drop)

    def _select(self, row: int) -> None:
        if row < 0:
            self._list.clearSelection()
            return
        index = self._model.index(row)
        self._list.setCurrentIndex(index)
        self._list.scrollTo(index)

    def _show_people(self, scene: DifferencesScene) -> None:
        titles = [(tr("Everybody"), 0)]
        titles += [(person.label, person.track) for person in scene.people]
        combo = self._people
        if titles != [(combo.itemText(at), combo.itemData(at)) for at in range(combo.count())]:
            combo.clear()
            for title, track in titles:
                combo.addItem(title, track)
        combo.setCurrentIndex(max(0, combo.findData(scene.person)))


def _ticks_of(scene: DifferencesScene) -> str:
    """How many of all are ticked, and how many cannot be."""
    said = tr("{n} of {all} ticked", n=scene.ticked, all=scene.takeable + scene.locked)
    if not scene.locked:
        return said
    return said + ", " + count_text(scene.locked, "{n} is locked", "{n} are locked")

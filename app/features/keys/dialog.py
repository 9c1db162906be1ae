"""The dialog in which the keys of commands are changed."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path

from PySide6.QtCore import Qt, Signal
from PySide6.QtWidgets import (
    QComboBox,
    QDialog,
    QDialogButtonBox,
    QHBoxLayout,
    QHeaderView,
    QLabel,
    QLineEdit,
    QMenu,
    QPushButton,
    QStyle,
    QTableWidget,
    QTableWidgetItem,
    QVBoxLayout,
    QWidget,
)

from app.core.error_messages import explain_in_sentence
from app.core.i18n import count_text, some_of, tr
from app.core.widgets.command_list import native_keys
from app.core.widgets.questions import choose_file, choose_new_file
from app.core.widgets.user_settings import LastFolder
from app.features.keys.key_field import KeyField
from app.features.keys.presenter import KeysPresenter
from app.features.keys.profile_file import profile_text, read_profile
from app.features.keys.scene import SHIPPED, KeyRow, OwnKeys
from tracking.atomic_output import replace_with
from tracking.errors import TrackwrightError

_ROWS = 16
_MARGIN_PX = 20
_MOST_NAMED = 3
_COMMAND = Qt.ItemDataRole.UserRole
_FILES = "*.toml"


class KeysDialog(QDialog):
    """All commands with their keys.

    Signals: `changed(object)`: the `OwnKeys` that are to be used from now on.
    """

    changed = Signal(object)

    def __init__(self, presenter: KeysPresenter, last: LastFolder, parent: QWidget) -> None:
        """last: the folder in which a file of keys was chosen last."""
        super().__init__(parent)
        self.setAttribute(Qt.WidgetAttribute.WA_DeleteOnClose)
        self.setWindowTitle(tr("Keys"))
        self._presenter, self._last = presenter, last
        self._rows: tuple[KeyRow, ...] = ()
        self._pending: Callable[[], object] | None = None
        rows = QVBoxLayout(self)
        rows.setContentsMargins(_MARGIN_PX, 20, _MARGIN_PX, 16)
        rows.setSpacing(10)
        rows.addLayout(self._build_head())
        self.table = self._build_table()
        rows.addWidget(self.table, 1)
        rows.addLayout(self._build_actions())
        rows.addLayout(self._build_question())
        rows.addWidget(self._build_ends())
        self._show()
        self.search.setFocus()
        self._fit()

    # parts

    def _build_head(self) -> QHBoxLayout:
        self.search = QLineEdit(self)
        self.search.setPlaceholderText(tr("Find a command or a key"))
        self.search.setAccessibleName(tr("Find a command or a key"))
        self.search.setClearButtonEnabled(True)
        self.search.textChanged.connect(self._show)
        self.profile = QComboBox(self)
        self.profile.setAccessibleName(tr("Profile of keys"))
        for name, title in SHIPPED.items():
            self.profile.addItem(title, name)
        self.profile.activated.connect(self._choose_profile)
        label = QLabel(tr("&Profile"), self)
        label.setBuddy(self.profile)
        line = QHBoxLayout()
        line.setSpacing(8)
        line.addWidget(self.search, 1)
        line.addSpacing(12)
        line.addWidget(label)
        line.addWidget(self.profile)
        return line

    def _build_table(self) -> QTableWidget:
        table = QTableWidget(0, 3, self)
        table.setAccessibleName(tr("Commands and their keys"))
        table.setHorizontalHeaderLabels([tr("Command"), tr("Menu"), tr("Keys")])
        table.verticalHeader().hide()
        table.setSelectionBehavior(QTableWidget.SelectionBehavior.SelectRows)
        table.setSelectionMode(QTableWidget.SelectionMode.SingleSelection)
        table.setEditTriggers(QTableWidget.EditTrigger.NoEditTriggers)
        table.setTabKeyNavigation(False)
        table.setWordWrap(False)
        table.setShowGrid(False)
        head = table.horizontalHeader()
        head.setDefaultAlignment(Qt.AlignmentFlag.AlignLeft | Qt.AlignmentFlag.AlignVCenter)
        head.setHighlightSections(False)
        head.setSectionResizeMode(0, QHeaderView.ResizeMode.Stretch)
        head.setSectionResizeMode(1, QHeaderView.ResizeMode.ResizeToContents)
        head.setSectionResizeMode(2, QHeaderView.ResizeMode.ResizeToContents)
        table.currentCellChanged.connect(self._enable)
        table.cellDoubleClicked.connect(self._wait_for_key)
        return table

    def _build_actions(self) -> QHBoxLayout:
        self.add = self._button(tr("&Add a key"), self._wait_for_key)
        self.remove = self._button(tr("&Remove a key"), self._ask_which)
        self.keys_menu = QMenu(self)
        self.reset = self._button(tr("Rese&t"), self._reset)
        self.field = KeyField(self)
        self.field.pressed.connect(self._take)
        self.field.left.connect(self.field.hide)
        self.field.hide()
        line = QHBoxLayout()
        line.setSpacing(8)
        for widget in (self.add, self.remove, self.reset):
            line.addWidget(widget)
        line.addWidget(self.field, 1)
        line.addStretch(1)
        return line

    def _build_question(self) -> QHBoxLayout:
        """What a conflict asks, and what else is said."""
        self.said = QLabel(self)
        self.said.setTextFormat(Qt.TextFormat.PlainText)
        self.said.setWordWrap(True)
        self.take = self._button("", self._answer)
        self.leave = self._button(tr("Leave it"), self._leave)
        for answer in (self.take, self.leave):
            answer.setAutoDefault(True)  # whoever came by keys answers by Enter
        line = QHBoxLayout()
        line.setSpacing(8)
        line.addWidget(self.said, 1)
        line.addWidget(self.take)
        line.addWidget(self.leave)
        self._say("")
        return line

    def _build_ends(self) -> QDialogButtonBox:
        box = QDialogButtonBox(QDialogButtonBox.StandardButton.Close, self)
        role = QDialogButtonBox.ButtonRole.ActionRole
        self.reset_all = self._button(tr("Reset all"), self._reset_all)
        for button in (
            self._button(tr("Import..."), self._import),
            self._button(tr("Export..."), self._export),
            self.reset_all,
        ):
            box.addButton(button, role)
        box.button(QDialogButtonBox.StandardButton.Close).setAutoDefault(False)
        box.rejected.connect(self.reject)
        return box

    def _button(self, text: str, act: Callable[[], object]) -> QPushButton:
        button = QPushButton(text, self)
        button.setAutoDefault(False)
        button.clicked.connect(lambda: act())
        return button

    # what is shown

    def _fit(self) -> None:
        """As wide as all commands, menus and keys are, as far as the screen has room."""
        room = self.screen().availableSize() * 0.9
        columns = sum(map(self.table.sizeHintForColumn, range(self.table.columnCount())))
        bar = self.style().pixelMetric(QStyle.PixelMetric.PM_ScrollBarExtent)
        wide = columns + 2 * (bar + _MARGIN_PX)
        high = (_ROWS + 12) * self.fontMetrics().height()
        self.resize(min(wide, room.width()), min(high, room.height()))

    def _show(self, typed: str | None = None) -> None:
        """Fill the table anew; the same command stays chosen."""
        chosen = self._command
        self._rows = self._presenter.rows(self.search.text() if typed is None else typed)
        self.table.setRowCount(len(self._rows))
        for line, row in enumerate(self._rows):
            keys = "    ".join(map(native_keys, row.keys))
            told = tr("{keys}  (changed)", keys=keys).strip() if row.changed else keys
            for column, text in enumerate((row.title, row.menu, told)):
                item = QTableWidgetItem(text)
                item.setData(_COMMAND, row.command)
                self.table.setItem(line, column, item)
        names = [row.command for row in self._rows]
        self.table.setCurrentCell(names.index(chosen) if chosen in names else 0, 0)
        self.profile.setCurrentIndex(self.profile.findData(self._presenter.own.profile))
        self._enable()

    def _enable(self) -> None:
        command = self._command
        self.add.setEnabled(bool(command))
        self.remove.setEnabled(bool(command) and bool(self._presenter.keys[command]))
        self.reset.setEnabled(bool(command) and self._presenter.is_changed(command))
        self.reset_all.setEnabled(bool(self._presenter.own.changes))

    @property
    def _command(self) -> str:
        item = self.table.item(self.table.currentRow(), 0)
        return str(item.data(_COMMAND)) if item is not None else ""

    def _say(self, text: str) -> None:
        """Say something; what was asked is asked no longer."""
        self._pending = None
        self.said.setText(text)
        self.take.hide()
        self.leave.hide()

    def _ask(self, text: str, answer: str, act: Callable[[], object]) -> None:
        """Ask whether to do something; `answer` is what the button says that does it."""
        self._say(text)
        self._pending = act
        self.take.setText(answer)
        self.take.show()
        self.leave.show()
        self.take.setFocus()

    # what the user does

    def _wait_for_key(self, *_: int) -> None:
        if self._command:
            self._say("")
            self.field.show()
            self.field.setFocus()

    def _take(self, key: str) -> None:
        self.table.setFocus()
        command = self._command
        owner = self._presenter.owner(command, key)
        if not owner:
            self._add(command, key)
            return
        row = self._rows[self.table.currentRow()]
        words = tr(
            '{key} belongs to "{owner}". Take it for "{title}"?',
            key=native_keys(key),
            owner=owner.rstrip("."),
            title=row.title.rstrip("."),
        )
        self._ask(words, tr("Take it"), lambda: self._add(command, key))

    def _add(self, command: str, key: str) -> None:
        self._presenter.add(command, key)
        self._tell()

    def _answer(self) -> None:
        pending = self._pending
        self._leave()
        if pending is not None:
            pending()

    def _leave(self) -> None:
        self._say("")
        self._show()
        self.table.setFocus()

    def _ask_which(self) -> None:
        """Which key is removed, where there are several."""
        command, keys = self._command, self._presenter.keys[self._command]
        if len(keys) == 1:
            self._remove(command, keys[0])
            return
        self.keys_menu.clear()
        for key in keys:
            self.keys_menu.addAction(native_keys(key)).triggered.connect(
                lambda _=False, key=key: self._remove(command, key)
            )
        self.keys_menu.popup(self.remove.mapToGlobal(self.remove.rect().bottomLeft()))

    def _remove(self, command: str, key: str) -> None:
        self._presenter.remove(command, key)
        self._tell()

    def _reset(self) -> None:
        self._presenter.reset(self._command)
        self._tell()

    def _reset_all(self) -> None:
        self._presenter.reset_all()
        self._tell()

    def _choose_profile(self) -> None:
        """Another profile; keys of the user's own are of the one before, and go with it."""
        name, title = self.profile.currentData(), self.profile.currentText()
        if name != self._presenter.own.profile:
            self._replace(OwnKeys(name), tr("the profile {title}", title=title))

    def _replace(self, own: OwnKeys, what: str) -> None:
        """Use other keys; asked first where some of the user's own would be lost."""

        def use() -> None:
            self._presenter.choose(own)
            self._tell()

        changed = len(self._presenter.own.changes)
        if not changed:
            use()
            return
        words = count_text(
            changed,
            "Use {what}? It replaces your keys of {n} command; Export keeps them.",
            "Use {what}? It replaces your keys of {n} commands; Export keeps them.",
            what=what,
        )
        self._ask(words, tr("Use it"), use)

    def _tell(self) -> None:
        self._say("")
        self._show()
        self.changed.emit(self._presenter.own)

    def _import(self) -> None:
        choose_file(self, tr("Import keys"), self._filter(), self.read, self._last)

    def _export(self) -> None:
        start = Path.home() / "trackwright-keys.toml"
        choose_new_file(self, tr("Export keys"), start, self._filter(), self.write, self._last)

    def read(self, path: Path) -> None:
        """Use the profile in a file, or say why not."""
        try:
            own = read_profile(path, self._presenter.keys)
        except TrackwrightError as error:
            self._say(explain_in_sentence(error))
            return
        what = path.name
        if own.unknown:
            what = count_text(
                len(own.unknown),
                "{file} without {n} command that is unknown here, {names}",
                "{file} without {n} commands that are unknown here, {names}",
                file=path.name,
                names=some_of(own.unknown, _MOST_NAMED),
            )
        self._replace(OwnKeys(own.profile, own.changes), what)
        if self._pending is None:
            self._say(tr("These are the keys of {what}", what=what))

    def write(self, path: Path) -> None:
        """Write the profile to a file, or say why not."""
        try:
            replace_with(path, profile_text(self._presenter.own).encode())
        except TrackwrightError as error:
            self._say(explain_in_sentence(error))
            return
        self._say(tr("Written: {path}", path=path))

    @staticmethod
    def _filter() -> str:
        return tr("Keys ({ending})", ending=_FILES)

"""The first page: open, recent, drop a file, try the demo."""

from __future__ import annotations

from pathlib import Path

from PySide6.QtCore import Qt, Signal
from PySide6.QtGui import (
    QDragEnterEvent,
    QDragLeaveEvent,
    QDropEvent,
    QPainter,
    QPaintEvent,
    QPen,
)
from PySide6.QtWidgets import QHBoxLayout, QLabel, QPushButton, QVBoxLayout, QWidget

from app.core.i18n import tr
from app.core.keymap import first_key
from app.core.look.icons import application_icon
from app.core.look.theme import current_theme, faded, scaled_font
from app.core.scenes import WelcomeScene
from app.core.widgets.fitted_scroll import ScrolledPanel
from app.core.widgets.parts import heading, quiet
from app.core.widgets.tab_order import tab_in_reading_order
from app.features.welcome.welcome_parts import ChoiceButton, RecentRow, draw_floor

_WIDTH_LETTERS = 130


class WelcomePage(QWidget):
    """Draws a :class:`WelcomeScene`; files may be dropped anywhere on it.

    Signals:
        open_asked(), project_asked(), setup_asked(), demo_asked(): the buttons.
        path_chosen(object): a recent `Path`.
        dropped(object): the list of `QUrl` that were dropped.
    """

    open_asked = Signal()
    project_asked = Signal()
    setup_asked = Signal()
    demo_asked = Signal()
    path_chosen = Signal(object)
    dropped = Signal(object)

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self._over = False
        self.setAcceptDrops(True)
        self.setAccessibleName(tr("Welcome"))
        column = QWidget(self)
        column.setMaximumWidth(_WIDTH_LETTERS * self.fontMetrics().averageCharWidth())
        rows = QVBoxLayout(column)
        rows.setContentsMargins(24, 24, 24, 24)
        rows.setSpacing(16)
        rows.addStretch(2)
        rows.addLayout(self._build_title())
        rows.addSpacing(8)
        rows.addWidget(self._build_notice())
        rows.addLayout(self._build_choices())
        rows.addWidget(self._build_project(), 0, Qt.AlignmentFlag.AlignLeft)
        rows.addWidget(self._build_recent())
        rows.addStretch(3)
        across = QHBoxLayout(self)
        across.addStretch(1)
        across.addWidget(column, 20)
        across.addStretch(1)
        self.show_scene(WelcomeScene())
        tab_in_reading_order(self)

    def _build_title(self) -> QHBoxLayout:
        row = QHBoxLayout()
        row.setSpacing(20)
        self._picture = QLabel(self)
        side = 4 * self.fontMetrics().height()
        self._picture.setPixmap(application_icon().pixmap(side, side))
        words = QVBoxLayout()
        words.setSpacing(4)
        words.addStretch(1)
        name = QLabel("trackwright", self)
        name.setFont(scaled_font(self.font(), 2.4, bold=True))
        words.addWidget(name)
        said = tr("Track people in recorded stereo footage, and correct the errors.")
        line = quiet(said, self)
        line.setFont(scaled_font(self.font(), 1.1))
        line.setWordWrap(True)
        words.addWidget(line)
        words.addStretch(1)
        row.addWidget(self._picture)
        row.addLayout(words, 1)
        return row

    def _build_notice(self) -> QLabel:
        self._notice = QLabel(self)
        self._notice.setWordWrap(True)
        self._notice.setProperty("role", "notice")
        return self._notice

    def _build_choices(self) -> QHBoxLayout:
        row = QHBoxLayout()
        row.setSpacing(16)
        self._opening = opening = ChoiceButton("open", tr("Open\u2026"), "", self)
        opening.say(tr("A recording, a video or a session. You can also drop it here."))
        opening.clicked.connect(self.open_asked)
        demo = ChoiceButton("demo", tr("Try the demo"), "", self)
        demo.say(tr("Makes a short stereo recording with people walking, and tracks it."))
        demo.clicked.connect(self.demo_asked)
        setup = ChoiceButton("settings", tr("Set up a recording\u2026"), "", self)
        setup.say(tr("From the videos of one camera or two to places in metres."))
        setup.clicked.connect(self.setup_asked)
        row.addWidget(opening, 1)
        row.addWidget(setup, 1)
        row.addWidget(demo, 1)
        return row

    def _build_project(self) -> QPushButton:
        button = QPushButton(tr("Open a folder of recordings as a project\u2026"), self)
        button.setProperty("link", True)
        button.setCursor(Qt.CursorShape.PointingHandCursor)
        button.setToolTip(
            tr("Lists recordings and sessions: who works on what, and what to review next.")
        )
        button.clicked.connect(self.project_asked)
        return button

    def _build_recent(self) -> ScrolledPanel:
        scrolled = ScrolledPanel(self)  # however many there are, the window fits its screen
        scrolled.setProperty("card", True)
        card = scrolled.content
        rows = QVBoxLayout(card)
        rows.setContentsMargins(8, 12, 8, 8)
        rows.setSpacing(4)
        title = heading(tr("Recent"), card)
        title.setIndent(10)
        rows.addWidget(title)
        self._recent = QVBoxLayout()
        self._recent.setSpacing(0)
        rows.addLayout(self._recent)
        self._none = quiet(tr("Recordings and sessions you have opened are listed here."), card)
        self._none.setIndent(10)
        rows.addWidget(self._none)
        return scrolled

    def name_keys(self) -> None:
        """Name the keys in use, which the user may have changed."""
        self._opening.set_keys(first_key("file.open"))

    def show_scene(self, scene: WelcomeScene) -> None:
        """Show what was opened before, and a notice."""
        self._notice.setText(scene.notice)
        self._notice.setVisible(bool(scene.notice))
        self._none.setVisible(not scene.recent)
        while (old := self._recent.takeAt(0)) is not None:
            if (widget := old.widget()) is not None:
                widget.deleteLater()
        for item in scene.recent:
            row = RecentRow(item, self)
            row.clicked.connect(lambda _=False, path=item.path: self.path_chosen.emit(Path(path)))
            self._recent.addWidget(row)
        tab_in_reading_order(self)

    def dragEnterEvent(self, event: QDragEnterEvent) -> None:  # noqa: N802 - Qt's name
        """Take files from this machine."""
        if any(url.isLocalFile() for url in event.mimeData().urls()):
            event.acceptProposedAction()
            self._over = True
            self.update()

    def dragLeaveEvent(self, event: QDragLeaveEvent) -> None:  # noqa: ARG002, N802
        """Not here after all."""
        self._over = False
        self.update()

    def dropEvent(self, event: QDropEvent) -> None:  # noqa: N802
        """Tell what was dropped."""
        self._over = False
        self.update()
        event.acceptProposedAction()
        self.dropped.emit(event.mimeData().urls())

    def paintEvent(self, event: QPaintEvent) -> None:  # noqa: ARG002, N802
        """A floor with two paths; a frame while something hangs over the page."""
        theme, painter = current_theme(), QPainter(self)
        painter.setRenderHint(QPainter.RenderHint.Antialiasing)
        draw_floor(painter, self.rect().toRectF(), theme)
        if self._over:
            painter.setPen(QPen(theme.accent, 2, Qt.PenStyle.DashLine))
            painter.setBrush(faded(theme.accent, 0.08))
            painter.drawRoundedRect(self.rect().adjusted(12, 12, -12, -12), 12, 12)
        painter.end()

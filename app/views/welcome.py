"""The first page: open, recent, drop a file, try the demo."""

from __future__ import annotations

from pathlib import Path

from PySide6.QtCore import QEvent, QSize, Qt, Signal, SignalInstance
from PySide6.QtGui import (
    QDragEnterEvent,
    QDragLeaveEvent,
    QDropEvent,
    QFontMetrics,
    QPainter,
    QPaintEvent,
    QPen,
)
from PySide6.QtWidgets import (
    QFrame,
    QHBoxLayout,
    QLabel,
    QPushButton,
    QToolButton,
    QVBoxLayout,
    QWidget,
)

from app.presenters.scenes import RecentItem, WelcomeScene
from app.views.icons import application_icon, icon
from app.views.parts import heading, quiet
from app.views.theme import faded, scaled_font, theme_of

_WIDTH_LETTERS = 96


class WelcomePage(QWidget):
    """Draws a :class:`WelcomeScene`; files may be dropped anywhere on it.

    Signals:
        open_asked(), demo_asked(): the buttons.
        path_chosen(object): a `Path`, recent or dropped.
    """

    open_asked = Signal()
    demo_asked = Signal()
    path_chosen = Signal(object)

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self._over = False
        self.setAcceptDrops(True)
        self.setAccessibleName(self.tr("Welcome"))
        column = QWidget(self)
        column.setMaximumWidth(_WIDTH_LETTERS * self.fontMetrics().averageCharWidth())
        rows = QVBoxLayout(column)
        rows.setContentsMargins(24, 24, 24, 24)
        rows.setSpacing(16)
        rows.addStretch(2)
        rows.addLayout(self._build_title())
        self._notice = self._build_notice(rows)
        rows.addSpacing(8)
        rows.addLayout(self._build_actions())
        rows.addWidget(self._build_recent())
        rows.addStretch(3)
        across = QHBoxLayout(self)
        across.addStretch(1)
        across.addWidget(column, 8)
        across.addStretch(1)
        self.show_scene(WelcomeScene())

    def _build_title(self) -> QHBoxLayout:
        row = QHBoxLayout()
        row.setSpacing(16)
        picture = QLabel(self)
        picture.setPixmap(application_icon().pixmap(QSize(64, 64), self.devicePixelRatioF()))
        words = QVBoxLayout()
        words.setSpacing(2)
        name = QLabel("trackwright", self)
        name.setFont(scaled_font(self.font(), 2.2, bold=True))
        words.addWidget(name)
        words.addWidget(
            quiet(self.tr("Follow people in recorded stereo footage, and put it right."), self)
        )
        row.addWidget(picture)
        row.addLayout(words, 1)
        return row

    def _build_notice(self, rows: QVBoxLayout) -> QLabel:
        notice = QLabel(self)
        notice.setWordWrap(True)
        notice.setProperty("role", "notice")
        rows.addWidget(notice)
        return notice

    def _build_actions(self) -> QHBoxLayout:
        row = QHBoxLayout()
        row.setSpacing(12)
        self._open = self._action(self.tr("Open\u2026"), self.open_asked)
        self._open.setAccessibleName(self.tr("Open a recording or a session"))
        self._open.setProperty("primary", True)
        self._demo = self._action(self.tr("Try the demo"), self.demo_asked)
        self._demo.setAccessibleName(self.tr("Make the built-in recording and open it"))
        row.addWidget(self._open)
        row.addWidget(self._demo)
        row.addWidget(quiet(self.tr("or drop a recording, a video or a session here"), self), 1)
        self._recolour()
        return row

    def _action(self, text: str, signal: SignalInstance) -> QPushButton:
        button = QPushButton(text, self)
        button.setFont(scaled_font(self.font(), 1.1, bold=True))
        button.setIconSize(QSize(20, 20))
        button.clicked.connect(signal)
        return button

    def _build_recent(self) -> QFrame:
        card = QFrame(self)
        card.setProperty("card", True)
        rows = QVBoxLayout(card)
        rows.setContentsMargins(16, 12, 16, 12)
        rows.setSpacing(4)
        rows.addWidget(heading(self.tr("Recent"), card))
        self._recent = QVBoxLayout()
        self._recent.setSpacing(0)
        rows.addLayout(self._recent)
        self._none = quiet(self.tr("Recordings and sessions you open are listed here."), card)
        rows.addWidget(self._none)
        return card

    def show_scene(self, scene: WelcomeScene) -> None:
        """Show what was opened before, and a notice."""
        self._notice.setText(scene.notice)
        self._notice.setVisible(bool(scene.notice))
        self._none.setVisible(not scene.recent)
        while (old := self._recent.takeAt(0)) is not None:
            widget = old.widget()
            if widget is not None:
                widget.deleteLater()
        for item in scene.recent:
            row = RecentRow(item, self)
            row.clicked.connect(lambda _=False, path=item.path: self.path_chosen.emit(Path(path)))
            self._recent.addWidget(row)

    def changeEvent(self, event: QEvent) -> None:  # noqa: N802 - Qt's name
        """Follow the theme."""
        super().changeEvent(event)
        if event.type() == QEvent.Type.PaletteChange and hasattr(self, "_demo"):
            self._recolour()

    def _recolour(self) -> None:
        theme = theme_of(self)
        self._open.setIcon(icon("open", theme.accent_text))
        self._demo.setIcon(icon("demo", theme.text))

    def dragEnterEvent(self, event: QDragEnterEvent) -> None:  # noqa: N802
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
        """Open the first file or folder."""
        self._over = False
        self.update()
        paths = [Path(url.toLocalFile()) for url in event.mimeData().urls() if url.isLocalFile()]
        event.acceptProposedAction()
        if paths:
            self.path_chosen.emit(paths[0])

    def paintEvent(self, event: QPaintEvent) -> None:  # noqa: ARG002, N802
        """A frame while something hangs over the page."""
        if self._over:
            theme, painter = theme_of(self), QPainter(self)
            painter.setRenderHint(QPainter.RenderHint.Antialiasing)
            painter.setPen(QPen(theme.accent, 2, Qt.PenStyle.DashLine))
            painter.setBrush(faded(theme.accent, 0.08))
            painter.drawRoundedRect(self.rect().adjusted(12, 12, -12, -12), 12, 12)
            painter.end()


class RecentRow(QToolButton):
    """One recording or session: its title, and where it is below."""

    def __init__(self, item: RecentItem, parent: QWidget) -> None:
        super().__init__(parent)
        self._item = item
        self.setEnabled(item.exists)
        self.setAccessibleName(self.tr("Open {0}").format(item.title))
        self.setToolTip(item.path)
        policy = self.sizePolicy()
        policy.setHorizontalPolicy(policy.Policy.Expanding)
        self.setSizePolicy(policy)
        self.setCursor(Qt.CursorShape.PointingHandCursor)

    def sizeHint(self) -> QSize:  # noqa: N802 - Qt's name
        """Two lines of text."""
        small = QFontMetrics(scaled_font(self.font(), 0.88))
        return QSize(240, self.fontMetrics().height() + small.height() + 16)

    def paintEvent(self, event: QPaintEvent) -> None:  # noqa: N802
        """The button's ground, then both lines."""
        super().paintEvent(event)
        theme, painter = theme_of(self), QPainter(self)
        inner = self.rect().adjusted(12, 7, -12, -7)
        font = scaled_font(self.font(), 1.0, bold=True)
        painter.setFont(font)
        painter.setPen(theme.text if self._item.exists else theme.text_faint)
        middle = Qt.TextElideMode.ElideMiddle
        painter.drawText(
            inner,
            Qt.AlignmentFlag.AlignTop,
            painter.fontMetrics().elidedText(self._item.title, middle, inner.width()),
        )
        painter.setFont(scaled_font(self.font(), 0.88))
        painter.setPen(theme.text_muted if self._item.exists else theme.text_faint)
        detail = self._item.detail if self._item.exists else self.tr("not there any more")
        text = "  \u00b7  ".join(part for part in (detail, self._item.path) if part)
        painter.drawText(
            inner,
            Qt.AlignmentFlag.AlignBottom,
            painter.fontMetrics().elidedText(text, middle, inner.width()),
        )
        painter.end()

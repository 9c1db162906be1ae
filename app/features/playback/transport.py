"""The line between the views and the timeline: play, step, where, how fast."""

from __future__ import annotations

from PySide6.QtCore import QEvent, Qt, Signal
from PySide6.QtGui import QActionGroup, QFocusEvent, QIntValidator, QKeyEvent
from PySide6.QtWidgets import (
    QFrame,
    QHBoxLayout,
    QLabel,
    QLineEdit,
    QMenu,
    QSizePolicy,
    QToolButton,
    QWidget,
)

from app.core.i18n import tr
from app.core.keymap import in_brackets
from app.core.look.icons import IconButton
from app.core.look.theme import current_theme, scaled_font
from app.core.playback.clock import SPEEDS
from app.core.scenes import TransportScene
from app.core.widgets.literal import literal
from app.core.widgets.parts import Swatch, quiet
from app.features.playback.room_left import RoomLeft


def clock_text(time_s: float) -> str:
    """Minutes, seconds and hundredths; hours where there are any."""
    hundredths = round(max(time_s, 0.0) * 100)
    minutes, rest = divmod(hundredths, 6000)
    hours, minutes = divmod(minutes, 60)
    lead = f"{hours}:" if hours else ""
    return f"{lead}{minutes:02d}:{rest // 100:02d}.{rest % 100:02d}"


class FrameEdit(QLineEdit):
    """The frame number; typing another and Enter goes there, Esc leaves it."""

    left = Signal()

    def keyPressEvent(self, event: QKeyEvent) -> None:  # noqa: N802 - Qt's name
        """Give the keyboard back on Esc."""
        if event.key() == Qt.Key.Key_Escape:
            self.left.emit()
            self.clearFocus()
        else:
            super().keyPressEvent(event)

    def focusOutEvent(self, event: QFocusEvent) -> None:  # noqa: N802
        """Drop what was typed but not sent."""
        super().focusOutEvent(event)
        self.left.emit()


class TransportBar(QFrame):
    """Draws a :class:`TransportScene`.

    Signals:
        play_toggled(): play or pause.
        frame_sought(int): to the first, the last or a typed frame.
        stepped(int): by so many frames.
        speed_chosen(float): from the menu.
        tracker_clicked(): on the tracker's name.
        follow_toggled(): have the playhead go with the tracker at work, or not.
    """

    play_toggled = Signal()
    frame_sought = Signal(int)
    stepped = Signal(int)
    speed_chosen = Signal(float)
    tracker_clicked = Signal()
    follow_toggled = Signal()

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self._scene: TransportScene | None = None
        self.setProperty("bar", True)
        self.setAccessibleName(tr("Playback"))
        row = QHBoxLayout(self)
        row.setContentsMargins(12, 4, 12, 4)
        row.setSpacing(4)
        self._build_buttons(row)
        row.addSpacing(12)
        self._build_place(row)
        state = QWidget(self)
        self._build_state(state)
        self._rest = RoomLeft(state, self)
        row.addWidget(self._rest, 1)

    def _build_buttons(self, row: QHBoxLayout) -> None:
        self._play = IconButton("play", tr("Play"), "play.toggle", self, primary=True)
        self._play.clicked.connect(self.play_toggled)
        first = IconButton("first", tr("First frame"), "play.start", self)
        first.clicked.connect(lambda: self.frame_sought.emit(0))
        back = IconButton("step-back", tr("Previous frame"), "play.previous", self)
        back.clicked.connect(lambda: self.stepped.emit(-1))
        forward = IconButton("step-forward", tr("Next frame"), "play.next", self)
        forward.clicked.connect(lambda: self.stepped.emit(1))
        last = IconButton("last", tr("Last frame"), "play.end", self)
        last.clicked.connect(lambda: self.frame_sought.emit(self._last_frame()))
        for button in (back, forward):
            button.setAutoRepeat(True)
        for button in (first, back, self._play, forward, last):
            row.addWidget(button)
        row.addSpacing(4)
        self._build_speed(row)

    def _build_speed(self, row: QHBoxLayout) -> None:
        self._speed = QToolButton(self)
        self._speed.setPopupMode(QToolButton.ToolButtonPopupMode.InstantPopup)
        self._speed.setFocusPolicy(Qt.FocusPolicy.NoFocus)
        self._speed.setToolTip(tr("Speed"))
        menu = QMenu(self._speed)
        group = QActionGroup(menu)
        self._speed_actions = {}
        for speed in SPEEDS:
            action = menu.addAction(self._speed_text(speed))
            action.setCheckable(True)
            action.triggered.connect(lambda _=False, speed=speed: self.speed_chosen.emit(speed))
            group.addAction(action)
            self._speed_actions[speed] = action
        self._speed.setMenu(menu)
        row.addWidget(self._speed)

    def _build_place(self, row: QHBoxLayout) -> None:
        row.addWidget(quiet(tr("Frame"), self))
        self._frame = FrameEdit(self)
        self._frame.setProperty("quiet", True)
        self._frame.setAlignment(Qt.AlignmentFlag.AlignRight)
        self._frame.setFont(scaled_font(self.font(), 1.0, bold=True))
        self._frame.setAccessibleName(tr("Frame number"))
        self._frame.setToolTip(tr("Type a frame number and press Enter") + in_brackets("play.goto"))
        self._frame.setValidator(QIntValidator(0, 2**31 - 1, self))
        self._frame.setFocusPolicy(Qt.FocusPolicy.ClickFocus)
        self._frame.returnPressed.connect(self._seek_typed)
        self._frame.left.connect(self._write_frame)
        row.addWidget(self._frame)
        self._count = quiet("", self)
        row.addWidget(self._count)
        row.addSpacing(16)
        self._time = QLabel(self)
        self._time.setFont(scaled_font(self.font(), 1.0, bold=True))
        self._time.setAccessibleName(tr("Time"))
        row.addWidget(self._time)

    def _build_state(self, state: QWidget) -> None:
        row = QHBoxLayout(state)
        row.setContentsMargins(0, 0, 0, 0)
        row.setSpacing(4)
        self._tracker = QToolButton(self)
        self._tracker.setFocusPolicy(Qt.FocusPolicy.NoFocus)
        self._tracker.setToolTip(tr("Tracker and its settings"))
        self._tracker.clicked.connect(self.tracker_clicked)
        row.addWidget(self._tracker)
        row.addSpacing(8)
        self._light = Swatch(self)
        self._light.setSizePolicy(QSizePolicy.Policy.Fixed, QSizePolicy.Policy.Fixed)
        row.addWidget(self._light)
        self._status = quiet("", self)
        self._status.setAccessibleName(tr("State of the tracker"))
        row.addWidget(self._status)
        row.addSpacing(8)
        self._follow = QToolButton(self)
        self._follow.setFocusPolicy(Qt.FocusPolicy.NoFocus)
        self._follow.setCheckable(True)
        self._follow.setText(tr("Follow"))
        self._follow.setAccessibleName(tr("Follow the tracker"))
        self._follow.clicked.connect(self._ask_to_follow)
        row.addWidget(self._follow)

    def show_scene(self, scene: TransportScene) -> None:
        """Show another frame; while playing only the numbers are drawn anew."""
        before, self._scene = self._scene, scene
        if before is None or before.frame_count != scene.frame_count:
            self._widen(scene)
        if not self._frame.hasFocus():
            self._write_frame()
        self._write_time(scene.time_s)
        if before is None or before.playing != scene.playing:
            self._play.set_drawing("pause" if scene.playing else "play")
            self._play.set_name(tr("Pause") if scene.playing else tr("Play"))
        if before is None or (before.speed, before.loops) != (scene.speed, scene.loops):
            self._show_speed(scene.speed, scene.loops)
        if before is None or before.tracker != scene.tracker:
            self._tracker.setText(literal(scene.tracker))
            self._tracker.setVisible(bool(scene.tracker))
            self._tracker.setAccessibleName(tr("Tracker: {0}").format(scene.tracker))
        if before is None or (before.status, before.live) != (scene.status, scene.live):
            self._status.setText(scene.status)
            self._colour_light()
            self._rest.fit()
        if before is None or before.following is not scene.following:
            self._show_following(scene.following)

    def edit_frame(self) -> None:
        """Put the cursor into the frame number, to go elsewhere."""
        self._frame.setFocus(Qt.FocusReason.ShortcutFocusReason)
        self._frame.selectAll()

    def changeEvent(self, event: QEvent) -> None:  # noqa: N802
        """Follow the theme."""
        super().changeEvent(event)
        if event.type() == QEvent.Type.PaletteChange and self._scene is not None:
            self._colour_light()

    def _colour_light(self) -> None:
        theme = current_theme()
        status = self._scene.status if self._scene is not None else ""
        live = self._scene is not None and self._scene.live
        self._light.set_colour(theme.good if live else theme.line_strong)
        self._light.setVisible(bool(status))

    def _show_following(self, following: bool | None) -> None:
        """A button that stays down while the playhead goes with the tracker; None: no tracker."""
        self._follow.setVisible(following is not None)
        self._follow.setChecked(bool(following))
        self._follow.setText(tr("Following") if following else tr("Follow"))
        on = tr("The views follow the tracker until you move the playhead")
        off = tr("Follow the tracker: go to its frame and stay with it")
        self._follow.setToolTip((on if following else off) + in_brackets("play.follow"))
        self._rest.fit()

    def _ask_to_follow(self) -> None:
        """The button is down only once it is done: an edit may be in the way."""
        self._follow.setChecked(bool(self._scene and self._scene.following))
        self.follow_toggled.emit()

    def _last_frame(self) -> int:
        return self._scene.frame_count - 1 if self._scene is not None else 0

    def _seek_typed(self) -> None:
        wanted = min(int(self._frame.text()), self._last_frame())
        self._frame.clearFocus()
        self.frame_sought.emit(wanted)

    def _write_frame(self) -> None:
        if self._scene is not None:
            text = str(self._scene.frame)
            if text != self._frame.text():
                self._frame.setText(text)

    def _write_time(self, time_s: float) -> None:
        """The label has a fixed size: a text of its own size would lay the window out anew."""
        text = clock_text(time_s)
        if len(text) > len(self._time.text()):
            metrics = self._time.fontMetrics()
            self._time.setFixedSize(metrics.horizontalAdvance(text) + 8, metrics.height())
        self._time.setText(text)

    def _widen(self, scene: TransportScene) -> None:
        """Room for the largest numbers, so that nothing moves while playing."""
        digits = "0" * max(4, len(str(scene.frame_count)))
        metrics = self._frame.fontMetrics()
        self._frame.setFixedWidth(metrics.horizontalAdvance(digits) + 22)
        self._count.setText(tr("/ {0}").format(scene.frame_count))

    def _show_speed(self, speed: float, loops: bool) -> None:
        text = self._speed_text(speed)
        if loops:
            text = tr("{speed}, loop", speed=text)
        self._speed.setText(text)
        self._speed.setAccessibleName(tr("Speed: {0}").format(text))
        if speed in self._speed_actions:
            self._speed_actions[speed].setChecked(True)

    def _speed_text(self, speed: float) -> str:
        return tr("{0:g}\u00d7").format(speed)

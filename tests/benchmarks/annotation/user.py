"""An annotator before the real window, whose keys and mouse actions are counted."""

from __future__ import annotations

from collections import Counter
from collections.abc import Callable, Collection, Mapping

import numpy as np
from PySide6.QtCore import QPointF, Qt
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QWidget

from app.core.editing.suggested_boxes import SuggestedBox, suggest_boxes, suggestion_at
from app.shell.main_window import MainWindow
from app.shell.recording_controller import RecordingController
from tests.benchmarks.annotation.plans import KEYFRAME_MARGIN, TrueTrack, keys_between
from tracking.arrays import Floats
from tracking.tracks import TrackTable
from tracking.tracks.boxes import overlaps
from tracking.tracks.columns import boxes_of

Wait = Callable[[Callable[[], bool]], object]
Key, Modifier = Qt.Key, Qt.KeyboardModifier
_PLAIN, _SHIFT, _CTRL = Modifier.NoModifier, Modifier.ShiftModifier, Modifier.ControlModifier
_DRAWN = 0.9
"""So much a box overlaps the true one that was dragged there, to a pixel of the window."""
_LEFT = Qt.MouseButton.LeftButton


class Annotator:
    """Sees people where the ground truth has them, and draws them.

    A key (with its modifiers), a drag and a click are an action each.

    Attributes:
        actions: so far, by kind.
        tracks: of each person, once they are drawn.
    """

    def __init__(
        self,
        window: MainWindow,
        true_tracks: Mapping[int, TrueTrack],
        least: float,
        wait: Wait,
        *,
        by_keys: bool,
    ) -> None:
        """by_keys: frames are gone to by keys, not by a click on the timeline."""
        self._by_keys = by_keys
        self.window, self._true_tracks, self._least, self._wait = window, true_tracks, least, wait
        self.actions: Counter[str] = Counter()
        self.tracks: dict[int, int] = {}

    @property
    def controller(self) -> RecordingController:
        """Of the open recording."""
        controller = self.window.controller
        assert controller is not None, "a recording is open"
        return controller

    def label(self, drawn: Mapping[int, Collection[int]]) -> None:
        """Draw everybody, frame by frame; then mend what does not fit between.

        drawn: who is to be drawn in each frame.
        """
        self._press("modes", Key.Key_D, _SHIFT)
        for frame, people in drawn.items():
            self._go(frame)
            self._dismiss(frame)
            self._draw_all(frame, set(people))
        for person, frame in iter(self._worst, (0, 0)):
            self._go(frame)
            self._click_lane(self.tracks[person])
            self._drag(self._true_tracks[person].box(frame))
            assert self._stands(person, frame), f"{person} is drawn in frame {frame}"

    # what is seen

    def fit(self, person: int) -> Floats:
        """(n,) overlap of a person's boxes with those drawn; 0 where there is none."""
        true_track, table = self._true_tracks[person], self._table
        rows = table.of_track(self.tracks[person], true_track.first, true_track.last + 1)
        found = np.zeros((len(true_track.frames), 4))
        found[rows["frame"] - true_track.first] = boxes_of(rows)
        return overlaps(found, true_track.boxes)

    @property
    def extra(self) -> int:
        """Boxes of nobody."""
        wanted = sum(len(true_track.frames) for true_track in self._true_tracks.values())
        return len(self._table) - wanted

    @property
    def _table(self) -> TrackTable:
        session = self.controller.document.session
        assert session is not None, "somebody was drawn"
        return session.tracks

    def _worst(self) -> tuple[int, int]:
        """Whose box fits least, and where; (0, 0) where all fit."""
        least = {person: self.fit(person) for person in self.tracks}
        person = min(least, key=lambda one: least[one].min())
        if least[person].min() >= self._least:
            return 0, 0
        return person, self._true_tracks[person].first + int(least[person].argmin())

    # what is done

    def _draw_all(self, frame: int, people: set[int]) -> None:
        """The suggestions that fit as one, where there are two and no wrong ones; else drags."""
        good, wrong = self._suggested(frame, people)
        whole = len(good) > 1 and wrong <= people
        for person in sorted(people - good if whole else people):
            self._draw(person, frame)
        if whole:
            self._press("accepted", Key.Key_Return, _CTRL | _SHIFT)

    def _dismiss(self, frame: int) -> None:
        """Say who has left and is still expected: pointed at, and a key, as O is there.

        Not of who soon leaves the picture, nor where somebody else is expected in front.
        """
        owners = {track: person for person, track in self.tracks.items()}
        ghosts = self.controller.document.correcting.ghosts_waiting(frame)
        expected = [SuggestedBox(ghost.expected, ghost.track) for ghost in ghosts]
        for ghost in ghosts:
            left, top, width, height = ghost.expected
            middle = left + width / 2, top + height / 2
            hit = suggestion_at(expected, *middle)
            lingers = left > 0 and left + width < self.controller.document.recording.size[0]
            gone = self._true_tracks[owners[ghost.track]].last < frame
            if gone and lingers and hit is not None and hit.track == ghost.track:
                self._point(*middle)
                self._press("dismissed", Key.Key_Backspace, _SHIFT)

    def _point(self, x: float, y: float) -> None:
        """The mouse goes there; one that stands there already would not be told to."""
        view = self.window.workspace.left
        for near in (2.0, 0.0):
            QTest.mouseMove(view, view.viewport.point(x + near, y).toPoint())

    def _suggested(self, frame: int, people: set[int]) -> tuple[set[int], set[int]]:
        """Who has a suggestion that fits, and who has one that does not or should have none."""
        good, wrong = set[int](), set[int]()
        owners = {track: person for person, track in self.tracks.items()}
        for one in self.controller.annotating.suggested:
            person = owners.get(one.track, 0)
            if not person or (one.track and not self._true_tracks[person].covers(frame)):
                wrong.update([-one.track] if one.track else [])
                continue
            fits = self._overlap(np.array(one.box), person, frame)
            if fits < self._least + KEYFRAME_MARGIN:
                wrong.add(person)
            elif person in people:
                good.add(person)
        return good, wrong

    def _overlap(self, box: Floats, person: int, frame: int) -> float:
        return float(overlaps(box[None], self._true_tracks[person].box(frame)[None])[0])

    def _draw(self, person: int, frame: int) -> None:
        """Drag a box; one that would go to somebody else, as the picture shows, is said first."""
        known = self.tracks.get(person, 0)
        before = set(self._table.track_ids) if self.tracks else set()
        if self._foreseen(self._true_tracks[person].box(frame), frame) != known:
            if known:
                self._click_lane(known)
            else:
                self._press("named", Key.Key_Insert)
        self._drag(self._true_tracks[person].box(frame))
        if not known:
            self.tracks[person] = (set(self._table.track_ids) - before).pop()
        assert self._stands(person, frame), f"{person} is drawn in frame {frame}"

    def _foreseen(self, box: Floats, frame: int) -> int:
        """The track that a box would go to; 0: a new one."""
        correcting = self.controller.document.correcting
        ghosts = correcting.ghosts_waiting(frame)
        values = box.tolist()
        found = suggest_boxes([(values[0], values[1], values[2], values[3])], ghosts)[0].track
        selected = self.controller.document.selection.track
        return found or (0 if correcting.next_is_new(frame) else selected)

    def _stands(self, person: int, frame: int) -> bool:
        """Whether a person's track has about their box in a frame."""
        rows = self._table.of_track(self.tracks[person], frame, frame + 1)
        return len(rows["frame"]) > 0 and self._overlap(boxes_of(rows)[0], person, frame) > _DRAWN

    def _drag(self, box: Floats) -> None:
        self.actions["drags"] += 1
        view = self.window.workspace.left
        start = view.viewport.point(float(box[0]), float(box[1]))
        end = view.viewport.point(float(box[0] + box[2]), float(box[1] + box[3]))
        QTest.mousePress(view, _LEFT, _PLAIN, start.toPoint())
        for step in (0.5, 1.0):
            QTest.mouseMove(view, (start + (end - start) * step).toPoint())
        QTest.mouseRelease(view, _LEFT, _PLAIN, end.toPoint())
        self._settle()

    def _click_lane(self, track: int) -> None:
        """Click a track beside its bar on the timeline."""
        self.actions["named"] += 1
        area = self.window.workspace.timeline.area
        for y in range(0, area.height(), 4):
            lane = area.lane_at(QPointF(30, y))
            if lane is not None and lane.track == track:
                QTest.mouseClick(area, _LEFT, _PLAIN, QPointF(30, y + 2).toPoint())
                self._settle()
                return
        raise AssertionError(f"no lane of {track}")

    def _go(self, frame: int) -> None:
        """Go to a frame, in the way that was chosen."""
        clock = self.controller.playback.clock
        if self._by_keys:
            self._go_by_keys(frame)
        elif clock.frame != frame:
            self._click_ruler(frame)
        assert clock.frame == frame, f"at {clock.frame}, not at {frame}"
        self._wait(lambda: self.controller.playback.number == frame)
        self._settle()

    def _click_ruler(self, frame: int) -> None:
        self.actions["frames"] += 1
        area = self.window.workspace.timeline.area
        at = QPointF(area.axis.x_of(frame + 0.5), area.ruler_height / 2)
        QTest.mouseClick(area, _LEFT, _PLAIN, at.toPoint())

    def _go_by_keys(self, frame: int) -> None:
        clock = self.controller.playback.clock
        for _ in range(keys_between(clock.frame, frame)):
            left = frame - clock.frame
            far = min(abs(left - 10), abs(left + 10)) < abs(left) - 1
            by = Key.Key_Right if left > 0 else Key.Key_Left
            self._press("frames", by, _SHIFT if far else _PLAIN)

    def _press(self, kind: str, key: Qt.Key, modifiers: Qt.KeyboardModifier = _PLAIN) -> None:
        self.actions[kind] += 1
        focus: QWidget = self.window.focusWidget() or self.window
        QTest.keyClick(focus, key, modifiers)
        self._settle()

    def _settle(self) -> None:
        """Let the window come to rest."""
        self._wait(lambda: not self.controller.annotating.busy)
        QTest.qWait(1)

"""The picture and the floor as features draw on them: each gives its marks, the view paints all."""

from __future__ import annotations

from abc import abstractmethod
from dataclasses import dataclass

from PySide6.QtCore import Signal
from PySide6.QtWidgets import QWidget

from app.core.drawing.canvas import Canvas
from app.core.scenes.detections import NO_DETECTIONS, PicturedDetections
from app.core.scenes.flow_map import FlowScene
from app.core.scenes.ground_truth import FlooredTruth, PicturedTruth
from app.core.scenes.labels import FloorLabels, PictureLabels
from app.core.scenes.other_people import Divider, OtherMark, OtherPlace
from app.core.scenes.pictured_parts import PicturedParts
from app.core.scenes.suggested_marks import SuggestedMark


class PictureSurface(Canvas):
    """One camera's picture; holds the marks of every feature.

    Signals:
        track_picked(int): a person was clicked, the nearest where boxes lie over each other;
            0 for a click beside all people.
        track_added(int): the same with Shift.
        part_picked(int): a body part of the selected person was clicked.
        picture_clicked(float, float): where a click was, in pixels as recorded.
        divider_moved(float): the divider was dragged; the share of the picture left of it.
    """

    track_picked = Signal(int)
    track_added = Signal(int)
    part_picked = Signal(int)
    picture_clicked = Signal(float, float)
    divider_moved = Signal(float)

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(upward=False, parent=parent)
        self._labels = PictureLabels()
        self._parts = PicturedParts()
        self._others: tuple[OtherMark, ...] = ()
        self._truth = PicturedTruth()
        self._detections: PicturedDetections = NO_DETECTIONS
        self._divider: Divider | None = None
        self._suggested: tuple[SuggestedMark, ...] = ()

    def show_labels(self, labels: PictureLabels) -> None:
        """Draw what people drew and said at this instant."""
        self._labels = labels
        self.update()

    def show_parts(self, parts: PicturedParts) -> None:
        """Draw where a tracker saw the body parts."""
        self._parts = parts
        self.update()

    def show_others(self, others: tuple[OtherMark, ...]) -> None:
        """Draw another session's people, thin and dashed."""
        if others or self._others:
            self._others = others
            self.update()

    def show_divider(self, divider: Divider | None) -> None:
        """Show one's own people left of it alone, and the others right of it; None: both."""
        if divider != self._divider:
            self._divider = divider
            self.update()

    def show_detections(self, detections: PicturedDetections) -> None:
        """Draw the boxes of another program's detector, thin and dashed."""
        if detections != self._detections:
            self._detections = detections
            self.update()

    def show_suggested(self, suggested: tuple[SuggestedMark, ...]) -> None:
        """Draw boxes that can be accepted, dashed."""
        if suggested != self._suggested:
            self._suggested = suggested
            self.update()

    def show_truth(self, truth: PicturedTruth) -> None:
        """Draw the people of a ground truth, and where the result errs."""
        if truth != self._truth:
            self._truth = truth
            self.update()


class FloorSurface(Canvas):
    """The floor from above; holds the marks of every feature.

    Signals:
        track_picked(int): the nearest person to a click, 0 where nobody is near.
        track_added(int): the same with Shift.
        floor_clicked(float, float): where a click was, in metres.
    """

    track_picked = Signal(int)
    track_added = Signal(int)
    floor_clicked = Signal(float, float)

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(upward=True, parent=parent)
        self._labels = FloorLabels()
        self._others: tuple[OtherPlace, ...] = ()
        self._truth = FlooredTruth()
        self._flow: FlowScene | None = None

    @property
    @abstractmethod
    def shows_floor(self) -> bool:
        """Whether there is a floor to see, and room to see it."""

    def show_labels(self, labels: FloorLabels) -> None:
        """Draw counting lines and regions."""
        if labels is not self._labels:
            self._labels = labels
            self.update()

    def show_others(self, others: tuple[OtherPlace, ...]) -> None:
        """Draw another session's people, thin and dashed."""
        if others or self._others:
            self._others = others
            self.update()

    def show_flow(self, flow: FlowScene | None) -> None:
        """Draw where people are and which way they go, below everything else; None: nothing."""
        if flow is not self._flow:
            self._flow = flow
            self.update()

    def show_truth(self, truth: FlooredTruth) -> None:
        """Draw the people of a ground truth, and where the result errs."""
        if truth is not self._truth:
            before = self.content()
            self._truth = truth
            if self._fitted and self.content() != before:
                self.fit()
            self.update()


@dataclass(frozen=True, slots=True)
class Surfaces:
    """The views of one window that features draw on."""

    left: PictureSurface
    right: PictureSurface
    floor: FloorSurface

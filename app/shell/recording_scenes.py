"""The scenes of pictures, overhead view and timeline of one open document."""

from __future__ import annotations

from collections.abc import Iterable, Sequence

from app.core.document.document import Document
from app.core.document.document_listener import DocumentListener, Marks
from app.core.scenes import TimelineMark, TimelineScene
from app.core.scenes.part_curve import LaneScore
from app.core.tracks.track_reader import WholeTracks
from app.features.pictures.overhead_presenter import OverheadPresenter
from app.features.pictures.presenter import PicturePresenter
from app.features.timeline.presenter import TimelinePresenter
from tracking.editing import Change
from tracking.trackers import StepResult
from tracking.tracks import ReviewedRange


class RecordingScenes(DocumentListener):
    """Makes scenes of a document; follows its tracks.

    Attributes:
        pictures: of both cameras. overhead: of the floor from above.
    """

    def __init__(self, document: Document) -> None:
        recording = document.recording
        self.pictures = PicturePresenter(recording)
        self.overhead = OverheadPresenter(recording)
        self._timeline = TimelinePresenter(recording.frame_count, recording.fps)
        self._document = document
        document.tell(self)

    def timeline(
        self,
        playhead: int,
        frame: int,
        loaded: tuple[tuple[int, int], ...] = (),
        no_lanes: str = "",
        loop: tuple[int, int] | None = None,
    ) -> TimelineScene:
        """The timeline with its playhead; lanes are those of `frame`.

        `loaded` are the half-open ranges of frames at hand; `no_lanes` is said without lanes. A
        `loop` is marked where no range is set.
        """
        flow, marked = self._document.flow, self._document.correcting.range_shown or loop
        cut = flow.cut if flow is not None and flow.has_cut else None
        state = self._document.corrected_state(frame)
        return self._timeline.scene(playhead, state, loaded, cut, no_lanes, marked)

    def take_score(self, score: LaneScore | None) -> None:
        """Show on the timeline how a part of the selected person went; None: nothing."""
        self._timeline.take_score(score)

    # following the document

    def take_tracks(
        self, tracks: WholeTracks, marks: Marks, reviewed: tuple[ReviewedRange, ...]
    ) -> None:
        """Other tracks are shown."""
        self._timeline.take(tracks, marks)
        self.overhead.take(tracks.capture(("frame", "x", "y"))())
        self._timeline.take_reviewed(reviewed)

    def take_live(self, tracks: WholeTracks, results: Iterable[StepResult]) -> None:
        """The tracker at work is further."""
        for result in results:
            self.overhead.take_more(result.tracks)
        self._timeline.take(tracks, {})

    def take_change(
        self,
        change: Change,
        tracks: WholeTracks,
        marks: Marks,
        reviewed: tuple[ReviewedRange, ...],
    ) -> None:
        """Some tracks were edited: only their lanes are made anew."""
        self.overhead.take_more(change.after.rows)
        frames = change.before.rows["frame"], change.after.rows["frame"]
        self._timeline.take_changed(change.tracks, tracks, frames, marks)
        self._timeline.take_reviewed(reviewed)

    def take_review_items(self, review_items: Sequence[TimelineMark]) -> None:
        """Mark on the timeline what may be wrong."""
        self._timeline.take_review_items(review_items)

    def colour_anew(self) -> None:
        """Tracks have other colours by now."""
        self._timeline.colour_anew()

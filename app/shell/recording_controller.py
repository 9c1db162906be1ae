"""One open recording on the workspace: draws what is due and passes gestures on."""

from __future__ import annotations

from PySide6.QtCore import QObject, Qt, Signal
from PySide6.QtGui import QImage

from app.core.commands.conditions import ControllerT
from app.core.controller import Controller
from app.core.document.document import Document
from app.core.feature import FeatureContext, FloorMarker, Marker, ShownFrame
from app.core.playback.playback import Playback
from app.core.playback.thumbnails import Thumbnails
from app.core.projection.extent import Bounds
from app.core.scenes import Side, TransportScene
from app.core.tracks.frame_state import ViewOptions
from app.features.comparison.controller import ComparisonController
from app.features.correction.annotation_controller import AnnotationController
from app.features.correction.attribute_controller import AttributeController
from app.features.correction.controller import EditController
from app.features.correction.drag_controller import DragController
from app.features.counting.controller import CountController
from app.features.labelling.controller import LabelController
from app.features.parts.controller import PartsController
from app.features.pictures.controller import OverlayController
from app.features.review.controller import ReviewController
from app.features.scoring.controller import ScoreController
from app.shell.close_up import CloseUp
from app.shell.colour_worker import ColourWorker
from app.shell.features import FEATURES
from app.shell.recording_scenes import RecordingScenes
from app.shell.tracker_at_work import TrackerAtWork
from app.shell.workspace import Workspace
from tracking.errors import TrackwrightError


class RecordingController(Controller):
    """Holds the document, the playback and the tracker at work of one open recording.

    Signals: `drawn()`, another frame is shown; `changed()`, commands may be enabled or disabled
    by now; `progressed()`, the tracker at work is further.
    """

    drawn = Signal()
    progressed = Signal()

    def __init__(self, document: Document, workspace: Workspace, parent: QObject) -> None:
        super().__init__(parent)
        self.document = document
        self.scenes = RecordingScenes(document)
        self.playback = Playback(document.recording, self)
        self.thumbnails = Thumbnails(document.recording, self)
        self.colouring = ColourWorker(document, self)
        self.editing = EditController(document, self.playback, self)
        self.dragging = DragController(document, self.playback, self.editing)
        self.overlaying = OverlayController(document, self.playback, self)
        surfaces = workspace.surfaces
        self.annotating = AnnotationController(
            document, self.playback, surfaces.left, self.editing, self
        )
        self.describing = AttributeController(document, workspace, self.editing, self)
        self.labelling = LabelController(
            document, self.playback, workspace.labelling, surfaces, self
        )
        context = FeatureContext(
            self, document, self.playback, surfaces, self.labelling, self._floor_bounds
        )
        self._features = tuple(
            feature.controller(context, workspace.panels.get(feature.id)) for feature in FEATURES
        )
        self.comparing = ComparisonController(document, self.playback, workspace.differences, self)
        self.tracking = TrackerAtWork(document, self.playback, self.comparing, self)
        self.live = self.tracking.live
        self.reviewing = ReviewController(document, self.playback, workspace.review, self)
        self.close_up = CloseUp(
            document.recording,
            self.playback,
            (workspace.left, workspace.right, workspace.overhead),
            lambda: self.view_options.close_up,
            self,
        )
        self.view_options = ViewOptions()
        self.cameras = "left"
        self._told_unread = ""
        self._selected = self._to_show = 0
        self._workspace = workspace
        self._connect_parts()
        self._connect_views(workspace)

    def _connect_parts(self) -> None:
        self.playback.shown.connect(self.draw_frame)
        self.playback.moved.connect(self.draw_playhead)
        self.playback.failed.connect(self.failed)
        self.editing.changed.connect(self.labelling.follow_edits)
        self.editing.changed.connect(self.draw)
        self.editing.previewed.connect(self.draw_preview)
        for part in (self.reviewing, self.comparing):
            part.changed.connect(self.changed)
            part.edited.connect(self.editing.changed)
            part.concerned.connect(self.close_up.look_at)
        self.reviewing.changed.connect(self.draw_playhead)  # whose marks stand on the timeline
        self.of(ScoreController).concerned.connect(self.close_up.look_at)
        self.close_up.changed.connect(self.changed)
        self.reviewing.fix_asked.connect(self.editing.begin)
        self.overlaying.changed.connect(self.draw_frame)
        for one in (self.annotating, self.describing, self.labelling, *self._features):
            one.changed.connect(self.draw)
        for feature in self._features:
            feature.marked.connect(self.draw_frame)
        self.tracking.changed.connect(self.draw)
        self.colouring.changed.connect(self._draw_coloured)
        self.tracking.following.changed.connect(self.changed)
        self.tracking.found.connect(self._draw_found)
        self.tracking.live.learning.connect(self._draw_progress)
        self.tracking.people_found.connect(self.changed)

    def _connect_views(self, view: Workspace) -> None:
        """What gestures do; each connection ends with this object."""
        for picker in (view.left, view.right, view.overhead, view.timeline):
            picker.track_picked.connect(self.editing.pick)
            picker.track_added.connect(self.editing.add)
        view.timeline.frame_sought.connect(self.playback.go)
        view.timeline.overview.hovered.connect(self._ask_thumbnail)
        self.thumbnails.ready.connect(self._show_thumbnail, Qt.ConnectionType.QueuedConnection)
        view.timeline.cut_moved.connect(self.editing.put_cut)
        view.transport.play_toggled.connect(self.toggle)
        view.transport.frame_sought.connect(self.playback.go)
        view.transport.stepped.connect(self.playback.step)
        view.transport.follow_toggled.connect(self.tracking.following.toggle)
        view.transport.speed_chosen.connect(self.playback.set_speed)
        view.timeline.errors.frame_sought.connect(self.playback.go)
        scoring = self.of(ScoreController)
        view.timeline.errors.event_sought.connect(scoring.go_to)
        view.timeline.area.stretch.changed.connect(scoring.show_range)
        scoring.error_lanes.connect(view.timeline.errors.show_scene)
        self.comparing.scene_changed.connect(view.show_differences)
        view.card.name_edited.connect(self.editing.rename)
        view.card.notes_edited.connect(self.editing.write_notes)
        view.card.attributes_edited.connect(self.describing.set_own)
        view.card.field_given.connect(self.describing.give)
        view.card.schema_asked.connect(self.describing.ask_schema)
        view.card.frame_sought.connect(self.playback.go)
        view.preview.confirmed.connect(self.editing.confirm)
        view.preview.cancelled.connect(self.editing.leave)
        view.preview.cut_moved.connect(self.editing.move_cut)
        view.preview.end_moved.connect(self.editing.move_end)
        view.preview.choice_made.connect(self.editing.choose)
        view.preview.other_typed.connect(self.editing.pick_typed)
        view.preview.other_considered.connect(self.editing.consider)
        view.preview.cut_proposed.connect(self.editing.put_proposed_cut)
        view.left.box_grabbed.connect(self.dragging.grab_box)
        view.left.box_dragged.connect(self.dragging.drag_box)
        view.left.box_dropped.connect(self.dragging.drop)
        view.overhead.person_grabbed.connect(self.dragging.grab_person)
        view.overhead.person_dragged.connect(self.dragging.drag_person)
        view.overhead.person_dropped.connect(self.dragging.drop)

    def _ask_thumbnail(self, frame: int) -> None:
        image = self.thumbnails.get(frame) if frame >= 0 else None
        if image is not None:
            self._workspace.timeline.overview.show_thumbnail(image)

    def _show_thumbnail(self, _: int, image: QImage) -> None:
        self._workspace.timeline.overview.show_thumbnail(image)

    @property
    def work_text(self) -> str:
        """What the digit keys set, how edits are done, how fast the work goes; "" for none."""
        session, at_once = self.document.session, self.annotating.at_once_text
        history = None if session is None else session.history
        said = self.describing.armed_text, at_once, self.annotating.meter.text(history)
        return "  \u00b7  ".join(filter(None, said))

    def end(self) -> None:
        """End all threads, and leave nothing on the views; the document stays open."""
        self.thumbnails.close()
        self._workspace.timeline.overview.hide_thumbnail()
        self.live.close()
        self.colouring.close()
        self.reviewing.close()
        self.comparing.end()
        self.overlaying.close()
        self.labelling.close()
        self.annotating.close()
        self.describing.close()
        for feature in self._features:
            feature.close()
        self.playback.close()

    def close(self) -> None:
        """Let the recording go, and its session, once all threads have ended."""
        try:
            if self.document.session is not None:
                self.document.session.close()
        except TrackwrightError as error:  # its folder has vanished
            self.failed.emit(error)
        self.document.recording.close()

    @property
    def window_page(self) -> Workspace:
        """What dialogs stand before."""
        return self._workspace

    def of(self, kind: type[ControllerT]) -> ControllerT:
        """The controller of this kind. Raises LookupError where there is none."""
        for one in self.children():
            if isinstance(one, kind):
                return one
        raise LookupError(f"no controller is a {kind.__name__}")

    def leave(self) -> None:
        """Esc: leave the labelling, else the edit that waits, else let the person go.

        With the person the views closed up on them are left, too.
        """
        if self.labelling.tool is not None:
            self.labelling.leave()
            return
        if self.document.flow is None:
            self.close_up.end()
        self.editing.leave()

    # playing

    def toggle(self) -> None:
        """Play or pause; the first play puts the best tracker to work."""
        if not self.playback.clock.playing:
            self.tracking.begin_first()
        self.playback.toggle()

    def shuttle(self, direction: int) -> None:
        """J (-1), K (0), L (1); playing on puts the best tracker to work like the first play."""
        if direction > 0:
            self.tracking.begin_first()
        self.playback.shuttle(direction)

    # drawing

    def set_cameras(self, mode: str) -> None:
        """Show "left", "both" or "anaglyph"."""
        self.cameras = mode if self.document.recording.is_stereo else "left"
        width, height = self.document.recording.size
        self._workspace.know_floor(self.document.recording.view is not None)
        self._workspace.show_cameras(
            self.cameras, width / height, self.document.recording.is_stereo
        )
        self.draw_frame()
        self.changed.emit()

    def set_view_options(self, view_options: ViewOptions) -> None:
        """Lay other things over the pictures."""
        self.view_options = view_options
        if not view_options.close_up:
            self.close_up.end()
        self.draw_frame()
        self.draw_playhead()
        self.changed.emit()

    def draw(self) -> None:
        """Draw everything."""
        view, document = self._workspace, self.document
        self.colouring.look()
        self.reviewing.refresh()  # first: it may select who a review item is about
        self.draw_frame()
        self.draw_playhead()
        view.card.show_scene(self.describing.card())
        for feature in self._features:
            feature.draw()
        view.preview.show_scene(document.planned.scene if document.planned else None)
        self.comparing.refresh()
        self.changed.emit()

    def _draw_coloured(self) -> None:
        """Tracks have other colours by now."""
        self.reviewing.queue.colour_anew()
        self.labelling.colour_anew()
        self.draw()

    def draw_preview(self) -> None:
        """Draw only what an edit that waits would do: often, while something is dragged."""
        planned = self.document.planned
        self.draw_frame()
        self._workspace.preview.show_scene(planned.scene if planned is not None else None)

    def draw_frame(self) -> None:
        """Draw the pictures and the floor: the same frame in all of them."""
        view, document, frame = self._workspace, self.document, self.playback.frame
        state = document.frame_state(self.playback.number)
        pictures, laid = self.scenes.pictures, self.overlaying.laid(self.view_options.kinds)
        if self.cameras == "anaglyph":
            view.left.show_scene(pictures.anaglyph(frame, state, self.view_options, laid))
        else:
            view.left.show_scene(pictures.scene(Side.LEFT, frame, state, self.view_options, laid))
        if self.cameras == "both":
            view.right.show_scene(pictures.scene(Side.RIGHT, frame, state, self.view_options))
        view.overhead.show_legend(self.view_options.floor_legend)
        view.overhead.show_scene(self.scenes.overhead.scene(state))
        late = None if frame is None else frame.right_lag
        right = None if late is None else state.frame + late
        counted = self.of(CountController).texts_at(state, self.view_options)
        self.labelling.draw(self.cameras == "both", self.view_options.labels, counted)
        for feature in self._features:
            feature.draw_frame(ShownFrame(state, self.view_options, self.cameras, right))
        self.annotating.draw_frame(state, self.view_options)
        self._tell_unread()
        self._show_selected()
        self.drawn.emit()

    def markers(self) -> tuple[Marker, ...]:
        """What draws over pictures of any frame as it is drawn over the one that is shown."""
        options, found = self.view_options, [self.labelling.marker(self.view_options)]
        found += [feature.marker(options) for feature in self._features]
        return tuple(one for one in found if one is not None)

    def floor_markers(self) -> tuple[FloorMarker, ...]:
        """The same over the floor."""
        options, found = self.view_options, [self.labelling.floor_marker(self.view_options)]
        found += [feature.floor_marker(options) for feature in self._features]
        return tuple(one for one in found if one is not None)

    def _floor_bounds(self) -> Bounds:
        return self.scenes.overhead.bounds

    def _show_selected(self) -> None:
        """Have who was selected a moment ago seen in zoomed views, once their frame is there."""
        track, before = self.document.selection.track, self._selected
        if track != before:
            self._selected = self._to_show = track
        if self._to_show and self.playback.number == self.playback.clock.frame:
            for view in (self._workspace.left, self._workspace.right, self._workspace.overhead):
                view.show_person(self._to_show)
            self._to_show = 0

    def _tell_unread(self) -> None:
        """Say once why particles are missing where the session's file cannot be read."""
        unread = self.document.unread
        if unread is not None and str(unread) != self._told_unread:
            self._told_unread = str(unread)
            self.failed.emit(unread)

    def draw_playhead(self) -> None:
        """Draw the timeline and the transport line."""
        clock, document, tracker = self.playback.clock, self.document, self.tracking.state
        frame, loaded = self.playback.number, self.playback.loaded
        parts = self.of(PartsController).presenter
        self.scenes.take_score(parts.score() if self.view_options.parts else None)
        self._workspace.timeline.show_scene(
            self.scenes.timeline(clock.frame, frame, loaded, tracker.no_lanes, clock.loop)
        )
        self._workspace.transport.show_scene(
            TransportScene(
                playing=clock.playing,
                speed=abs(clock.pace) if clock.playing else clock.speed,
                loops=clock.loop is not None,
                frame=clock.frame,
                frame_count=clock.frame_count,
                time_s=document.recording.time_s(clock.frame),
                tracker=tracker.name,
                status=tracker.status,
                live=self.live.running and document.is_live and self.live.done > 0,
                following=self.tracking.following.on if self.live.running else None,
            )
        )

    def _draw_found(self, first: int, last: int) -> None:
        """Draw what the tracker at work found in some frames, both included."""
        if self.document.is_live and first <= self.playback.number <= last:
            self.draw_frame()
        self._draw_progress()

    def _draw_progress(self) -> None:
        """Draw how far the tracker at work is."""
        self.draw_playhead()
        self.progressed.emit()

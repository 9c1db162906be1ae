"""What gestures of the views do in the open recording."""

from __future__ import annotations

from typing import TYPE_CHECKING

from app.features.scoring.controller import ScoreController
from app.shell.workspace import Workspace

if TYPE_CHECKING:
    from app.shell.recording_controller import RecordingController


def connect_gestures(controller: RecordingController, view: Workspace) -> None:
    """Connect the views to the controller's parts; each connection ends with it."""
    for picker in (view.left, view.right, view.overhead, view.timeline):
        picker.track_picked.connect(controller.editing.pick)
        picker.track_added.connect(controller.editing.add)
    view.timeline.frame_sought.connect(controller.playback.go)
    view.timeline.cut_moved.connect(controller.editing.put_cut)
    view.transport.play_toggled.connect(controller.toggle)
    view.transport.frame_sought.connect(controller.playback.go)
    view.transport.stepped.connect(controller.playback.step)
    view.transport.follow_toggled.connect(controller.tracking.following.toggle)
    view.transport.speed_chosen.connect(controller.playback.set_speed)
    view.timeline.errors.frame_sought.connect(controller.playback.go)
    scoring = controller.of(ScoreController)
    view.timeline.errors.event_sought.connect(scoring.go_to)
    view.timeline.area.stretch.changed.connect(scoring.show_range)
    scoring.error_lanes.connect(view.timeline.errors.show_scene)
    controller.comparing.scene_changed.connect(view.show_differences)
    view.card.name_edited.connect(controller.editing.rename)
    view.card.notes_edited.connect(controller.editing.write_notes)
    view.card.attributes_edited.connect(controller.editing.set_attributes)
    view.card.frame_sought.connect(controller.playback.go)
    view.preview.confirmed.connect(controller.editing.confirm)
    view.preview.cancelled.connect(controller.editing.leave)
    view.preview.cut_moved.connect(controller.editing.move_cut)
    view.preview.end_moved.connect(controller.editing.move_end)
    view.preview.choice_made.connect(controller.editing.choose)
    view.preview.other_typed.connect(controller.editing.pick_typed)
    view.preview.other_considered.connect(controller.editing.consider)
    view.preview.cut_proposed.connect(controller.editing.put_proposed_cut)
    view.left.box_grabbed.connect(controller.dragging.grab_box)
    view.left.box_dragged.connect(controller.dragging.drag_box)
    view.left.box_dropped.connect(controller.dragging.drop)
    view.overhead.person_grabbed.connect(controller.dragging.grab_person)
    view.overhead.person_dragged.connect(controller.dragging.drag_person)
    view.overhead.person_dropped.connect(controller.dragging.drop)

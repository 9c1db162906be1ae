"""What gestures of the views do at the desk."""

from __future__ import annotations

from typing import TYPE_CHECKING

from app.views.desk.workspace import Workspace

if TYPE_CHECKING:
    from app.views.desk.recording_controller import RecordingController


def connect_gestures(desk: RecordingController, view: Workspace) -> None:
    """Connect the views to the desk's parts; each connection ends with the desk."""
    for picker in (view.left, view.right, view.overhead, view.timeline):
        picker.track_picked.connect(desk.editing.pick)
        picker.track_added.connect(desk.editing.add)
    view.timeline.frame_sought.connect(desk.playback.go)
    view.timeline.cut_moved.connect(desk.editing.put_cut)
    view.transport.play_toggled.connect(desk.toggle)
    view.transport.frame_sought.connect(desk.playback.go)
    view.transport.stepped.connect(desk.playback.step)
    view.transport.follow_toggled.connect(desk.tracking.following.toggle)
    view.transport.speed_chosen.connect(desk.playback.set_speed)
    view.card.name_edited.connect(desk.editing.rename)
    view.card.notes_edited.connect(desk.editing.write_notes)
    view.card.attributes_edited.connect(desk.editing.set_attributes)
    view.card.frame_sought.connect(desk.playback.go)
    view.history.undo_asked.connect(desk.editing.undo)
    view.history.redo_asked.connect(desk.editing.redo)
    view.preview.confirmed.connect(desk.editing.confirm)
    view.preview.cancelled.connect(desk.editing.leave)
    view.preview.cut_moved.connect(desk.editing.move_cut)
    view.preview.end_moved.connect(desk.editing.move_end)
    view.preview.choice_made.connect(desk.editing.choose)
    view.preview.other_typed.connect(desk.editing.pick_typed)
    view.preview.other_considered.connect(desk.editing.consider)
    view.preview.cut_proposed.connect(desk.editing.put_proposed_cut)
    view.left.box_grabbed.connect(desk.dragging.grab_box)
    view.left.box_dragged.connect(desk.dragging.drag_box)
    view.left.box_dropped.connect(desk.dragging.drop)
    view.overhead.person_grabbed.connect(desk.dragging.grab_person)
    view.overhead.person_dragged.connect(desk.dragging.drag_person)
    view.overhead.person_dropped.connect(desk.dragging.drop)

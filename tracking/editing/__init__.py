"""Edits: pure planners, one reversible Change, one function that applies it, the log."""

from tracking.editing.boxes.floor_boxes import body_position, standing_box
from tracking.editing.boxes.floor_move import plan_drag
from tracking.editing.boxes.gaps import Gap, gaps_of, plan_fill_gap, plan_fill_gaps
from tracking.editing.boxes.interpolation import How
from tracking.editing.boxes.keyframe_reduction import plan_thin
from tracking.editing.boxes.keyframes import (
    keyframes_of,
    plan_add_keyframe,
    plan_delete_keyframe,
    plan_interpolate,
)
from tracking.editing.boxes.put_boxes import (
    is_by_hand,
    plan_propagate,
    plan_put_box,
    plan_put_boxes,
)
from tracking.editing.boxes.rows import (
    plan_delete,
    plan_delete_tracks,
    plan_draw_box,
    plan_mark_occluded,
    plan_move_box,
    plan_new_track,
)
from tracking.editing.core.change import Change, LabelState, State, apply_change
from tracking.editing.core.scope import Scope
from tracking.editing.identity.crossover import SwapFrame, propose_swap_frames
from tracking.editing.identity.identities import plan_reassign, plan_split, plan_swap
from tracking.editing.identity.merge import Keep, plan_merge_tracks
from tracking.editing.labels.part_labels import (
    plan_label_part,
    plan_unlabel_part,
    with_parts_carried,
)
from tracking.editing.labels.review_labels import (
    plan_mark_reviewed,
    plan_unmark_reviewed,
    plan_verdict,
    plan_verdicts,
    with_verdict,
)
from tracking.editing.labels.schema_edits import SchemaChange, plan_schema
from tracking.editing.labels.shapes import plan_lines, plan_occluders, plan_regions
from tracking.editing.labels.track_labels import plan_rename, plan_set_attribute, plan_set_notes
from tracking.editing.log.edit_footprint import footprint_of
from tracking.editing.log.former_logs import up_to_date
from tracking.editing.log.history import Entry, History, StoredChange, plan_undo_alone
from tracking.editing.log.text import rows_beyond_the_log, state_as_text, state_from_text
from tracking.editing.log.touch_index import TOUCHED_COLUMNS, TouchIndex
from tracking.editing.taken_ranges import plan_take_range
from tracking.editing.track_import import ThinningResult, on_the_floor, plan_import, thin_dense
from tracking.editing.tracking_again.differences import (
    Difference,
    compare_runs,
    compare_to_table,
    differences,
)
from tracking.editing.tracking_again.protection import Protection, find_protected
from tracking.editing.tracking_again.run_adoption import plan_take

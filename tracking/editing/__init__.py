"""Edits: pure planners, one reversible Change, one function that applies it, the log."""

from tracking.editing.change import Change, LabelState, State, apply_change
from tracking.editing.crossing import propose_swap_frame
from tracking.editing.drawing import plan_lines, plan_occluders, plan_regions
from tracking.editing.history import Entry, History
from tracking.editing.identities import Keep, plan_merge, plan_reassign, plan_split, plan_swap
from tracking.editing.labelling import plan_rename, plan_set_attribute, plan_set_notes
from tracking.editing.part_labelling import plan_label_part, plan_unlabel_part, with_parts_carried
from tracking.editing.reviewing import (
    plan_forget_verdict,
    plan_mark_reviewed,
    plan_unmark_reviewed,
    plan_verdict,
    with_verdict,
)
from tracking.editing.rows import plan_delete, plan_draw_box, plan_move_box
from tracking.editing.text import state_as_text, state_from_text

__all__ = [
    "Change",
    "Entry",
    "History",
    "Keep",
    "LabelState",
    "State",
    "apply_change",
    "plan_delete",
    "plan_draw_box",
    "plan_forget_verdict",
    "plan_label_part",
    "plan_lines",
    "plan_mark_reviewed",
    "plan_merge",
    "plan_move_box",
    "plan_occluders",
    "plan_reassign",
    "plan_regions",
    "plan_rename",
    "plan_set_attribute",
    "plan_set_notes",
    "plan_split",
    "plan_swap",
    "plan_unlabel_part",
    "plan_unmark_reviewed",
    "plan_verdict",
    "propose_swap_frame",
    "state_as_text",
    "state_from_text",
    "with_parts_carried",
    "with_verdict",
]

"""What is wrong with a recording's pairing, calibration and floor, and what that costs."""

from tracking.doctor.examination import examine
from tracking.doctor.findings import Examination, Finding, Mend
from tracking.doctor.mended_files import Mended, mend, mend_undoably, undo_mend

__all__ = [
    "Examination",
    "Finding",
    "Mend",
    "Mended",
    "examine",
    "mend",
    "mend_undoably",
    "undo_mend",
]

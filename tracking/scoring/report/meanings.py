"""What each measure means, in a sentence; by group, under the names that scores have them by."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Literal


@dataclass(frozen=True, slots=True)
class Meaning:
    """A measure's meaning.

    Attributes:
        says: a sentence. better: which of two is better; None where it is no merit.
        form: how it is written.
    """

    says: str
    better: Literal["higher", "lower"] | None = "higher"
    form: Literal["share", "count", "metres"] = "share"


def _count(says: str, better: Literal["higher", "lower"] | None = "lower") -> Meaning:
    return Meaning(says, better, "count")


def _metres(says: str) -> Meaning:
    return Meaning(says, "lower", "metres")


MEANINGS: Mapping[str, Mapping[str, Meaning]] = {
    "Finding people and keeping their ids (HOTA)": {
        "HOTA": Meaning("Geometric mean of DetA and AssA, taken over all strictness of matching."),
        "DetA": Meaning("How well people are found: matches / all rows of either side."),
        "AssA": Meaning("How well ids are kept: how far a match's person and track are the same."),
        "LocA": Meaning("How exactly matched rows lie on each other."),
        "DetRe": Meaning("Share of the ground truth's rows that are matched."),
        "DetPr": Meaning("Share of the result's rows that are matched."),
        "AssRe": Meaning("How much of its person the track of a match covers."),
        "AssPr": Meaning("How much of its track the person of a match covers."),
        "OWTA": Meaning("HOTA without counting false alarms."),
        "HOTA(0)": Meaning("HOTA where matching is least strict."),
        "LocA(0)": Meaning("LocA there."),
        "HOTALocA(0)": Meaning("The product of the two."),
    },
    "Row by row (CLEAR)": {
        "MOTA": Meaning(
            "1 − (misses + false alarms + switches) / rows of the ground truth; may be < 0."
        ),
        "MOTP": Meaning("Mean similarity of matched rows."),
        "MODA": Meaning("MOTA without switches."),
        "MOTAL": Meaning("MOTA with the logarithm of the switches."),
        "sMOTA": Meaning("MOTA in which a match counts as much as it is similar."),
        "recall": Meaning("Matches / rows of the ground truth."),
        "precision": Meaning("Matches / rows of the result."),
        "F1": Meaning("Harmonic mean of recall and precision."),
        "matches": _count("Rows of the ground truth with a partner in the result.", "higher"),
        "misses": _count("Rows of the ground truth without one."),
        "false_positives": _count("Rows of the result without a partner in the ground truth."),
        "false_positives_per_frame": Meaning("False alarms / frames.", "lower"),
        "id_switches": _count("A person is matched to another track than the last time."),
        "fragmentations": _count("A person is matched again after frames without a match."),
        "mostly_tracked": _count("People matched in more than 80 % of their frames.", "higher"),
        "partly_tracked": _count("People matched in 20 % to 80 %.", None),
        "mostly_lost": _count("People matched in fewer than 20 %."),
    },
    "Who is who (identity)": {
        "IDF1": Meaning("Rows that are right when each person is named after one track only."),
        "IDP": Meaning("The same as a share of the result's rows."),
        "IDR": Meaning("The same as a share of the ground truth's rows."),
        "IDTP": _count("Rows that are right under that naming.", "higher"),
        "IDFN": _count("Rows of the ground truth that are not."),
        "IDFP": _count("Rows of the result that are not."),
    },
    "Whole tracks (Track-mAP)": {
        "AP of tracks": Meaning("Mean precision of whole tracks, the surest first."),
        "AR of tracks": Meaning("Share of the people whom a whole track stands for."),
    },
    "People kept, and where they stand (the papers' measures)": {
        "people_detected": _count("People matched in at least 10 frames.", "higher"),
        "people_kept": _count(
            "Of those, people whose matches all bear one and the same id, which is matched to "
            "nobody else before or between, and who are matched in at least half of their frames "
            "from the first match on.",
            "higher",
        ),
        "tracking_accuracy": Meaning("People kept / people detected."),
        "position error, mean (m)": _metres("Mean distance on the floor between matched rows."),
        "position error, std (m)": _metres("Its standard deviation."),
        "position error, median (m)": _metres("Half of the matched rows are no farther off."),
        "position error, p95 (m)": _metres("95 % of the matched rows are no farther off."),
    },
    "What was measured": {
        "frames": _count("Length of what was measured.", None),
        "truth_people": _count("People in the ground truth.", None),
        "truth_rows": _count("Rows that count in the ground truth.", None),
        "result_tracks": _count("Tracks in the result.", None),
        "result_rows": _count("Rows that count in the result.", None),
    },
}

MOTMETRICS: Mapping[str, Meaning] = {
    "MOTP": Meaning("Mean distance (1 − similarity) of matched rows.", "lower"),
    "matches": _count("Rows of the ground truth with a partner, switches not counted.", "higher"),
}
"""What means something else as py-motmetrics has it."""

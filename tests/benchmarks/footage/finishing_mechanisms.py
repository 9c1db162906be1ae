"""The mechanisms of finishing runs that several trackers share."""

from __future__ import annotations

from tests.benchmarks.footage.mechanism import finishing

_L = "trackers.linking"
_SMOOTHER = "trackers.shared.run_smoother"

SMOOTHING = (
    finishing(
        "smooth paths", "paths led by what came later", (f"{_SMOOTHER}._walked", "paths_as_tracked")
    ),
    finishing(
        "outlines", "boxes follow a body's outline", (f"{_SMOOTHER}._drawn", "boxes_as_tracked")
    ),
    finishing(
        "clear sides",
        "sides of boxes that nobody else is near follow limbs",
        (f"{_SMOOTHER}.clear_sides", "no_clear_sides"),
    ),
    finishing(
        "vanished rows",
        "rows after the last detection are left out within the picture",
        (f"{_SMOOTHER}._vanished", "nobody_vanished"),
    ),
)

LINKING = (
    finishing(
        "linking",
        "tracks are cut where in doubt and linked again",
        (f"{_L}.linker._find_ids", "no_ids"),
    ),
    finishing(
        "encounters",
        "tracks are cut where people meet",
        (f"{_L}.doubts._encounter_rows", "no_list"),
    ),
    finishing(
        "alternation",
        "tracks are cut where one of two is seen after the other",
        (f"{_L}.doubts._alternation_rows", "no_rows"),
    ),
    finishing(
        "edge returns",
        "tracks are cut where they leave and enter over the edge",
        (f"{_L}.edges.find_edge_returns", "no_list"),
    ),
    finishing(
        "extended ends",
        "tracks are extended over detections of nobody",
        (f"{_L}.extend_ends.extend_ends", "first"),
    ),
    finishing(
        "short tracklets",
        "tracklets of few rows are put in last",
        (f"{_L}.short.insert_short", "first"),
    ),
    finishing(
        "occlusion",
        "gaps behind others are likelier",
        (f"{_L}.occlusion.hidden_shares", "no_shares"),
    ),
    finishing("appearance", "clothes and height weigh links", (f"{_L}.appearance._TRUSTED", 0.0)),
    finishing(
        "half hidden",
        "clothes of people half hidden tell a little",
        (f"{_L}.appearance._HALF_OCCLUDED", 0.0),
    ),
    finishing(
        "rounds",
        "links are chosen again by the looks of linked people",
        (f"{_L}.link_selection._ROUNDS", 1),
    ),
    finishing("filled gaps", "short gaps get rows", (f"{_L}.gap_rows._SURE_S", 0.0)),
    finishing(
        "fewest rows", "people of few rows are nobody", (f"{_L}.link_selection._LEAST_S", 0.0)
    ),
    finishing(
        "return costs",
        "who walks out of the picture rarely comes back",
        (f"{_L}.borders.return_costs", "zeros"),
    ),
    finishing(
        "way out",
        "how far somebody is from the edge on the floor, not only in the picture",
        (f"{_L}.borders._way_out", "zeros"),
    ),
    finishing(
        "turning",
        "people may turn, stop or start unseen",
        (f"{_L}.motion.walk_likelihood", "straight_likelihood"),
    ),
    finishing(
        "tracker's links", "what the tracker linked is likelier", (f"{_L}.candidates._TRACKER", 0.0)
    ),
    finishing("new ids", "a new id is rather a new person", (f"{_L}.candidates._KEPT_APART", 0.0)),
    finishing(
        "seen both",
        "who began while the other was seen is another",
        (f"{_L}.candidates._SEEN_BOTH", 0.0),
    ),
    finishing(
        "led starts",
        "few rows before a gap tell that somebody was there",
        (f"{_L}.candidates._first_frames", "own_first_frames"),
    ),
    finishing(
        "doubtful places",
        "places at the edge and close to others err more",
        (f"{_L}.tracklets._DOUBTFUL", 1.0),
    ),
    *SMOOTHING,
)

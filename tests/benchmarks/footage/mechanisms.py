"""The mechanisms of trackers that can be left out."""

from __future__ import annotations

from collections.abc import Mapping

from tests.benchmarks.footage.finishing_mechanisms import LINKING, SMOOTHING
from tests.benchmarks.footage.mechanism import Mechanism, finishing, left_out, seeing, set_to

_S = "trackers.spheroid"
_SPHEROID = (
    left_out(
        "ghosts",
        "deletes tracks whose outline has edges in the background only",
        (f"{_S}.ghosts.are_ghosts", "no_ghosts"),
    ),
    left_out(
        "split merged",
        "finds the second of two people followed as one",
        (f"{_S}.split_merged.split_merged", "no_split"),
    ),
    set_to("colours", "colours weigh hypotheses", colour_weight=0.0),
    left_out(
        "heights", "body heights are estimated", (f"{_S}.filter_steps.learn_heights", "first")
    ),
    left_out(
        "feet",
        "where legs end says how far away people are",
        (f"{_S}.weights._FEET", 0.0),
        (f"{_S}.births._FEET", 0.0),
    ),
    left_out("lean", "bodies of who walks are ahead of the feet", (f"{_S}.weights._LEAN_S", 0.0)),
    left_out(
        "learnt shadows",
        "shadows are weighed down as learnt beside people",
        (f"{_S}.perception.ShadowWeights", "NoShadows"),
    ),
    left_out(
        "protected background",
        "the background is not learnt where people are",
        (f"{_S}.perception_hints.body_masks", "unprotected_masks"),
    ),
    set_to("re-identification", "lost tracks coast and are found again", coast_s=0.0),
    left_out(
        "plain sight",
        "who is in plain sight and empty is let go soon",
        (f"{_S}.support._EMPTY_S", 1.5),
    ),
    left_out(
        "left the picture",
        "who has left the picture is let go at once",
        (f"{_S}.support._LEFT", -1.0),
    ),
    left_out(
        "steep colours",
        "colours weigh little of who is seen steeply",
        (f"{_S}.tracker._STEEP_COLOURS", 1.0),
    ),
    left_out(
        "balances",
        "other balances for people cut off or seen steeply",
        (f"{_S}.weights._balances", "one_balance"),
    ),
    left_out(
        "hidden near side",
        "a balance of its own where the near side is hidden, too",
        (f"{_S}.weights._HIDDEN_CUT_BALANCE", 0.27),
    ),
    left_out("alone", "colours are learnt of who is alone", (f"{_S}.tracker._ALONE_M", 0.0)),
    left_out(
        "modest silhouettes",
        "tall estimates explain no more than usual bodies do",
        (f"{_S}.births.TALLER_M", 9.0),
    ),
    left_out(
        "measured boxes",
        "boxes are drawn from the foreground",
        (f"{_S}.boxes._WHOLE", 9.0),
    ),
    *LINKING,
)

_F = "trackers.flow"
_FLOW = (
    set_to("fitted silhouettes", "people are drawn to the foreground", fit_silhouettes=False),
    left_out(
        "sighted",
        "people are looked for in foreground of nobody",
        (f"{_F}.people._SIGHTED", (9.0, 9.0, 9.0)),
    ),
    left_out(
        "far search", "poor silhouettes are sought farther off", (f"{_F}.silhouettes._POOR", -9.0)
    ),
    left_out(
        "re-identification",
        "who was lost near by is taken on",
        (f"{_F}.people._find_lost_near", "nothing"),
    ),
    set_to("twins merged", "of two tracks at one place one goes", merge_distance_m=0.0),
    left_out(
        "misfits",
        "tracklets that move otherwise are set free",
        (f"{_F}.tracklet_owners.release_misfits", "first"),
    ),
    left_out(
        "adapted offsets",
        "places of tracklets in bodies are followed",
        (f"{_F}.tracklet_owners.adapt_offsets", "second"),
    ),
    left_out(
        "bodies before",
        "it takes more to belong to who is behind",
        (f"{_F}.unclaimed_tracklets._HIDDEN", 0.0),
    ),
    set_to("empty in view", "who is empty in plain view is deleted soon", delete_in_view_s=60.0),
    set_to("kernel occlusion", "kernels shrink where legs are hidden", clusters__occlusion=False),
    set_to("walked", "who has not walked is not reported", confirm_distance_m=0.0),
    finishing(
        "relabelling",
        "trajectories explain tracklets over all their time",
        (f"{_F}.relabel_run.relabel_run", "first"),
    ),
    finishing(
        "joined pieces",
        "pieces that lead to each other are one track",
        (f"{_F}.pieces.join_pieces", "first"),
    ),
    finishing("filled gaps", "rows within tracks", (f"{_F}.predicted_rows.fill_gaps", "first")),
    finishing(
        "extrapolation",
        "trajectories are led back and on",
        (f"{_F}.predicted_rows._extend", "tracks_of"),
    ),
    finishing(
        "witnesses",
        "where tracklets leave no room nobody is led on",
        (f"{_F}.witnesses.Witnesses", "NoWitnesses"),
    ),
    finishing(
        "feet misfit",
        "feet tell which tracklets are a body's",
        (f"{_F}.foot_fit.feet_misfit", "zeros_like"),
    ),
    finishing(
        "feet scale",
        "feet tell how far away a body is",
        (f"{_F}.foot_fit.estimate_scale", "no_list"),
    ),
    finishing(
        "feet of seeds",
        "feet tell how far away a seed is",
        (f"{_F}.foot_fit.feet_cost", "no_feet_cost"),
    ),
    finishing(
        "pace hint",
        "the usual pace tells how far away a body is",
        (f"{_F}.trajectory_fit._pace_says", "no_list"),
    ),
    finishing(
        "holders' hint",
        "who held tracklets tells how far away",
        (f"{_F}.trajectory_fit._holders_say", "no_list"),
    ),
    finishing(
        "heads' hint",
        "heads tell how far away a body is",
        (f"{_F}.trajectory_fit._top_says", "no_list"),
    ),
    finishing(
        "trends",
        "tracklets that rise or drift are another's",
        (f"{_F}.bundles._trends", "no_trends"),
    ),
    finishing(
        "oddity",
        "few points of bodies are high or off the axis",
        (f"{_F}.bundles._oddity", "zeros"),
    ),
    finishing(
        "twins removed",
        "of trajectories too near one goes",
        (f"{_F}.trajectory_selection.remove_twins", "by_first"),
    ),
    finishing(
        "pieces off",
        "pieces off all trajectories stay",
        (f"{_F}.relabel_run._find_pieces_off_trajectories", "no_list"),
    ),
    *SMOOTHING,
)

_T = "trackers.three_part"
_THREE = (
    set_to("fitted silhouettes", "parts are drawn to silhouettes", fit_silhouettes=False),
    left_out(
        "drawn home",
        "parts move towards their places in the silhouette",
        (f"{_T}.silhouettes.drawn_home", "first"),
    ),
    left_out(
        "legs elsewhere",
        "hip-legs off their silhouette are lost",
        (f"{_T}.silhouettes.legs_elsewhere", "no_legs"),
    ),
    set_to(
        "pose constraints",
        "failures by pose and foreground, occluded parts carried",
        pose_constraints=False,
    ),
    left_out(
        "clear failures",
        "parts are lost whatever the detector says",
        (f"{_T}.adjustment.clear_failures", "no_failures"),
    ),
    left_out(
        "carried parts",
        "occluded parts move with the others",
        (f"{_T}.part_filter.carry_along", "first"),
    ),
    set_to(
        "re-identification",
        "lost people are found again by colours, and tracks split",
        reidentify=False,
    ),
    left_out(
        "split",
        "who was begun with somebody else is begun anew",
        (f"{_T}.claims.both_in_one", "no_rows"),
    ),
    left_out(
        "sharing",
        "who shares a region may be found elsewhere",
        (f"{_T}.claims.is_sharing", "not_sharing"),
    ),
    left_out(
        "pieces", "pieces of bent people are nobody", (f"{_T}.births.without_pieces", "first")
    ),
    left_out("who is nearer", "who stands lower is in front", (f"{_T}.occlusion._NEARER", 0.0)),
    left_out("stays behind", "who is behind stays so", (f"{_T}.occlusion._STAYS", 0.0)),
    left_out("outlines", "boxes learnt from regions", (f"{_T}.bodies.outlines_after", "first")),
    left_out(
        "own region boxes",
        "boxes of who is alone are their regions'",
        ("trackers.shared.shown_boxes.steady_boxes", "first"),
    ),
    left_out(
        "limbs absorbed",
        "fragments beside bodies are limbs",
        ("people.regions_of_people._absorbed", "false"),
    ),
    left_out(
        "beheaded",
        "heads above the edge are measured from the feet",
        ("people.regions_of_people._beheaded", "first"),
    ),
    left_out(
        "nearer ones",
        "feet without a head are somebody's",
        ("people.regions_of_people._nearer", "nothing"),
    ),
)

_J = "trackers.joint"
_ST = "trackers.stereo"
_JOINT = (
    set_to("looks", "clothes and heights weigh associations", appearance_weight=0.0),
    set_to("direction", "sharp turns cost", direction_weight=0.0),
    set_to("margin", "detections that suit two alike are nobody's", association_margin=0.0),
    left_out(
        "learnt noise",
        "errors of places are learnt",
        (f"{_J}.noise.MeasurementNoise", "FixedNoise"),
    ),
    left_out(
        "learnt looks",
        "how much looks tell is learnt",
        (f"{_J}.appearance.AppearanceModel", "FixedLooks"),
    ),
    left_out(
        "re-identification",
        "coasting tracks are found again",
        (f"{_J}.reidentification.reidentify", "first"),
    ),
    left_out(
        "negative evidence",
        "particles move to where people would not be seen",
        (f"{_ST}.update.update_missed", "first"),
    ),
    left_out(
        "shared regions",
        "a region as wide as two is both",
        (f"{_ST}.shared_detections.find_shared_regions", "nobody_shares"),
    ),
    set_to("edge births", "new people come at the edge", birth_rate_edge=0.05),
    left_out(
        "visibility",
        "who is hidden is missed cheaply",
        (f"{_J}.association_likelihoods._SHOWN", 0.06),
    ),
    left_out(
        "doubt", "tentative tracks may be nobody", (f"{_J}.association_likelihoods._DOUBT", 1.0)
    ),
    left_out(
        "shares seen",
        "no track coasts much longer than seen",
        (f"{_J}.track_management._COASTED_SHARE", 999.0),
        (f"{_J}.track_management._REPORTED_SHARE", 998.0),
    ),
    left_out(
        "at the edge",
        "who was last seen at the edge is deleted soon",
        (f"{_J}.track_management._AT_THE_EDGE", -1.0),
    ),
    left_out(
        "trust", "looks count little of who is hardly known", (f"{_J}.appearance._KNOWN", 0.0)
    ),
    seeing(
        "heads split", "regions are split by heads", ("people.heads_above.split_by_heads", "first")
    ),
    seeing("seams", "seams between people are nobody's", ("people.seams.without_seams", "first")),
    seeing(
        "behind things",
        "boxes behind things are completed",
        ("people.boxes.behind_things", "nothing_behind"),
    ),
    *LINKING,
)

MECHANISMS: Mapping[str, tuple[Mechanism, ...]] = {
    "spheroid": _SPHEROID,
    "flow": _FLOW,
    "three-part": _THREE,
    "stereo-joint": _JOINT,
}

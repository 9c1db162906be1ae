"""The entries of `three-part`, `three-part-joint` and `whole-body`."""

from __future__ import annotations

from tracking.trackers.linking import (
    Finisher,
    Published,
    extend_ends_in_pixels,
)
from tracking.trackers.three_part import (
    ThreePartSettings,
    WholeBodySettings,
    build_three_part,
    build_three_part_joint,
    build_whole_body,
    detector_fingerprint,
    link_refined,
)
from tracking.trackers.tracker_spec import TrackerSpec

_THREE_PART = Finisher(
    relabel=link_refined,
    extend_in_pixels=extend_ends_in_pixels,
    published=Published((("adjust", False), ("reidentify", False)), smoothed=False),
)

THREE_PART = TrackerSpec(
    name="three-part",
    title="One camera: one particle filter each for head, torso and hip-leg, with adjustment",
    paper="ZhaoLee2009",
    needs_stereo=False,
    needs_calibration=False,
    settings_type=ThreePartSettings,
    build=build_three_part,
    detector=detector_fingerprint,
    finisher=_THREE_PART,
    body_parts=True,
)

THREE_PART_JOINT = TrackerSpec(
    name="three-part-joint",
    title="One camera: one particle filter for head, torso and hip-leg together",
    paper="ZhaoLee2009",
    needs_stereo=False,
    needs_calibration=False,
    settings_type=ThreePartSettings,
    build=build_three_part_joint,
    detector=detector_fingerprint,
    finisher=_THREE_PART,
    body_parts=True,
)

WHOLE_BODY = TrackerSpec(
    name="whole-body",
    title="One camera: particle filter for the whole body, for comparison",
    paper="ZhaoLee2009",
    needs_stereo=False,
    needs_calibration=False,
    settings_type=WholeBodySettings,
    build=build_whole_body,
)

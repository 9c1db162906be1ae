"""Colour-based particle filters over the parts of people, with failures found and adjusted."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from tracking.arrays import Floats
from tracking.failure import Detector
from tracking.foreground import CameraWatch
from tracking.geometry import View
from tracking.people import Detections, Observation
from tracking.trackers.shared.known_embeddings import KnownEmbeddings
from tracking.trackers.shared.occluders import Polygons, occluder_mask
from tracking.trackers.shared.protocol import StepResult
from tracking.trackers.shared.resumption import Resume
from tracking.trackers.shared.shown_boxes import steady_boxes
from tracking.trackers.shared.stages import Stages
from tracking.trackers.shared.tracker_base import TrackerBase
from tracking.trackers.three_part import births
from tracking.trackers.three_part.adjustment import (
    AdjustmentInput,
    adjust,
    clear_failures,
    is_new_in_picture,
)
from tracking.trackers.three_part.appearance import measure_levels, resemblance
from tracking.trackers.three_part.appearance_update import (
    learn_colours,
    learn_places,
    learn_poses,
)
from tracking.trackers.three_part.bodies import (
    outlined_boxes,
    outlines_after,
)
from tracking.trackers.three_part.claims import (
    both_in_one,
    is_sharing,
    own_boxes,
    seen_taller,
    seen_whole,
    shares_on,
)
from tracking.trackers.three_part.detectors import NO_DETECTOR
from tracking.trackers.three_part.evidence import measure_evidence
from tracking.trackers.three_part.failure_watch import Watch
from tracking.trackers.three_part.frame import Frame
from tracking.trackers.three_part.initiation import (
    begin_anew,
    begin_people,
    complete_bodies,
    is_all_seen,
    is_cut_off,
    regions_rectangles,
    reset_people,
)
from tracking.trackers.three_part.occlusion import (
    behind_others,
    behind_what_is_drawn,
)
from tracking.trackers.three_part.part_filter import carry_along, move_parts, weigh_parts
from tracking.trackers.three_part.people import (
    Flags,
    Indices,
    Layout,
    PartPeople,
    concatenate,
    no_people,
)
from tracking.trackers.three_part.reidentification import reidentify
from tracking.trackers.three_part.result import Shown, in_sight, step_result
from tracking.trackers.three_part.resumption import resume_people
from tracking.trackers.three_part.settings import WholeBodySettings
from tracking.trackers.three_part.silhouettes import drawn_home, legs_elsewhere
from tracking.tracks import HIP_LEG
from tracking.tracks.boxes import share_inside
from tracking.translation import Message

Picture = NDArray[np.uint8]

_STOOPED, _STRETCHED = 0.6, 1.1
"""Lowest and highest somebody's box is, in heights of them upright."""
_MISSED_S = 0.2
"""Who has had no foreground for so long is looked for."""


@dataclass(frozen=True, slots=True)
class Camera:
    """What the tracker knows of the recording.

    Attributes:
        size: width and height px. fps: frames a second.
        view: the camera over its floor; None where that is not known.
        occluders: outlines of what hides people.
    """

    size: tuple[int, int]
    fps: float
    view: View | None
    occluders: Polygons = ()


class PartTracker(TrackerBase[WholeBodySettings]):
    """Follows people by rectangles: three parts, each with a filter of its own, or whole.

    A step of [ZhaoLee2009], for all people at once: predict, see who is occluded, weigh by
    equalised colours, judge which parts were lost and put them back, learn colours. Particles are
    weighed by the picture itself, so that there is no gate; regions of the foreground are
    associated with people to tell who is alone in one.

    Where we differ from the source and why:
        - people are found, and let go, by regions of the foreground, which the paper leaves open;
        - with adjustment, parts of people seen alone and whole are drawn to where the silhouette
          has them, in every frame;
        - where the floor is known, and of a detector's boxes, each region is one body: it is given
          to one person at most, by place and colours;
        - with the constraints of poses, parts out of the picture are where a body has them until
          they come in;
        - somebody lost behind others is looked for by colours around the place expected;
        - with adjustment, parts that are occluded move with those of the person that are not;
        - the box is the person's, learnt from regions seen alone: inner rectangles are smaller.
    """

    def __init__(
        self,
        camera: Camera,
        settings: WholeBodySettings,
        layout: Layout,
        seed: int,
        detector: Detector | None = None,
    ) -> None:
        """Nobody is followed yet; all randomness comes from the seed."""
        super().__init__(settings)
        self._camera = camera
        self._layout = layout
        self._random = np.random.default_rng(seed)
        self._aids = settings.aids
        self._watch = Watch(detector)
        self._fixed = CameraWatch(camera.fps)
        self._cover = occluder_mask(camera.occluders, camera.size[::-1])
        self._people = no_people(layout)
        self._tentative = births.TentativeRegions()
        self._known = KnownEmbeddings()
        self._stages = Stages("filters", "failures", "births", "boxes")

    @property
    def stage_s(self) -> Mapping[str, float]:
        """Seconds spent so far in the stages of steps; colours and columns are the rest."""
        return self._stages.spent_s

    @property
    def notes(self) -> tuple[Message, ...]:
        """Notes for the user, a line each."""
        missing = self._aids.adjust and self._watch.detector is None
        return (*((NO_DETECTOR,) if missing else ()), *self._fixed.notes("three-part"))

    def resume(self, resume: Resume, observations: Iterable[Observation]) -> None:
        """Go on with the people as corrected; those who are new get ids above all there were."""
        self._people, time_s = resume_people(resume, observations, self._layout, self._random)
        self._clock.set(time_s)
        self._ids.last = resume.highest_track

    def step(self, observation: Observation) -> StepResult:
        """Take one frame further: predict, associate, update, terminate, initiate.

        The update goes on with parts that were lost, colours, and at the end boxes. Who was lost is
        re-identified before anybody is deleted or begun.
        """
        bodies = self._aids.reidentify and self._camera.view is not None
        frame = Frame(observation, self._clock.elapsed_s(observation.time_s), bodies=bodies)
        timed = self._stages.timed
        self._fixed.look(observation.frame, frame.picture[..., 0])
        expected = timed("filters", self._predict, frame)
        expected = timed("filters", self._associate, expected, frame)
        people = timed("filters", self._update, expected, frame)
        people = timed("failures", self._adjust, people, frame)
        people = self._learn_colours(people, frame)
        people, free = timed("births", self._reidentify, people, frame)
        people = timed("births", self._terminate, people)
        people = timed("births", self._initiate, people, free, frame)
        people, shown = timed("boxes", self._learn_boxes, people, frame)
        self._watch.remember(frame.time_s, people)
        self._people = people
        layout, settings = self._layout, self._settings
        if frame.bodies:
            people, shown = in_sight(people, shown, people.missed_s <= _MISSED_S, layout)
        return step_result(
            observation, people, shown, layout, self._camera.fps, settings.stored_particles
        )

    def _predict(self, frame: Frame) -> PartPeople:
        """Everybody one frame on."""
        return move_parts(self._people, frame.elapsed_s, self._settings, self._layout, self._random)

    def _associate(self, people: PartPeople, frame: Frame) -> PartPeople:
        """The people with who touches whom and who is hidden, at the places predicted.

        Regions are associated by `Frame.claims`; who is seen whole in one is hidden by nobody.
        """
        look = measure_levels(frame.picture, people.rectangles)
        alike = resemblance(look, people.model) - people.usual
        claims = frame.claims(people)
        box = outlined_boxes(people.rectangles, people.outline)
        tall = np.clip(box[:, 3], _STOOPED * people.height, _STRETCHED * people.height)
        foot = box[:, 1] + tall
        hidden, touching = behind_others(
            people.rectangles, alike, foot, people.height, people.hidden
        )
        hidden &= ~seen_whole(claims, frame.seen, people.height)[:, None]
        if self._camera.occluders:
            cover = shares_on(self._cover, people.rectangles)
            hidden |= behind_what_is_drawn(cover, claims.support)
        cut = is_cut_off(people.rectangles, frame.seen.regions.shape) & self._aids.pose_constraints
        return people.replace(occluded=hidden | cut, cut=cut, touching=touching)

    def _update(self, people: PartPeople, frame: Frame) -> PartPeople:
        """The people weighed by their colours where nothing hides them."""
        settings, layout = self._settings, self._layout
        people = weigh_parts(
            people, self._people, frame.picture, frame.elapsed_s, settings, layout, self._random
        )
        if not self._aids.pose_constraints:
            return people
        return people.replace(state=carry_along(people.state, people.pose, people.occluded))

    def _adjust(self, people: PartPeople, frame: Frame) -> PartPeople:
        """Failures judged and, where that is wanted, adjusted."""
        if self._layout.parts == 1:
            return people
        aids, seen, picture = self._aids, frame.seen, frame.picture
        if aids.fit_silhouettes:
            claims = frame.claims(people)
            people = drawn_home(people, seen, claims, picture, frame.elapsed_s, self._layout)
        evidence = measure_evidence(people, seen, frame.claims(people), picture)
        people = people.replace(evidence=evidence)
        clear = np.asarray(~people.occluded.any(axis=1))
        said = self._watch.judge(frame.time_s, people, clear)
        people = people.replace(failed=said.failed, score=said.score)
        if not aids.adjust:
            return people
        scene = AdjustmentInput(seen, frame.claims(people), picture)
        failed = said.failed.copy()
        if aids.pose_constraints:
            failed |= clear_failures(people, scene) | is_new_in_picture(people)
        if aids.fit_silhouettes:
            off, legs = legs_elsewhere(people, seen, scene.claims, picture)
            failed[off, HIP_LEG] = True
        if not failed.any():
            return people
        several = said.several | (failed.sum(axis=1) > 1)
        boxes = outlined_boxes(people.rectangles, people.outline)
        places = adjust(people, boxes, failed, several, scene, by_body=aids.pose_constraints)
        if aids.fit_silhouettes:
            places[off, HIP_LEG] = legs[off]
        people = people.replace(failed=failed)
        people = begin_anew(people, places, picture, self._layout, self._random)
        evidence = measure_evidence(people, seen, frame.claims(people), picture)
        return people.replace(evidence=evidence)

    def _restart(self, people: PartPeople) -> Flags:
        """(people, parts) that failed; none where nothing acts on it, as in the paper without."""
        return people.failed & self._aids.adjust

    def _learn_colours(self, people: PartPeople, frame: Frame) -> PartPeople:
        """The people with their colours after this frame, and for how long they were not seen."""
        claims, elapsed_s = frame.claims(people), frame.elapsed_s
        wrong = self._restart(people)
        people = learn_colours(people, frame.picture, claims, wrong, self._settings)
        there = births.is_supported(claims, people.cut)
        return people.replace(
            missed_s=np.where(there, 0.0, people.missed_s + elapsed_s),
            hidden_s=np.where(people.hidden, people.hidden_s + elapsed_s, 0.0),
            age_s=people.age_s + elapsed_s,
        )

    def _terminate(self, people: PartPeople) -> PartPeople:
        """The people without those missed for too long, or out of the picture."""
        boxes = outlined_boxes(people.rectangles, people.outline)
        kept = births.should_keep(people, boxes, self._camera.size, self._settings)
        return people if kept.all() else people.select(np.flatnonzero(kept), self._layout.filters)

    def _initiate(self, people: PartPeople, free: Indices, frame: Frame) -> PartPeople:
        """The people with those begun whose regions nobody has had for long enough."""
        seen, picture = frame.seen, frame.picture
        self._tentative = births.update_tentative(self._tentative, seen, free, frame.elapsed_s)
        ready = births.confirm_regions(self._tentative, seen, free, self._settings)
        rectangles = self._rectangles(seen, free[ready], picture)
        ready, rectangles = ready[is_all_seen(rectangles)], rectangles[is_all_seen(rectangles)]
        if not len(ready):
            return people
        people = self._split(people, frame, free[ready])
        track, pace = self._ids.take(len(ready)), self._tentative.pace[ready]
        new = begin_people(track, rectangles, pace, picture, self._layout, self._random)
        return concatenate(people, new)

    def _rectangles(self, seen: Detections, rows: Indices, picture: Picture) -> Floats:
        """(n, parts, 4) where the parts of people in some regions are; NaN where none is seen."""
        found = regions_rectangles(seen, rows, picture, self._layout)
        return complete_bodies(found, seen, rows) if self._aids.pose_constraints else found

    def _reidentify(self, people: PartPeople, frame: Frame) -> tuple[PartPeople, Indices]:
        """The people, those lost who came up again begun there; the regions still free."""
        seen, claims = frame.seen, frame.claims(people)
        boxes = outlined_boxes(people.rectangles, people.outline)
        free = births.free_regions(seen, claims, own_boxes(boxes, claims, seen))
        free = births.without_pieces(free, seen, boxes, people.height)
        if not self._aids.reidentify:
            return people, free
        lost = people.missed_s > _MISSED_S
        two = is_sharing(claims, seen) & ~lost
        embedded = self._compare_embeddings(people, frame)
        places, free = reidentify(
            people, boxes, lost, two, seen, free, frame.picture, self._layout, embedded
        )
        people = begin_anew(people, places, frame.picture, self._layout, self._random)
        again = is_all_seen(places)
        return people.replace(missed_s=np.where(again, 0.0, people.missed_s)), free

    def _compare_embeddings(self, people: PartPeople, frame: Frame) -> Floats | None:
        """(people, regions) what an appearance network says, once those seen whole are learnt."""
        if frame.embeddings is None:
            return None
        claims = frame.claims(people)
        whole = np.flatnonzero(seen_whole(claims, frame.seen, people.height) & ~people.hidden)
        mine = frame.embeddings[claims.region[whole]]
        self._known.learn(people.track[whole], mine, np.ones(len(whole), bool))
        return self._known.log_likelihood_ratio(people.track, frame.embeddings)

    def _split(self, people: PartPeople, frame: Frame, new: Indices) -> PartPeople:
        """The people, those begun as one with somebody now seen beside them begun anew alone."""
        claims = frame.claims(people)
        rows = both_in_one(claims, new)
        if not self._aids.reidentify or not len(rows):
            return people
        own = regions_rectangles(frame.seen, claims.region[rows], frame.picture, self._layout)
        rows, own = rows[is_all_seen(own)], own[is_all_seen(own)]
        places = np.full(people.rectangles.shape, np.nan)
        places[rows] = own
        people = begin_anew(people, places, frame.picture, self._layout, self._random)
        return reset_people(people, rows)

    def _learn_boxes(self, people: PartPeople, frame: Frame) -> tuple[PartPeople, Shown]:
        """The people with outlines and places brought up to date, and what is shown of them."""
        seen, elapsed_s, claims = frame.seen, frame.elapsed_s, frame.claims(people)
        own = np.append(seen.box, np.zeros((1, 4)), axis=0)[claims.region]
        cut = np.append(seen.truncated & ~seen.from_detector, True)[claims.region]
        alone = claims.alone & ~people.hidden
        whole = seen_whole(claims, seen, people.height) & ~people.hidden
        taller = seen_taller(claims, seen, people.height) & ~people.hidden
        unsure = people.hidden | self._restart(people).any(axis=1)
        people = learn_poses(people, own, claims, whole, taller, unsure, elapsed_s)
        outline = outlines_after(
            people.outline, people.rectangles, own, alone & ~cut, elapsed_s, people.age_s
        )
        if self._layout.parts == 1:
            # The comparison of [ZhaoLee2009]: what one rectangle alone says.
            outline, alone = np.zeros_like(outline), np.zeros_like(alone)
        box = outlined_boxes(people.rectangles, outline)
        people = people.replace(outline=outline)
        shown = steady_boxes(box, own, alone)
        people = learn_places(people, shown, seen, claims, elapsed_s, self._camera.view)
        unseen = claims.support.max(axis=1, initial=0.0) == 0.0
        inside = share_inside(shown, self._camera.size)
        return people, Shown(shown, inside, claims.region, claims.alone, unseen)

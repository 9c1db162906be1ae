"""One filter a person over the floor, judged by the silhouettes of spheroids."""

from __future__ import annotations

from collections.abc import Iterable

import numpy as np
from numpy.typing import NDArray

from tracking.people import Observation
from tracking.people.appearance_source import Embed
from tracking.people.box_bodies import in_boxes
from tracking.people.boxes import standing_boxes
from tracking.trackers.shared.gating import nearest_others_m
from tracking.trackers.shared.known_embeddings import KnownEmbeddings
from tracking.trackers.shared.protocol import StepResult
from tracking.trackers.shared.resumption import Resume
from tracking.trackers.shared.tracker_base import TrackerBase
from tracking.trackers.spheroid import births
from tracking.trackers.spheroid.appearance import ColourLook, appearance_log_weights, learn_colours
from tracking.trackers.spheroid.boxes import BODY_WIDTH_M, draw_boxes
from tracking.trackers.spheroid.feet import foot_zones
from tracking.trackers.spheroid.filter_steps import learn_heights, predict, resample_people
from tracking.trackers.spheroid.floor_cells import FloorCells
from tracking.trackers.spheroid.ghosts import are_ghosts
from tracking.trackers.spheroid.hypotheses import (
    SpheroidPeople,
    begin_people,
    concatenate,
    no_people,
)
from tracking.trackers.spheroid.hypothesis_scores import JudgedFrame, count_covering
from tracking.trackers.spheroid.perception import FlatObservation, SpheroidPerception
from tracking.trackers.spheroid.perception_hints import body_masks
from tracking.trackers.spheroid.reidentification import CoastingPeople, reidentify
from tracking.trackers.spheroid.result import clothes_of, step_result
from tracking.trackers.spheroid.resumption import resume_people
from tracking.trackers.spheroid.settings import SpheroidSettings
from tracking.trackers.spheroid.support import measure_support, seen_whole, should_keep
from tracking.trackers.spheroid.view_model import seen_steeply
from tracking.trackers.spheroid.weights import (
    axes_of,
    hypotheses_of,
    judge_and_weigh,
    silhouettes,
)
from tracking.translation import Message

Flags = NDArray[np.bool_]

_START_SPREADS = (0.2, 0.5)
"""m and m/s, of a new person's hypotheses."""
_HEIGHT_SD_M = 0.12
"""Of people, children among them."""
_ALONE_M = 0.9
"""Colours are learnt while nobody is closer than this."""
_STEEP_COLOURS = 0.15
"""Weight of colours of who is seen steeply: those learnt a little off would hold him there."""
_GHOST_EVERY_S, _GHOST_QUIET_S = 1.0, 1.5
"""How often those who stand are looked at, and how long they must have stood."""
_GHOST_SCALE = 1.3
_EMBEDDINGS_EVERY_S = 0.5
"""How often people are described by an appearance network, if there is one."""


class SpheroidTracker(TrackerBase[SpheroidSettings]):
    """Follows people by hypotheses of where they stand ([Waechter2013]).

    A step, for all people at once: predict, judge the hypotheses' silhouettes on the ramp picture
    with the other people's masked out, estimate, search for new people at intervals, delete
    tracks, resample. There are no detections: nothing is gated or associated, as hypotheses are
    weighed by all pixels that they and nobody else explain.

    Where we differ from the source and why (`paper` in the settings leaves all of it out):
        - weights are likelihood ratios of what lies in a silhouette (see `weights`): plain scores
          hardly tell near hypotheses apart;
        - other people are masked out where they are expected now, not where they were;
        - body heights are estimated: a fixed one errs by a share of the distance; some hypotheses
          move along their lines of sight as their heights change (see `filter_steps`);
        - feet say how far away people are who are seen from the side (see `feet`), and the lower
          half of a silhouette is taken for legs, which leave a gap (see `weights`);
        - spheroids of people who walk are ahead of where they stand, as bodies lean;
        - colours of the body, looked up at a few places, weigh hypotheses too, so that people who
          meet keep their identities; little of those who are seen steeply;
        - shadows are weighed down by what was learnt of them beside people (`foreground`);
        - tracks are initiated at places on the floor whose silhouettes explain most of the blobs,
          taken one by one, so that a group that comes in together is taken apart; their hypotheses
          begin at all places that the blobs hardly tell from that;
        - who has left the picture or is not where he would be seen is let go before hypotheses
          spread, and who is re-identified near by, in the same colours, keeps the track;
        - boxes are drawn from the foreground round the silhouettes, not from spheroids;
        - finished runs are linked: behind pillars and other people somebody is lost and gets a new
          id, and who meets somebody may be taken for them.
    """

    def __init__(
        self,
        perception: SpheroidPerception,
        settings: SpheroidSettings,
        counted: Flags,
        seed: int,
    ) -> None:
        """Nobody is followed yet; all randomness comes from the seed.

        Args:
            perception: gets where people are, for its background.
            counted: (height, width) flat pixels that were recorded and are not behind what is
                drawn.
        """
        super().__init__(settings)
        self._perception = perception
        self._flat = perception.flat
        self._counted = counted
        self._random = np.random.default_rng(seed)
        usual_m = self._usual_m = settings.tentative_height_m
        self._cells = FloorCells(self._flat, usual_m, settings.radius_m)
        self._people = no_people(settings.particles)
        self._coasting = CoastingPeople(self._people, np.zeros(0))
        self._candidates = births.SpheroidCandidates.none()
        self._next_look_s = self._next_ghosts_s = self._next_embeddings_s = -np.inf
        self._known = KnownEmbeddings()

    @property
    def notes(self) -> tuple[Message, ...]:
        """Notes for the user, a line each."""
        return self._perception.camera.notes("spheroid")

    def resume(self, resume: Resume, observations: Iterable[Observation]) -> None:
        """Go on with the people as corrected; those who are new get ids above all there were."""
        settings, random = self._settings, self._random
        self._people, time_s = resume_people(
            resume, observations, self._flat, settings, self._usual_m, random
        )
        self._clock.set(time_s)
        self._ids.last = resume.highest_track

    def step(self, observation: Observation) -> StepResult:
        """Take one frame further: predict, update, terminate, initiate.

        Who is lost is let go before new people are looked for, who may be them again.
        """
        assert isinstance(observation, FlatObservation), "spheroids step on flat observations"
        elapsed_s = self._clock.elapsed_s(observation.time_s)
        look = ColourLook(self._flat, observation.working.picture)
        camera = np.asarray(self._flat.camera_position)
        people = predict(self._people, elapsed_s, self._settings, self._random, camera)
        people = self._update(people, observation, look, elapsed_s)
        people = self._terminate(people, observation)
        people = self._initiate(people, observation, look)
        people, box = self._draw(self._learn(people, look, elapsed_s), observation, elapsed_s)
        self._learn_embeddings(people, box, observation)
        self._perception.tell(body_masks(people, self._flat, self._settings))
        self._people = resample_people(people, self._random)
        return step_result(observation.frame, people, box, clothes_of(people))

    def _draw(
        self, people: SpheroidPeople, seen: FlatObservation, elapsed_s: float
    ) -> tuple[SpheroidPeople, NDArray[np.float64]]:
        """The people with their outlines learnt, and their boxes (people, 4) px as recorded."""
        outlines = silhouettes(people, self._flat, self._settings)
        judged = self._judged_frame(people, seen)
        shown = draw_boxes(people, outlines, judged, self._flat, elapsed_s)
        return people.replace(outline=shown.outline), shown.box

    def _judged_frame(self, people: SpheroidPeople, seen: FlatObservation) -> JudgedFrame:
        """The frame with the people's silhouettes as they are."""
        own = silhouettes(people, self._flat, self._settings)
        return JudgedFrame(seen.ramp, self._counted, count_covering(seen.ramp.shape, own))

    def _update(
        self, people: SpheroidPeople, seen: FlatObservation, look: ColourLook, elapsed_s: float
    ) -> SpheroidPeople:
        """Everybody's hypotheses weighed, and what is seen of the estimates."""
        if len(people) == 0:
            return people
        settings, flat = self._settings, self._flat
        alike = None
        if settings.colour_weight > 0.0 and not settings.paper:
            colours, known = look.at(*hypotheses_of(people, settings))
            alike = appearance_log_weights(people, colours, known, settings.colour_weight)
            alike[seen_steeply(people, flat)] *= _STEEP_COLOURS
        judged = self._judged_frame(people, seen)
        people, windows = judge_and_weigh(people, judged, flat, settings, alike, seen.boxes)
        return measure_support(people, windows, flat, settings, elapsed_s)

    def _terminate(self, people: SpheroidPeople, seen: FlatObservation) -> SpheroidPeople:
        """Those who are still there; the tracks of the others coast for a while."""
        there = should_keep(people, self._settings)
        if seen.time_s >= self._next_ghosts_s:
            self._next_ghosts_s = seen.time_s + _GHOST_EVERY_S
            still = np.flatnonzero(there & (people.quiet_s > _GHOST_QUIET_S))
            there[still] = ~self._are_ghosts(people.select(still), seen)
        lost = self._coasting.append(people.select(~there), seen.time_s)
        kept_s = 0.0 if self._settings.paper else self._settings.coast_s
        self._coasting = lost.select(seen.time_s - lost.at_s < kept_s)
        return people.select(there)

    def _are_ghosts(self, people: SpheroidPeople, seen: FlatObservation) -> Flags:
        """(people,) who is but a hole in the background; nobody whom a detector sees."""
        outlines = silhouettes(people, self._flat, self._settings, _GHOST_SCALE)
        middle = self._flat.recorded_from_flat(np.column_stack((outlines.u, outlines.v)))
        ghosts = are_ghosts(self._flat, outlines, seen.ramp, seen.working)
        return ghosts & ~in_boxes(middle, seen.boxes)

    def _initiate(
        self, people: SpheroidPeople, seen: FlatObservation, look: ColourLook
    ) -> SpheroidPeople:
        """The people and those found new, at intervals ([Waechter2013] 3.3)."""
        settings = self._settings
        if seen.time_s < self._next_look_s:
            return people
        self._next_look_s = seen.time_s + settings.birth_interval_s - 1e-3
        new = self._begin(self._search(people, seen))
        if len(new) == 0:
            return people
        new = new.select(~self._are_ghosts(new, seen))
        return self._add(people, new, look, seen.time_s, seen.embed)

    def _search(self, people: SpheroidPeople, seen: FlatObservation) -> births.SpheroidCandidates:
        """Whom the foreground shows, for some searches now, and nobody follows."""
        settings = self._settings
        modest = people.replace(height=np.minimum(people.height, self._usual_m + births.TALLER_M))
        explained = silhouettes(modest, self._flat, settings, births.ENLARGED)
        free = self._counted & (count_covering(seen.ramp.shape, explained) == 0)
        axes = axes_of(people, settings)
        zones = count_covering(seen.ramp.shape, foot_zones(self._flat, axes))
        footless = None if settings.paper else zones == 0
        places = births.find_candidates(seen.ramp, free, self._cells, axes, footless)
        camera = np.asarray(self._flat.camera_position)
        candidates = births.update_candidates(self._candidates, places, seen.time_s, camera)
        self._candidates = candidates
        return candidates.select(candidates.searches >= settings.birth_frames)

    def _begin(self, found: births.SpheroidCandidates) -> SpheroidPeople:
        """People without ids where candidates are."""
        settings = self._settings
        mean = np.concatenate((found.xy, found.velocity), axis=1)
        height = np.full(len(mean), self._usual_m)
        track = np.zeros(len(mean), np.int32)
        count, random = settings.particles, self._random
        places = None if settings.paper else found.draw(count, random)
        return begin_people(
            track, mean, height, _HEIGHT_SD_M, count, _START_SPREADS, random, places
        )

    def _add(
        self,
        people: SpheroidPeople,
        new: SpheroidPeople,
        look: ColourLook,
        now_s: float,
        embed: Embed | None,
    ) -> SpheroidPeople:
        """The people with new ones: those lost a moment ago keep their tracks, others get ids."""
        colours, known = look.at(new.xy, new.height)
        new = learn_colours(new, colours, known, np.ones(len(new), bool))
        embedded = None
        if embed is not None and len(new) and len(self._coasting.people):
            given = embed(standing_boxes(self._flat.view, new.xy, new.height, BODY_WIDTH_M))
            embedded = self._known.log_likelihood_ratio(self._coasting.people.track, given)
        again = reidentify(self._coasting, new, now_s, embedded)
        found = again >= 0
        new = new.with_rows(~found, track=self._ids.take(int((~found).sum())))
        new, self._coasting = self._coasting.restore(new, found, again[found])
        everybody = concatenate([people, new])
        return everybody.select(np.argsort(everybody.track, kind="stable"))

    def _learn_embeddings(
        self, people: SpheroidPeople, box: NDArray[np.float64], seen: FlatObservation
    ) -> None:
        """What an appearance network says of those seen well, now and then."""
        if seen.embed is None or seen.time_s < self._next_embeddings_s:
            return
        self._next_embeddings_s = seen.time_s + _EMBEDDINGS_EVERY_S - 1e-3
        clear = np.flatnonzero(seen_whole(people) & (nearest_others_m(people.xy) > _ALONE_M))
        embeddings = seen.embed(box[clear])
        self._known.learn(people.track[clear], embeddings, np.ones(len(clear), bool))

    def _learn(self, people: SpheroidPeople, look: ColourLook, elapsed_s: float) -> SpheroidPeople:
        """The people with body heights and colours of those seen well."""
        whole = seen_whole(people)
        alone = whole & (nearest_others_m(people.xy) > _ALONE_M)
        if not self._settings.paper:
            sure = np.where(seen_steeply(people, self._flat), alone, whole)
            people = learn_heights(people, sure, elapsed_s)
        colours, known = look.at(axes_of(people, self._settings), people.height)
        return learn_colours(people, colours, known, alone)

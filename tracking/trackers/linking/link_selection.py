"""Which tracklets follow each other: one choice for the whole recording, the least costly.

It is a minimum-weight bipartite matching, sparse (R. Jonker, A. Volgenant: A Shortest
Augmenting Path Algorithm for Dense and Sparse Linear Assignment Problems, 1987; SciPy's).
"""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray
from scipy.sparse import coo_array
from scipy.sparse.csgraph import connected_components, min_weight_full_bipartite_matching

from tracking.trackers.linking.appearance import TrackletAppearance
from tracking.trackers.linking.links import Links
from tracking.trackers.linking.seen_rows import Floats
from tracking.trackers.linking.short import insert_short
from tracking.trackers.linking.tracklets import Tracklets

Rows = NDArray[np.intp]
Sums = tuple[Floats, Floats]
"""Two times (n, cues), of `TrackletAppearance.weight` and `.value`, summed over tracklets."""

_ROUNDS = 8
"""Most recordings need three; those that go to and fro are stopped."""
_LEAST_S = 0.2
"""In which a tracklet must be seen to be linked before the others."""


def least_rows(fps: float) -> int:
    """Of a tracklet that makes a person; one of fewer rows may be nobody."""
    return max(2, round(_LEAST_S * fps))


def select_links(
    links: Links, pieces: Tracklets, appearance: TrackletAppearance, fps: float
) -> Rows:
    """(t,) the tracklet that follows each; -1 where nobody does.

    Tracklets of few rows tell neither where somebody goes nor how they look: they are put where
    they fit after all others are linked.
    """
    long = np.asarray(pieces.stop - pieces.start >= least_rows(fps))
    following = _between_long(links, pieces, appearance, long)
    return insert_short(following, links, pieces, np.flatnonzero(~long))


def _between_long(
    links: Links, pieces: Tracklets, appearance: TrackletAppearance, long: NDArray[np.bool_]
) -> Rows:
    """The links of long tracklets.

    One globally cheapest assignment of beginnings to ends. Looks are compared between all of a
    person before and all after, which depends on the other links: it is repeated with those of
    the round before, from the tracker's own on. Of each group of tracklets that may be linked with
    each other the likeliest round is taken: what is odd about one person changes nobody else.
    """
    following = _of_tracker(pieces, long)
    links = links.select(long[links.end] & long[links.start])
    group = _groups(links, len(pieces))
    best, least = following, np.full(int(group.max(initial=-1)) + 1, np.inf)
    for _ in range(_ROUNDS):
        upto, since = _before_and_after(following, pieces, appearance)
        total = _totals(following, links, group, appearance, upto)
        best = np.where((total < least)[group], following, best)
        least = np.minimum(total, least)
        alike = appearance.log_likelihood_ratio(_only(upto, links.end), _only(since, links.start))
        again = _cheapest(links, links.cost - alike, len(pieces))
        if (again == following).all():
            break
        following = again
    return best


def _groups(links: Links, count: int) -> Rows:
    """(count,) the number of each tracklet's group; no link leads from one to another."""
    graph = coo_array((np.ones(len(links.end)), (links.end, links.start)), shape=(count, count))
    return np.asarray(connected_components(graph, directed=False)[1], np.intp)


def _totals(
    following: Rows, links: Links, group: Rows, appearance: TrackletAppearance, upto: Sums
) -> Floats:
    """(groups,) what all links of a round cost, each tracklet compared with all of a person before.

    Infinite where a link is hopeless: the tracker's own may be.

    Args:
        upto: of all tracklets, as `_before_and_after`.
    """
    made = links.select(following[links.end] == links.start)
    own = appearance.weight, appearance.value
    cost = made.cost - appearance.log_likelihood_ratio(
        _only(upto, made.end), _only(own, made.start)
    )
    total = np.zeros(int(group.max(initial=-1)) + 1)
    np.add.at(total, group[made.end], cost)
    hopeless = np.setdiff1d(np.flatnonzero(following >= 0), made.end)
    total[group[hopeless]] = total[group[following[hopeless]]] = np.inf
    return total


def number_people(following: Rows) -> Rows:
    """(t,) the number of each tracklet's person, in the order of the first tracklets."""
    first = np.ones(len(following), bool)
    first[following[following >= 0]] = False
    person = np.full(len(following), -1)
    for number, piece in enumerate(np.flatnonzero(first).tolist()):
        while piece >= 0:
            person[piece] = number
            piece = int(following[piece])
    return person


def _of_tracker(pieces: Tracklets, long: NDArray[np.bool_]) -> Rows:
    """(t,) what the tracker said of the long ones: every track is one person."""
    following = np.full(len(pieces), -1)
    rows = np.flatnonzero(long)
    same = np.flatnonzero(np.diff(pieces.track[rows]) == 0)
    following[rows[same]] = rows[same + 1]
    return following


def _before_and_after(
    following: Rows, pieces: Tracklets, appearance: TrackletAppearance
) -> tuple[Sums, Sums]:
    """The appearance of each tracklet's person up to its end, and from its beginning on."""
    person = number_people(following)
    order = np.lexsort((pieces.first.frame, person))
    opens = np.flatnonzero(np.diff(person[order], prepend=-1))
    length = np.diff(np.append(opens, len(order)))
    before, after = [], []
    for values in (appearance.weight, appearance.value):
        running = np.concatenate((np.zeros((1, values.shape[1])), np.cumsum(values[order], axis=0)))
        upto, since = np.empty_like(values), np.empty_like(values)
        upto[order] = running[1:] - np.repeat(running[opens], length, axis=0)
        since[order] = np.repeat(running[opens + length], length, axis=0) - running[:-1]
        before.append(upto)
        after.append(since)
    return (before[0], before[1]), (after[0], after[1])


def _only(sums: Sums, rows: Rows) -> Sums:
    return sums[0][rows], sums[1][rows]


def _cheapest(links: Links, cost: Floats, count: int) -> Rows:
    """(count,) who follows whom at least cost; links that cost more than two people are left.

    The matching is found on the links alone: a matrix of all tracklets outgrows memory in hours
    of footage. So that all of it is matched, each end may be followed by nobody, for nothing.
    """
    following = np.full(count, -1)
    good = cost < 0.0
    end, start = links.end[good], links.start[good]
    everybody = np.arange(count)
    each = (np.append(end, everybody), np.append(start, count + everybody))
    # Adding the same to all changes nothing; a weight of 0 would be no link.
    weight = np.append(cost[good], np.zeros(count)) - cost.min(initial=0.0) + 1.0
    graph = coo_array((weight, each), shape=(count, 2 * count)).tocsr()
    ends, starts = min_weight_full_bipartite_matching(graph)
    real = starts < count
    following[ends[real]] = starts[real]
    return following

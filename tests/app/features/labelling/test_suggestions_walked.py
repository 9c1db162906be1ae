from dataclasses import replace

from app.core.scenes.labels import SuggestedPart
from app.features.labelling.suggestion_list import SuggestionQueue
from tracking.tracks import PartLabels


def test_whoever_looks_at_a_suggestion_does_so_still_when_tracks_have_other_colours():
    queue = SuggestionQueue()
    found = [SuggestedPart((frame, 4, "head"), "", "", "4", (0, 0, 0), "") for frame in (3, 8)]
    queue.take(found, PartLabels())
    queue.choose(1)
    queue.replace_each(lambda all_of: [replace(one, colour=(9, 9, 9)) for one in all_of])
    assert (queue.place, queue.current.key) == (1, (8, 4, "head"))
    assert {one.colour for one in queue.open} == {(9, 9, 9)}

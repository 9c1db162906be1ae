"""The door: trackers, formats, recordings and detectors, our own and those of other packages.

Each kind has a group of entry points (`trackwright.trackers` and so on). What is offered is known
by name without importing anything; it is imported when it is asked for, and who fails is named.
"""

from tracking.plugins.blame import blaming, failed_drawing
from tracking.plugins.catalogue import Catalogue, CatalogueFault
from tracking.plugins.kind import PluginKind
from tracking.plugins.offers import WITHOUT, Offer, offered_for_a_while, offers_of

__all__ = [
    "WITHOUT",
    "Catalogue",
    "CatalogueFault",
    "Offer",
    "PluginKind",
    "blaming",
    "failed_drawing",
    "offered_for_a_while",
    "offers_of",
]

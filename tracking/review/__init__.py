"""Where to look: places where tracks are likely wrong, ranked by what looking is worth."""

from tracking.review.kind_records import KindRecord, records_of, with_learned_likelihoods
from tracking.review.measures import Mistake, ReviewMeasures, ReviewMeter, review_measures
from tracking.review.queue import filter_undecided, rank
from tracking.review.reason_phrases import KINDS
from tracking.review.review_item import ReviewItem, ReviewItemKey
from tracking.review.review_search import ReviewFinding, ReviewItemFinder, find_review_items
from tracking.review.review_state import ReviewState, review_state
from tracking.review.risk import DecidedItems, ErrorsLeft, errors_left, learned_rate, reviewed_share

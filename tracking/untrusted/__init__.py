"""Files from elsewhere are checked before they are read."""

from tracking.untrusted.program import (
    DAMAGED,
    bare_packages,
    limit,
    say_verdicts,
    verdict_by,
    verdicts_of,
)
from tracking.untrusted.walk import (
    Kind,
    Refused,
    Walk,
    attribute_of,
    check_attributes,
    check_signature,
    version_of,
)

__all__ = [
    "DAMAGED",
    "Kind",
    "Refused",
    "Walk",
    "attribute_of",
    "bare_packages",
    "check_attributes",
    "check_signature",
    "limit",
    "say_verdicts",
    "verdict_by",
    "verdicts_of",
    "version_of",
]

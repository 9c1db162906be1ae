"""Files from elsewhere are checked before they are read."""

from tracking.untrusted.named_format import named_format
from tracking.untrusted.patience import go_on
from tracking.untrusted.program import (
    bare_packages,
    limit,
    say_verdicts,
    verdict_by,
    verdicts_of,
)
from tracking.untrusted.walk import (
    FAILURES,
    SIGNATURE,
    Kind,
    Refused,
    Walk,
    attribute_of,
    check_attributes,
    check_signature,
    checked_file,
)

"""Whoever fails is named: what a plug-in raises becomes an error that says which it was."""

from __future__ import annotations

import traceback
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from functools import wraps
from pathlib import Path
from typing import ParamSpec, TypeVar

from tracking.errors import PluginError, TrackwrightError
from tracking.plugins.kind import PluginKind
from tracking.plugins.offers import WITHOUT, Offer
from tracking.translation import N_, msg

P = ParamSpec("P")
R = TypeVar("R")


@contextmanager
def blaming(offer: Offer) -> Iterator[None]:
    """Turn whatever goes wrong in code of a plug-in into a `PluginError` that names it.

    Our own errors pass, since they say already what is wrong, and so does an interrupt. Nothing is
    turned where the offer is built in.
    """
    try:
        yield
    except (TrackwrightError, KeyboardInterrupt, GeneratorExit, StopIteration):
        raise
    except BaseException as error:
        if offer.built_in:
            raise
        raise failed(offer, error) from error


def guarded(call: Callable[P, R], offer: Offer) -> Callable[P, R]:
    """The same call; what it raises names the plug-in."""

    @wraps(call)
    def blamed(*given: P.args, **named: P.kwargs) -> R:
        with blaming(offer):
            return call(*given, **named)

    return blamed


def guarded_if(call: Callable[P, R] | None, offer: Offer) -> Callable[P, R] | None:
    """The same call, see `guarded`; None where there is none."""
    return None if call is None else guarded(call, offer)


def failed(offer: Offer, error: BaseException) -> PluginError:
    """The error for what a plug-in raised."""
    said = str(error).strip().partition("\n")[0]
    what = type(error).__name__
    reason = msg(
        "{who} raised {error} at {place}",
        who=offer.words,
        error=f"{what}: {said}" if said else what,
        place=_place(offer, error),
    )
    return PluginError(reason).advising(CURE, package=offer.package, variable=WITHOUT)


_wrong: dict[tuple[str, str], PluginError] = {}


def guarded_drawing(
    call: Callable[P, R], offer: Offer, check: Callable[[R], bool], nothing: Callable[P, R]
) -> Callable[P, R]:
    """The same call for a view, which goes on without it where it fails: see `failed_drawing`.

    Args:
        check: whether what it gave can be drawn. nothing: what is drawn where it cannot.
    """

    @wraps(call)
    def blamed(*given: P.args, **named: P.kwargs) -> R:
        try:
            with blaming(offer):
                drawn = call(*given, **named)
                if check(drawn):
                    return drawn
            raise accused(offer, "what it gave for an overlay cannot be drawn")
        except PluginError as error:
            _wrong.setdefault((offer.kind, offer.name), error)
            return nothing(*given, **named)

    return blamed


def failed_drawing(kind: PluginKind, name: str) -> PluginError | None:
    """What went wrong first as a plug-in's overlays were drawn; None: nothing."""
    return _wrong.get((kind, name))


CURE = N_(
    "update it, or remove it: pip uninstall {package}; {variable}=off starts without plug-ins"
)
"""What to do about a plug-in that does not work; its values are `package` and `variable`."""


def accused(offer: Offer, what: str, /, **values: object) -> PluginError:
    """The error for a plug-in that did something wrong, in words."""
    reason = msg("{who}: {what}", who=offer.words, what=msg(what, **values))
    return PluginError(reason).advising(CURE, package=offer.package, variable=WITHOUT)


def _place(offer: Offer, error: BaseException) -> str:
    """File and line of the plug-in's own code where it went wrong, else of whatever raised."""
    own = offer.module.partition(".")[0]
    frames = traceback.extract_tb(error.__traceback__)
    inside = [one for one in frames if own in Path(one.filename).with_suffix("").parts]
    if not (last := (inside or frames)[-1:]):
        return offer.module
    return f"{Path(last[0].filename).name}:{last[0].lineno}"

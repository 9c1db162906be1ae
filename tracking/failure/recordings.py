"""Samples of several recordings together: who is held out in training is told by their names."""

from __future__ import annotations

from collections.abc import Iterable
from itertools import count

import numpy as np

from tracking.failure.samples import Samples

Named = dict[str, str]
"""The names of recordings, and the footage each of them stands for."""


def told_apart(sources: Iterable[tuple[Samples, str, str]]) -> list[Samples]:
    """The samples of each source, different recordings under different names.

    To training, one track of one recording's name is one person. So footage whose name other
    footage had before gets the title of its source, too. Sources of the same footage keep one
    name, and so do those that do not know their footage, as tables: they are taken to speak of
    the recording they name, lest somebody is learnt from and held out at once.

    Args:
        sources: samples, what their footage is known by ("": not known) and the source's title.
    """
    footage_of: Named = {}
    own: dict[tuple[str, str], str] = {}
    apart = []
    for samples, footage, title in sources:
        given = samples.columns["recording"].tolist()
        for name in sorted(set(given)) if footage else ():
            if (name, footage) not in own:
                own[name, footage] = _free_name(name, footage, title, footage_of)
        names = [own.get((name, footage), name) for name in given]
        columns = {**samples.columns, "recording": np.array(names, object)}
        apart.append(Samples(columns, samples.features))
    return apart


def _free_name(name: str, footage: str, title: str, footage_of: Named) -> str:
    """A name that stands for no other footage; it stands for this one from now on."""
    own = name
    for number in count(1):
        if footage_of.setdefault(own, footage) == footage:
            break
        own = f"{name} ({title})" if number == 1 else f"{name} ({title}, {number})"
    return own

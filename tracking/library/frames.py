"""Tracks as a data frame."""

from __future__ import annotations

from typing import TYPE_CHECKING

from tracking.errors import TrackwrightError
from tracking.library.tables import Tracks, table_of
from tracking.recording import Recording

if TYPE_CHECKING:
    import pandas as pd


def to_pandas(tracks: Tracks | Recording) -> pd.DataFrame:
    """Tracks as a pandas data frame, a row for each person and frame.

    Args:
        tracks: a session (its corrected tracks), a run, a table of tracks, a recording (the truth
            beside it), or a path of any of these or of a file of another tool.

    Returns:
        The columns of docs/session-file.md: `frame` from 0, `track`, `left, top, width, height` in
        px of the left image, `x, y` in m and `vx, vy` in m/s on the floor (NaN: not known),
        `confidence`, `visibility`, `predicted`.

    Raises:
        TrackwrightError: pandas is not installed; a file cannot be read.
    """
    try:
        import pandas as pd
    except ImportError as error:
        raise TrackwrightError(
            "pandas is not installed", 'install it: pip install "trackwright[pandas]"'
        ) from error
    return pd.DataFrame({name: column.copy() for name, column in table_of(tracks).columns.items()})

"""For type checkers: where the names of `tracking` stand, which it imports as they are used."""

from tracking.errors import TrackwrightError as TrackwrightError
from tracking.library.edits import edit as edit
from tracking.library.exports import export as export
from tracking.library.frames import to_pandas as to_pandas
from tracking.library.pictures import plot as plot
from tracking.library.recordings import open_recording as open_recording
from tracking.library.runs import track as track
from tracking.library.scores import score as score
from tracking.library.sessions import read_session as read_session
from tracking.recording import OpenOptions as OpenOptions
from tracking.recording import Recording as Recording
from tracking.scoring import Score as Score
from tracking.session import Session as Session

__version__: str
__all__: list[str]

"""Trackers of plug-ins that go wrong, each in its own way, as the code of a package."""

_TRACKER = """
import time
import numpy as np
from dataclasses import dataclass, replace
from tracking.foreground import ForegroundSettings
from tracking.people import PeopleSettings
from tracking.setting import setting, stage
from tracking.trackers import IdTracker, TrackerOverlays, TrackerSpec, one_camera

@dataclass(frozen=True, slots=True)
class Settings:
    foreground: ForegroundSettings = stage(ForegroundSettings)
    people: PeopleSettings = stage(PeopleSettings)

HELD = []

class Bad(IdTracker[Settings]):
    def associate(self, known, people):
        return np.zeros(len(people), np.int32)

    def step(self, observation):
        result = super().step(observation)
        tracks, n = dict(result.tracks), len(result.tracks["track"])
        if n < 2:
            return result
        {step}
        return replace(result, tracks=tracks)

def build(*given):
    {build}
    return one_camera(Bad)(*given)

TRACKER = TrackerSpec(
    name="bad", title="Bad", paper="", needs_stereo=False, needs_calibration=False,
    settings_type=Settings, build=build, step_limit_s={limit_s},
    overlays=TrackerOverlays(outlines=lambda *_: {outlines}),
)
"""


def tracker_code(
    step: str = "pass", build: str = "pass", limit_s: float = 60.0, outlines: str = "None"
) -> str:
    """A tracker whose step runs a line in frames with two people or more."""
    code = _TRACKER.replace("{step}", step).replace("{build}", build)
    return code.replace("{limit_s}", str(limit_s)).replace("{outlines}", outlines)


WRONG_STEPS = {
    "raises": ("raise ValueError('no such person')", "raised ValueError: no such person at"),
    "asserts": ("assert False", "raised AssertionError at"),
    "exits": ("raise SystemExit(3)", "raised SystemExit: 3 at"),
    "no result": ("return None", "step gave NoneType"),
    "another frame": ("return replace(result, frame=99)", "says that it is of frame 99"),
    "NaN box": ("tracks['left'] = np.full(n, np.nan)", "tracks: column left holds nan"),
    "far box": ("tracks['top'] = np.full(n, 1e300)", "tracks: column top holds 1e+300"),
    "negative box": ("tracks['width'] = np.full(n, -4.0)", "a box has a negative width or height"),
    "NaN id": ("tracks['track'] = np.full(n, np.nan)", "column track holds NaN or fractions"),
    "id 0": ("tracks['track'] = np.zeros(n, int)", "track id 0; ids are positive"),
    "one id twice": ("tracks['track'] = np.ones(n, int)", "track 1 stands twice in frame"),
    "rows of other frames": ("tracks['frame'] = tracks['frame'] + 1", "has rows of other frames"),
    "wrong shape": ("tracks['x'] = np.zeros((n, 2))", "column x has shape"),
    "wrong length": ("tracks['y'] = np.zeros(n + 1)", "the columns have different lengths"),
    "missing column": ("del tracks['vx']", "column vx is missing"),
    "texts": ("tracks['height'] = np.array(['x'] * n)", "column height holds <U1"),
    "objects": ("tracks['height'] = np.array([object()] * n)", "column height holds object"),
    "too sure": ("tracks['confidence'] = np.full(n, 7.0)", "confidence must be 0 to 1"),
    "no table": ("tracks = 5; return replace(result, tracks=5)", "is no table of numbers"),
}
"""What a step does, and what is said of it."""

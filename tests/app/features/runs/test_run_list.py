"""The runs of a session, and what can be done with each."""

from contextlib import closing

import cv2
import numpy as np

from app.features.runs.presenter import RunList
from tracking.recording import open_recording
from tracking.session import Session


def test_a_run_is_not_tracked_again_where_its_tracker_cannot_work(
    tiny_recording, tiny_run, tmp_path
):
    for number in range(3):
        image = np.full((48, 64, 3), 90, np.uint8)
        assert cv2.imwrite(str(tmp_path / f"{number}.png"), image)
    (tmp_path / "recording.toml").write_text(
        'format = 1\nname = "one camera"\nfps = 10.0\n[left]\nsource = "*.png"\n'
    )
    with (
        open_recording(tiny_recording) as stereo,
        open_recording(tmp_path) as one_camera,
        closing(Session.create(stereo, [tiny_run])) as session,
    ):
        again = {
            one.is_stereo: RunList(session, one).scene().rows[-1].why_not_again
            for one in (stereo, one_camera)
        }
    assert again[True] == ""
    assert "calibrat" in again[False] or "camera" in again[False]

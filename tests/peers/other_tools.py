"""What other tools read in files, said as JSON: `other_tools.py TOOL FILE...`.

Each runs in its own environment. Rows are frame, track and a box (left, top, width, height) or a
place (x, y).
"""

from __future__ import annotations

import json
import sys
import zlib
from typing import Any

Rows = list[list[Any]]


def datumaro(path: str) -> Rows:
    """Boxes in view of CVAT's XML."""
    from datumaro.components.dataset import Dataset

    return [
        [item.attributes["frame"], box.attributes["track_id"], *box.get_bbox()]
        for item in Dataset.import_from(path, "cvat")
        for box in item.annotations
        if not box.attributes["outside"]
    ]


def datumaro_coco(path: str) -> Rows:
    """Boxes of the JSON in `annotations`, by the track in their attributes."""
    from pathlib import Path

    from datumaro.components.dataset import Dataset

    folder = Path(path).parent.parent
    (folder / "images").mkdir(exist_ok=True)
    return [
        [item.attributes["id"] - 1, box.attributes["track_id"], *box.get_bbox()]
        for item in Dataset.import_from(str(folder), "coco_instances")
        for box in item.annotations
    ]


def pycocotools(path: str) -> Rows:
    """Annotations by image."""
    from pycocotools.coco import COCO

    coco = COCO(path)
    return [
        [image["frame_index"], row["track_id"], *row["bbox"]]
        for image in coco.loadImgs(coco.getImgIds())
        for row in coco.loadAnns(coco.getAnnIds(imgIds=image["id"]))
    ]


def jupedsim(path: str) -> Rows:
    """Agents by frame."""
    import jupedsim as jps

    recording = jps.Recording(path)
    recording.bounds(), recording.geometry(), recording.fps
    return [
        [frame, agent.id, *agent.position]
        for frame in range(recording.num_frames)
        for agent in recording.frame(frame).agents
    ]


def sleap_io(path: str) -> Rows:
    """Made-up instances, written to the path; what boxes are around their nodes.

    The path's ending says what is written: an analysis as HDF5 (`.h5`) or CSV, or a project
    (`.slp`); in half of them nobody has a track.
    """
    import numpy as np
    import sleap_io as sio

    random = np.random.default_rng(zlib.crc32(path.encode()))
    tracked = bool(random.random() < 0.5)
    skeleton = sio.Skeleton(["head", "left", "right"])
    tracks = [sio.Track(f"person {at}") for at in range(4)]
    video = sio.Video("none.mp4")
    frames, rows = [], []
    ids: dict[int, int] = {}  # CSV has names alone: their order counts
    for frame in range(30):
        instances: list[Any] = []
        for number, track in enumerate(tracks, start=1):
            points = random.normal(200, 50, (3, 2))
            points[random.random(3) < 0.3] = np.nan
            seen = points[np.isfinite(points[:, 0])]
            if random.random() < 0.3 or not len(seen):
                continue
            own = track if tracked else None
            instances.append(
                sio.PredictedInstance.from_numpy(points, skeleton=skeleton, track=own, score=0.5)
            )
            if not tracked:
                number = len(instances)
            elif path.endswith(".csv"):
                number = ids.setdefault(number, len(ids) + 1)
            low, high = seen.min(axis=0), seen.max(axis=0)
            rows.append([frame, number, *low.tolist(), *(high - low).tolist()])
        frames.append(sio.LabeledFrame(video=video, frame_idx=frame, instances=instances))
    preset = ("matlab", "standard")[len(rows) % 2]
    known = tracks if tracked else []
    labels = sio.Labels(frames, videos=[video], skeletons=[skeleton], tracks=known)
    if path.endswith(".slp"):
        sio.save_slp(labels, path)
    elif path.endswith(".csv"):
        sio.save_csv(labels, path, format="sleap")
    else:
        sio.save_analysis_h5(labels, path, preset=preset)
    return rows


TOOLS = {
    "datumaro": datumaro,
    "datumaro-coco": datumaro_coco,
    "pycocotools": pycocotools,
    "jupedsim": jupedsim,
    "sleap-io": sleap_io,
}

if __name__ == "__main__":
    print(json.dumps([TOOLS[sys.argv[1]](path) for path in sys.argv[2:]]))

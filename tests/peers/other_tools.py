"""What other tools read in files, or write: `other_tools.py TOOL FILE...`, said as JSON.

Each runs in its own environment. Rows are frame, track and a box (left, top, width, height) or a
place (x, y).
"""

from __future__ import annotations

import json
import os
import sys
import zlib
from pathlib import Path
from typing import Any

Rows = list[list[Any]]
CONFIG = """<View><Video name="video" value="$video"/><VideoRectangle name="box" toName="video"/>
<Labels name="labels" toName="video"><Label value="person"/></Labels></View>"""


def datumaro(path: Path) -> Rows:
    """Boxes in view of CVAT's XML."""
    from datumaro.components.dataset import Dataset

    return [
        [item.attributes["frame"], box.attributes["track_id"], *box.get_bbox()]
        for item in Dataset.import_from(str(path), "cvat")
        for box in item.annotations
        if not box.attributes["outside"]
    ]


def datumaro_coco(path: Path) -> Rows:
    """Boxes of the JSON in `annotations`, by the track in their attributes."""
    from datumaro.components.dataset import Dataset

    folder = path.parent.parent
    (folder / "images").mkdir(exist_ok=True)
    return [
        [item.attributes["id"] - 1, box.attributes["track_id"], *box.get_bbox()]
        for item in Dataset.import_from(str(folder), "coco_instances")
        for box in item.annotations
    ]


def pycocotools(path: Path) -> Rows:
    """Annotations by image."""
    from pycocotools.coco import COCO

    coco = COCO(str(path))
    return [
        [image["frame_index"], row["track_id"], *row["bbox"]]
        for image in coco.loadImgs(coco.getImgIds())
        for row in coco.loadAnns(coco.getAnnIds(imgIds=image["id"]))
    ]


def jupedsim(path: Path) -> Rows:
    """Agents by frame."""
    import jupedsim as jps

    recording = jps.Recording(str(path))
    recording.bounds(), recording.geometry(), recording.fps
    return [
        [frame, agent.id, *agent.position]
        for frame in range(recording.num_frames)
        for agent in recording.frame(frame).agents
    ]


def sleap_io(path: Path) -> Rows:
    """Made-up instances, written to the path; what boxes are around their nodes.

    The path's ending says what is written: an analysis as HDF5 (`.h5`) or CSV, or a project
    (`.slp`); in half of them nobody has a track.
    """
    import numpy as np
    import sleap_io as sio

    random = np.random.default_rng(zlib.crc32(bytes(path)))
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
            elif path.suffix == ".csv":
                number = ids.setdefault(number, len(ids) + 1)
            low, high = seen.min(axis=0), seen.max(axis=0)
            rows.append([frame, number, *low.tolist(), *(high - low).tolist()])
        frames.append(sio.LabeledFrame(video=video, frame_idx=frame, instances=instances))
    preset = ("matlab", "standard")[len(rows) % 2]
    known = tracks if tracked else []
    labels = sio.Labels(frames, videos=[video], skeletons=[skeleton], tracks=known)
    if path.suffix == ".slp":
        sio.save_slp(labels, str(path))
    elif path.suffix == ".csv":
        sio.save_csv(labels, str(path), format="sleap")
    else:
        sio.save_analysis_h5(labels, str(path), preset=preset)
    return rows


def label_studio(path: Path) -> Rows:
    """Boxes between keyframes; the same as JSON_MIN goes to `min/result.json` beside the file."""
    from label_studio_sdk._extensions.label_studio_tools.postprocessing.video import (
        extract_key_frames,
    )
    from label_studio_sdk.converter import Converter

    (task,) = json.loads(path.read_text(encoding="utf-8"))
    task["id"] = 1  # Label Studio gives a task one when it takes it in
    numbered = path.with_suffix(".task")
    numbered.write_text(json.dumps([task]), encoding="utf-8")
    converter = Converter(CONFIG, str(path.parent), download_resources=False)
    converter.convert_to_json_min(str(numbered), str(path.parent / "min"), is_dir=False)
    rows = []
    for region in extract_key_frames(task["annotations"][0]["result"]):
        track, value = int(region["id"].removeprefix("track-")), region["value"]
        width, height = region["original_width"] / 100, region["original_height"] / 100
        for key in value["sequence"]:
            box = [key["x"] * width, key["y"] * height, key["width"] * width]
            rows.append([key["frame"] - 1, track, *box, key["height"] * height])
    return rows


def x_anylabeling(path: Path) -> Rows:
    """Groups of a folder as MOT text; each file, opened and saved, goes to the folder `saved`."""
    os.environ["QT_QPA_PLATFORM"] = "offscreen"
    from anylabeling.views.labeling.label_converter import LabelConverter
    from anylabeling.views.labeling.label_file import LabelFile
    from PIL import Image

    saved, texts = path.parent / "saved", path.parent / "mot"
    saved.mkdir()
    texts.mkdir()
    converter = LabelConverter()
    converter.classes = ["person", "dog"]
    converter.custom_to_mot(str(path), str(texts))
    Image.new("RGB", (640, 480)).save(path.parent / "one.jpg")
    for file in sorted(path.glob("*.json")):
        picture = file.with_suffix(".jpg")
        picture.hardlink_to(path.parent / "one.jpg")
        held = LabelFile(str(file))
        held.save(
            filename=str(saved / file.name),
            shapes=[shape.to_dict() for shape in held.shapes],
            image_path=held.image_path,
            image_height=480,
            image_width=640,
            other_data=held.other_data,
            flags=held.flags,
        )
    lines = (texts / "gt.txt").read_text().splitlines()
    return [[int(number) for number in line.split(",")[:6]] for line in lines]


TOOLS = {
    "datumaro": datumaro,
    "datumaro-coco": datumaro_coco,
    "pycocotools": pycocotools,
    "jupedsim": jupedsim,
    "sleap-io": sleap_io,
    "label-studio-sdk": label_studio,
    "x-anylabeling": x_anylabeling,
}

if __name__ == "__main__":
    print(json.dumps([TOOLS[sys.argv[1]](Path(path)) for path in sys.argv[2:]]))

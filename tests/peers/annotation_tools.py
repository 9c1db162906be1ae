"""What annotation tools read in files, and what they write of them: `... TOOL FILE...`.

Each runs in its own environment. Printed is, as JSON, for each file a list of what the tool read:
rows of frame, track and a box (left, top, width, height).
"""

from __future__ import annotations

import json
import os
import sys
from pathlib import Path
from typing import Any

Rows = list[list[Any]]
CONFIG = """<View><Video name="video" value="$video"/><VideoRectangle name="box" toName="video"/>
<Labels name="labels" toName="video"><Label value="person"/></Labels></View>"""


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


TOOLS = {"label-studio-sdk": label_studio, "x-anylabeling": x_anylabeling}

if __name__ == "__main__":
    print(json.dumps([TOOLS[sys.argv[1]](Path(path)) for path in sys.argv[2:]]))

"""One rendered scene written into each container that footage of stereo cameras comes in."""

from __future__ import annotations

import io
import json
import tarfile
import tempfile
from collections.abc import Callable, Iterator
from dataclasses import dataclass
from datetime import UTC, datetime
from pathlib import Path
from typing import Any

import cv2
import numpy as np
from numpy.typing import NDArray
from rosbags.rosbag1 import Writer as Rosbag1Writer
from rosbags.rosbag2 import StoragePlugin
from rosbags.rosbag2 import Writer as Rosbag2Writer
from rosbags.typesys import Stores, get_typestore

from tracking.geometry import StereoCalibration
from tracking.synthesis import SCENES, Scene

FPS, FRAMES, SIZE = 10.0, 14, (160, 120)
START_NS = 1_700_000_000_000_000_000
Picture = NDArray[Any]


@dataclass(frozen=True, slots=True)
class Footage:
    """Frames of a scene: left, right (BGR) and depth in mm, when, and by which cameras."""

    left: list[Picture]
    right: list[Picture]
    depth: list[Picture]
    stamps_ns: list[int]
    calibration: StereoCalibration


def footage_of_scene() -> Footage:
    """Uneven by a little, as cameras are, and one frame was lost."""
    scene = Scene(SCENES["lobby"], people=3, seed=1, seconds=FRAMES / FPS, size=SIZE, fps=FPS)
    frames = [scene.frame(number)[0] for number in range(scene.frames)]
    depth = [np.rint(1000 * scene.depth(n)).clip(0, 65534).astype(np.uint16) for n in range(FRAMES)]
    steps = [*range(5), *range(6, FRAMES + 1)]
    stamps = [START_NS + step * 100_000_000 + 1000 * n for n, step in enumerate(steps)]
    rights = [frame.right for frame in frames if frame.right is not None]
    return Footage([frame.left for frame in frames], rights, depth, stamps, scene.rig.calibration)


def write_euroc(folder: Path, footage: Footage) -> Path:
    pair = footage.calibration
    for number, (pictures, camera) in enumerate(
        ((footage.left, pair.left), (footage.right, pair.right))
    ):
        assert camera is not None
        place = folder / "mav0" / f"cam{number}"
        (place / "data").mkdir(parents=True)
        rows = ["#timestamp [ns],filename"]
        for stamp, picture in zip(footage.stamps_ns, pictures, strict=True):
            cv2.imwrite(str(place / "data" / f"{stamp}.png"), picture)
            rows.append(f"{stamp},{stamp}.png")
        (place / "data.csv").write_text("\r\n".join(rows) + "\r\n")
        pose = np.eye(4)
        pose[0, 3] = number * pair.baseline_m
        main = camera.matrix[[0, 1, 0, 1], [0, 1, 2, 2]].tolist()
        (place / "sensor.yaml").write_text(
            "sensor_type: camera\ncomment: VI-Sensor\nT_BS:\n  cols: 4\n  rows: 4\n"
            f"  data: {pose.ravel().tolist()}\nrate_hz: 10\nresolution: {list(camera.size)}\n"
            f"camera_model: pinhole\nintrinsics: {main}\n"
            "distortion_model: radial-tangential\ndistortion_coefficients: [0, 0, 0, 0]\n"
        )
    return folder


def write_kitti(folder: Path, footage: Footage) -> Path:
    drive = folder / "2011_09_26_drive_0001_sync"
    for number, pictures in ((2, footage.left), (3, footage.right)):
        place = drive / f"image_{number:02d}"
        (place / "data").mkdir(parents=True)
        lines = []
        for at, (stamp, picture) in enumerate(zip(footage.stamps_ns, pictures, strict=True)):
            cv2.imwrite(str(place / "data" / f"{at:010d}.png"), picture)
            moment = datetime.fromtimestamp(stamp // 10**9, UTC)
            lines.append(f"{moment:%Y-%m-%d %H:%M:%S}.{stamp % 10**9:09d}")
        (place / "timestamps.txt").write_text("\n".join(lines) + "\n")
    matrix, width, height = footage.calibration.left.matrix, *SIZE
    lines = ["calib_time: 09-Jan-2012 13:57:47"]
    for number, shift in ((2, 0.0), (3, -footage.calibration.baseline_m)):
        projection = np.column_stack((matrix, [matrix[0, 0] * shift, 0, 0]))
        lines.append(f"S_rect_{number:02d}: {width:.6e} {height:.6e}")
        lines.append(f"P_rect_{number:02d}: {' '.join(map(repr, projection.ravel().tolist()))}")
    (folder / "calib_cam_to_cam.txt").write_text("\n".join(lines) + "\n")
    return drive


def write_oak(folder: Path, footage: Footage, *, depth: bool = False) -> Path:
    other = {"depth": footage.depth} if depth else {"right": footage.right}
    sides = {"left": footage.left, **other}
    for side, pictures in sides.items():
        (folder / side).mkdir(parents=True)
        for stamp, picture in zip(footage.stamps_ns, pictures, strict=True):
            cv2.imwrite(str(folder / side / f"{stamp}.png"), picture)
    matrix = footage.calibration.left.matrix.tolist()
    turn = np.eye(3).tolist()
    cameras = []
    for socket, other, shift in ((1, 2, -100 * footage.calibration.baseline_m), (2, -1, 0.0)):
        place = {"x": shift, "y": 0.0, "z": 0.0}
        extrinsics = {"toCameraSocket": other, "rotationMatrix": turn, "translation": place}
        camera = {"width": SIZE[0], "height": SIZE[1], "intrinsicMatrix": matrix}
        cameras.append(
            [socket, {**camera, "distortionCoeff": [0.0] * 14, "extrinsics": extrinsics}]
        )
    stereo = {"leftCameraSocket": 1, "rightCameraSocket": 2}
    told = {"cameraData": cameras, "stereoConfigData": stereo}
    (folder / "calib.json").write_text(json.dumps(told))
    return folder


def write_oak_tar(folder: Path, footage: Footage, *, depth: bool = False) -> Path:
    path = folder / "run.tar"
    with tempfile.TemporaryDirectory() as loose:
        write_oak(Path(loose), footage, depth=depth)
        folder.mkdir(parents=True, exist_ok=True)
        with tarfile.open(path, "w") as archive:
            archive.add(loose, "run")
    return path


def write_zed(folder: Path, footage: Footage) -> Path:
    folder.mkdir(parents=True, exist_ok=True)
    for number, (left, depth) in enumerate(zip(footage.left, footage.depth, strict=True)):
        cv2.imwrite(str(folder / f"left{number:06d}.png"), left)
        cv2.imwrite(str(folder / f"depth{number:06d}.png"), depth)
    return folder


def messages_of(
    footage: Footage, store: Any, *, compressed: bool, depth: bool
) -> Iterator[tuple[str, int, Any]]:
    """Topic, time of recording (late by a ms or two) and message, in order."""
    kinds = store.types
    stamp_kind, header_kind = kinds["builtin_interfaces/msg/Time"], kinds["std_msgs/msg/Header"]
    ros1 = "seq" in header_kind.__dataclass_fields__
    pair = footage.calibration

    def header(stamp: int) -> Any:
        time = stamp_kind(sec=stamp // 10**9, nanosec=stamp % 10**9)
        return header_kind(stamp=time, frame_id="camera", **({"seq": 0} if ros1 else {}))

    def info(stamp: int, shift: float) -> Any:
        matrix = pair.left.matrix
        region = kinds["sensor_msgs/msg/RegionOfInterest"](
            x_offset=0, y_offset=0, height=0, width=0, do_rectify=False
        )
        values = {
            "d": np.zeros(5),
            "k": matrix.ravel(),
            "r": np.eye(3).ravel(),
            "p": np.column_stack((matrix, [matrix[0, 0] * shift, 0, 0])).ravel(),
        }
        values = {name.upper() if ros1 else name: value for name, value in values.items()}
        return kinds["sensor_msgs/msg/CameraInfo"](
            header=header(stamp), height=SIZE[1], width=SIZE[0], distortion_model="plumb_bob",
            binning_x=0, binning_y=0, roi=region, **values,
        )  # fmt: skip

    def image(stamp: int, picture: Picture, encoding: str) -> Any:
        if compressed and encoding == "bgr8":
            data = np.frombuffer(cv2.imencode(".png", picture)[1].tobytes(), np.uint8)
            kind = kinds["sensor_msgs/msg/CompressedImage"]
            return kind(header=header(stamp), format="png", data=data)
        if encoding == "rgb8":
            picture = picture[..., ::-1]
        data = np.frombuffer(np.ascontiguousarray(picture).tobytes(), np.uint8)
        return kinds["sensor_msgs/msg/Image"](
            header=header(stamp), height=SIZE[1], width=SIZE[0], encoding=encoding,
            is_bigendian=0, step=len(data) // SIZE[1], data=data,
        )  # fmt: skip

    ending = "image_raw/compressed" if compressed else "image_raw"
    for number, stamp in enumerate(footage.stamps_ns):
        yield "/stereo/left/camera_info", stamp + 1_000_000, info(stamp, 0.0)
        left = image(stamp, footage.left[number], "bgr8")
        yield f"/stereo/left/{ending}", stamp + 1_100_000, left
        if depth:
            units = image(stamp, footage.depth[number], "16UC1")
            yield "/stereo/depth/image_rect_raw", stamp + 1_200_000, units
        else:
            yield "/stereo/right/camera_info", stamp + 1_200_000, info(stamp, -pair.baseline_m)
            right = image(stamp, footage.right[number], "bgr8" if compressed else "rgb8")
            yield f"/stereo/right/{ending}", stamp + 2_300_000, right


def write_rosbag1(
    folder: Path,
    footage: Footage,
    *,
    compressed: bool = False,
    depth: bool = False,
    packed: bool = False,
) -> Path:
    folder.mkdir(parents=True, exist_ok=True)
    path, store = folder / "run.bag", get_typestore(Stores.ROS1_NOETIC)
    writer = Rosbag1Writer(path)
    if packed:
        writer.set_compression(Rosbag1Writer.CompressionFormat.LZ4)
    with writer:
        connections: dict[str, Any] = {}
        for topic, time, value in messages_of(footage, store, compressed=compressed, depth=depth):
            kind = value.__msgtype__
            if topic not in connections:
                connections[topic] = writer.add_connection(topic, kind, typestore=store)
            writer.write(connections[topic], time, store.serialize_ros1(value, kind))
    return path


def write_rosbag2(
    folder: Path,
    footage: Footage,
    *,
    storage: StoragePlugin = StoragePlugin.SQLITE3,
    compressed: bool = False,
    depth: bool = False,
) -> Path:
    folder.mkdir(parents=True, exist_ok=True)
    path, store = folder / "run", get_typestore(Stores.ROS2_HUMBLE)
    with Rosbag2Writer(path, version=9, storage_plugin=storage) as writer:
        connections: dict[str, Any] = {}
        for topic, time, value in messages_of(footage, store, compressed=compressed, depth=depth):
            kind = value.__msgtype__
            if topic not in connections:
                connections[topic] = writer.add_connection(topic, kind, typestore=store)
            writer.write(connections[topic], time, store.serialize_cdr(value, kind))
    return path


def write_mcap(
    folder: Path, footage: Footage, *, compressed: bool = False, depth: bool = False
) -> Path:
    """By the library of MCAP itself, with packed chunks."""
    from mcap.writer import Writer

    folder.mkdir(parents=True, exist_ok=True)
    path, store = folder / "run.mcap", get_typestore(Stores.ROS2_HUMBLE)
    held = io.BytesIO()
    writer = Writer(held, chunk_size=64 * 1024)
    writer.start(profile="ros2")
    channels: dict[str, int] = {}
    for topic, time, value in messages_of(footage, store, compressed=compressed, depth=depth):
        kind = value.__msgtype__
        if topic not in channels:
            definition, _ = store.generate_msgdef(kind, ros_version=2)
            schema = writer.register_schema(kind, "ros2msg", definition.encode())
            channels[topic] = writer.register_channel(topic, "cdr", schema)
        data = bytes(store.serialize_cdr(value, kind))
        writer.add_message(channels[topic], time, data, time)
    writer.finish()
    path.write_bytes(held.getvalue())
    return path


def write_rosbag2_mcap(
    folder: Path, footage: Footage, *, compressed: bool = False, depth: bool = False
) -> Path:
    return write_rosbag2(
        folder, footage, storage=StoragePlugin.MCAP, compressed=compressed, depth=depth
    )


BAGS: dict[str, Callable[..., Path]] = {
    "rosbag 1": write_rosbag1,
    "rosbag 2": write_rosbag2,
    "rosbag 2 of MCAP": write_rosbag2_mcap,
    "MCAP": write_mcap,
}
FOLDERS: dict[str, Callable[..., Path]] = {
    "EuRoC": write_euroc,
    "KITTI": write_kitti,
    "OAK": write_oak,
    "OAK in a tar": write_oak_tar,
}

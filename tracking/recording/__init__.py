"""Recordings: frames by number, from every kind of source."""

from tracking.recording.cache import FrameCache
from tracking.recording.fingerprint import Fingerprint
from tracking.recording.frame import Image, StereoFrame
from tracking.recording.instants import Instants
from tracking.recording.manifest import (
    MANIFEST_NAME,
    TRUTH_NAME,
    Manifest,
    manifest_text,
    parse_manifest,
    read_manifest,
)
from tracking.recording.manifest_writer import format_manifest, write_manifest
from tracking.recording.options import OpenOptions
from tracking.recording.recording import Recording
from tracking.recording.recording_loader import open_from_manifest, open_recording

"""Scenes of walking people, rendered for two cameras with exact truth."""

from tracking.synthesis.disturbances import Disturbances
from tracking.synthesis.recording_writer import check_seconds, render_recording
from tracking.synthesis.scene import Scene
from tracking.synthesis.scenes import SCENES
from tracking.synthesis.specs import FloorSpec, LampSpec, SceneSpec, WallSpec
from tracking.synthesis.truth import SceneTruth, Surfaces

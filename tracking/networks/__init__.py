"""Networks that find people in pictures: read and run in a program of their own, with limits."""

from tracking.networks.model_file import Model, read_model
from tracking.networks.network_spec import NetworkSpec

__all__ = ["Model", "NetworkSpec", "read_model"]

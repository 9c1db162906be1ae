"""People tracked in recorded stereo footage, as a library: no Qt anywhere below."""

__version__ = "0.1.0"

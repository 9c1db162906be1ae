"""What every feature stands on: the document, playback, commands, jobs, scenes, shared widgets."""

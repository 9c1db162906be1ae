"""Keys and mouse actions that ground truth takes."""

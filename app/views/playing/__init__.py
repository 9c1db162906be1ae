"""Playing: frames fetched as they are due, and the line of buttons below the pictures."""

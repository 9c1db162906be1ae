"""From bare videos to metres in the window: minutes, actions, and how far the floor is off."""

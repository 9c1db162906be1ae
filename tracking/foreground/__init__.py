"""What is not background, and what of it is shadow."""

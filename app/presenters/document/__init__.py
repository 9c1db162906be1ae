"""An open recording with what is known of its people, and who is selected."""

"""Body parts drawn and plotted, and the failure detector that judges them."""

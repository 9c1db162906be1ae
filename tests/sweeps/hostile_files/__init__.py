"""Files and folders made to harm, by hand, each with the command that meets it."""

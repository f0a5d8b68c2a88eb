"""The interpreter of CGT templates: `run`."""

"""deburr: takes the burrs off parametric CNC code before it hurts somebody."""

__version__ = "0.1.0"

"""`python -m deburr`."""

import sys

from deburr.cli.main import main

if __name__ == "__main__":
    sys.exit(main())

"""`python -m deburr`."""

from deburr.cli.main import run

if __name__ == "__main__":
    run()

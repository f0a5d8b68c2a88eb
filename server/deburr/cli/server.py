"""`deburr server`: the language server, for one client."""

import argparse
import re

from deburr.cli.arguments import Parser
from deburr.cli.common import unable


def parser() -> argparse.ArgumentParser:
    """The command's options."""
    found = Parser(prog="deburr server", description="Run the language server.")
    ways = found.add_mutually_exclusive_group()
    ways.add_argument("--stdio", action="store_true", help="speak on standard input and output (default)")
    ways.add_argument(
        "--tcp", type=_address, metavar="HOST:PORT", help="wait for a client there; port 0: any that is free"
    )
    return found


def run(arguments: argparse.Namespace) -> int:
    """Serve until the client leaves."""
    from deburr.lsp.start import serve
    from deburr.lsp.stream import Stdio, Tcp

    if arguments.tcp is None:
        return serve(Stdio())
    host, port = arguments.tcp
    try:
        stream = Tcp(host, port)
    except OSError as error:
        return unable([f"{host}:{port}: {error.strerror or error}"])
    return serve(stream)


def _address(said: str) -> tuple[str, int]:
    match = re.fullmatch(r"(.*):([0-9]{1,5})", said, re.ASCII)
    if match is None or int(match[2]) > 65535:
        raise argparse.ArgumentTypeError(f"`{said}` is no HOST:PORT")
    return match[1].strip("[]") or "127.0.0.1", int(match[2])

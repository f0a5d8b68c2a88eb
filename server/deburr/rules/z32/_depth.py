"""How deep the parts of a line stand in each other."""

from collections.abc import Iterator

from deburr_grammar.tree import Node


def beyond(tree: Node, kinds: tuple[str, ...], limit: int) -> Iterator[Node]:
    """The outermost nodes of some kinds that stand in ``limit`` others of these kinds."""
    waiting = [(tree, 0)]
    while waiting:
        node, depth = waiting.pop()
        depth += node.kind in kinds
        if depth > limit:
            yield node
        else:
            waiting += [(child, depth) for child in reversed(list(node.nodes()))]

"""Nodes that outlive the graph they were made for: with the values that came last, what comes next is what it was. Knows no language."""

from __future__ import annotations

from deburr.values.graph import Calls, Env, Flows, Node, Proof, silent


def remembering(node: Node) -> Node:
    """The same node, with values that came last gone through only once. Of one that calls a routine the answer may have changed: not for those."""
    assert not node.calls
    last: Env | None = None
    flows: Flows = ()
    failed: Proof | None = None
    said: Proof | None = None

    def flow(env: Env, calls: Calls) -> Flows:
        nonlocal last, flows, failed, said
        if env is not last and env != last:
            failed = None
            try:
                flows = node.flow(env, calls)
            except Proof as proof:
                failed = proof
            said = node.remark()
            last = env
        if failed is not None:
            raise failed.with_traceback(None)
        return flows

    remark = silent if node.remark is silent else lambda: said
    return node._replace(flow=flow, remark=remark, change=None)

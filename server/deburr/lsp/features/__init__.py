"""One file a method family: it turns positions into lines and columns, asks `deburr.ide`, and turns the answer into the protocol's types."""

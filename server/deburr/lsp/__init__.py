"""The language server. Only this package knows pygls and lsprotocol."""

"""Tools of those who work on deburr. Nothing here runs when deburr is used."""

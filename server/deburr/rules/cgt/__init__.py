"""The rules of CGT templates."""

"""``python -m orthocut.cli``: the command line of the interpreter that is running."""

from orthocut.cli import app

if __name__ == "__main__":
    app()

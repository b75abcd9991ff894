"""What all verbs share: one clear line for a fault, pure JSON, a progress bar."""

from __future__ import annotations

import functools
import json
import math
import os
import sys
from collections.abc import Callable, Iterator, Sequence
from contextlib import contextmanager
from typing import Annotated, Any

import typer

from orthocut.params.block import ConfigError

FAILED, BAD_INPUT, INTERRUPTED = 1, 2, 130

Json = Annotated[bool, typer.Option("--json", help="Print one JSON object on stdout and nothing else.")]


def guarded(verb: Callable[..., None]) -> Callable[..., None]:
    """Turn errors into one line on stderr and an exit code."""

    @functools.wraps(verb)
    def wrapped(*args: Any, **options: Any) -> None:
        try:
            verb(*args, **options)
        except (typer.Exit, typer.Abort):
            raise
        except ConfigError as error:
            fail(str(error), BAD_INPUT)
        except BrokenPipeError:  # whoever read our output, such as `head`, has seen enough
            os.dup2(os.open(os.devnull, os.O_WRONLY), sys.stdout.fileno())
        except KeyboardInterrupt:
            fail("interrupted; no file is half-written", INTERRUPTED)
        except MemoryError:
            fail("the case is too large for the memory of this machine", FAILED)
        except (RuntimeError, OSError, FloatingPointError) as error:
            fail(" ".join(str(error).split()) or type(error).__name__, FAILED)

    return wrapped


def fail(message: str, code: int) -> None:
    """Print each line of a message as an error and exit."""
    for line in message.splitlines():
        typer.echo(f"error: {line}", err=True)
    raise typer.Exit(code)


def print_json(data: Any) -> None:
    """Print data as one JSON object; values that are not finite become null."""
    typer.echo(json.dumps(_plain(data), indent=2, ensure_ascii=False, allow_nan=False))


def _plain(data: Any) -> Any:
    if isinstance(data, dict):
        return {str(key): _plain(value) for key, value in data.items()}
    if isinstance(data, (list, tuple)):
        return [_plain(value) for value in data]
    data = data.item() if hasattr(data, "item") else data
    return None if isinstance(data, float) and not math.isfinite(data) else data


def parse_settings(texts: Sequence[str], kind: str) -> dict[str, Any]:
    """Fields and values of ``--set field=value``; values are YAML.

    Raises
    ------
    ConfigError
        If a text is no assignment, or a field is set twice under any of its names.
    """
    from orthocut.params.case import resolve
    from orthocut.params.text import parse_yaml

    values: dict[str, Any] = {}
    seen: dict[tuple[str, ...], str] = {}
    for text in texts:
        name, equals, value = text.partition("=")
        name = name.strip()
        if not equals or not name:
            raise ConfigError(f"--set {text!r}: must read field=value")
        path = resolve(kind, name, "--set")
        if path in seen:
            raise ConfigError(f"--set {text!r}: {'.'.join(path)} is already set by {seen[path]!r}")
        seen[path] = text
        values[".".join(path)] = parse_yaml(value, f"--set {name}")
    return values


@contextmanager
def progress_bar(words: str, quiet: bool) -> Iterator[Callable[[float], None]]:
    """Progress bar with the time left on stderr; nothing when quiet or when stderr is no terminal."""
    if quiet or not sys.stderr.isatty():
        yield lambda fraction: None
        return
    from rich.console import Console
    from rich.progress import BarColumn, Progress, TextColumn, TimeElapsedColumn, TimeRemainingColumn

    columns = (
        TextColumn("{task.description}"),
        BarColumn(),
        TextColumn("{task.percentage:>3.0f}%"),
        TimeElapsedColumn(),
        TextColumn("left"),
        TimeRemainingColumn(),
    )
    with Progress(*columns, console=Console(stderr=True), transient=True) as bar:
        task = bar.add_task(words, total=1.0)
        yield lambda fraction: bar.update(task, completed=fraction)

"""Read YAML as people mean it, and no more of YAML than studies need.

A number is a decimal number, with or without exponent; ``010``, ``1:30``, ``yes`` and dates are words. A field given
twice is a mistake. Tags are refused, and so is a text whose aliases stand for very much or for themselves.
"""

from __future__ import annotations

import re
import stat
from pathlib import Path
from typing import Annotated, Any, ClassVar

import yaml
from pydantic import AfterValidator, WithJsonSchema
from yaml.composer import Composer
from yaml.constructor import SafeConstructor
from yaml.cyaml import CParser
from yaml.nodes import MappingNode, Node, ScalarNode
from yaml.resolver import Resolver

from orthocut.params.block import ConfigError, fault, shorten

MAX_BYTES = 1_000_000
"""Largest file."""
MAX_DEPTH = 20
"""Most levels of lists and maps in one another, aliases followed; a case has four inside the six of a study."""
MAX_VALUES = 100_000
"""Most keys and values, aliases counted by what they stand for."""

_NAME = r"[A-Za-z][A-Za-z0-9_-]{0,63}"
_BINARY = re.compile(r"[\x00-\x08\x0b\x0c\x0e-\x1f\x7f]")


def _name(text: str) -> str:
    if not re.fullmatch(_NAME, text):
        raise fault("must be a name (allowed: a letter, then letters, digits, _ and -, 64 characters in all)")
    return text


def _line(text: str) -> str:
    if not 0 < len(text) <= 200 or not text.isprintable():
        raise fault("must be one line of words (allowed: 1 to 200 characters that can be printed)")
    return text


Name = Annotated[str, AfterValidator(_name), WithJsonSchema({"type": "string", "pattern": f"^{_NAME}$"})]
"""Word that is safe in file names and on terminals."""
Line = Annotated[str, AfterValidator(_line), WithJsonSchema({"type": "string", "minLength": 1, "maxLength": 200})]
"""One line for people."""


class _Loader(Composer, CParser, SafeConstructor, Resolver):
    """Loader of plain data that stops as soon as a text is too large, too deep or repeats a key.

    The parser is libyaml's, five times as fast as the one in Python; the tree is made here, node by node.
    """

    yaml_implicit_resolvers: ClassVar[dict[str, list[tuple[str, re.Pattern[str]]]]] = {}

    def __init__(self, text: str) -> None:
        CParser.__init__(self, text)
        Composer.__init__(self)
        SafeConstructor.__init__(self)
        Resolver.__init__(self)
        self._values = self._depth = self._deepest = 0
        self._open: set[str] = set()
        self._sizes: dict[str, tuple[int, int]] = {}

    def compose_node(self, parent: Node | None, index: Any) -> Node:
        """Build a node; complain about tags, aliases to themselves, too many values and too many levels."""
        event = self.peek_event()
        anchor, tag = event.anchor, getattr(event, "tag", None)
        if tag is not None:
            raise self._error(f"tag '{shorten(tag)}' is not allowed (allowed: plain values without tags)")
        self._depth += 1
        if isinstance(event, yaml.AliasEvent):
            if anchor in self._open:
                raise self._error(f"alias '*{shorten(anchor)}' stands for something that holds it")
            values, levels = self._sizes.get(anchor, (1, 0))
            self._grow(values, levels)
            node = super().compose_node(parent, index)
            self._depth -= 1
            return node

        before, outside = self._values, self._deepest
        self._deepest = self._depth
        self._grow(1, 0)
        if anchor is not None:
            self._open.add(anchor)
        node = super().compose_node(parent, index)
        if anchor is not None:
            self._open.discard(anchor)
            self._sizes[anchor] = self._values - before, self._deepest - self._depth
        self._deepest = max(self._deepest, outside)
        self._depth -= 1
        return node

    def compose_mapping_node(self, anchor: str | None) -> MappingNode:
        """Build a map; complain about a key that stands there twice or is no word."""
        node = super().compose_mapping_node(anchor)
        seen = set()
        for key, _ in node.value:
            if not isinstance(key, ScalarNode):
                raise yaml.MarkedYAMLError(None, None, "a name of a field must be a word", key.start_mark)
            if key.value in seen:
                raise yaml.MarkedYAMLError(None, None, f"field '{shorten(key.value)}' is given twice", key.start_mark)
            seen.add(key.value)
        return node

    def _grow(self, values: int, levels: int) -> None:
        self._values += values
        self._deepest = max(self._deepest, self._depth + levels)
        if self._values > MAX_VALUES:
            raise self._error(f"too many values, aliases counted in full (allowed: up to {MAX_VALUES})")
        if self._deepest > MAX_DEPTH:
            raise self._error(f"too many levels of lists and maps (allowed: up to {MAX_DEPTH})")

    def _error(self, problem: str) -> yaml.MarkedYAMLError:
        return yaml.MarkedYAMLError(None, None, problem, self.peek_event().start_mark)


for _tag, _form, _first in (
    ("null", r"~|null|Null|NULL|$", ["~", "n", "N", ""]),
    ("bool", r"true|True|TRUE|false|False|FALSE", list("tTfF")),
    ("int", r"[-+]?(0|[1-9][0-9]*)", list("-+0123456789")),
    ("float", r"[-+]?([0-9]+\.[0-9]*|\.[0-9]+|[0-9]+(?=[eE]))([eE][-+]?[0-9]+)?", list("-+.0123456789")),
    ("merge", "<<", ["<"]),
):
    _Loader.add_implicit_resolver(f"tag:yaml.org,2002:{_tag}", re.compile(rf"(?:{_form})\Z"), _first)


def parse_yaml(text: str, source: str) -> Any:
    """Content of a YAML text.

    Raises
    ------
    ConfigError
        If the text is not valid, or too large; names the line.
    """
    found = _BINARY.search(text)
    if found:
        line = text.count("\n", 0, found.start()) + 1
        raise ConfigError(f"{source}, line {line}: is not text (character {found[0]!r})")
    try:
        return yaml.load(text, Loader=_Loader)
    except yaml.MarkedYAMLError as error:
        mark = error.problem_mark or error.context_mark
        place = f", line {mark.line + 1}" if mark else ""
        raise ConfigError(f"{source}{place}: {shorten(error.problem or 'is not valid YAML', 200)}") from None
    except ValueError:
        raise ConfigError(f"{source}: a number has thousands of digits") from None
    except yaml.YAMLError as error:
        raise ConfigError(f"{source}: is not valid YAML: {shorten(' '.join(str(error).split()), 200)}") from None


def read_yaml(path: Path) -> Any:
    """Content of a YAML file; `ConfigError` names the file and the line when it cannot be read."""
    name = shorten(str(path), 200)
    try:
        if not stat.S_ISREG(path.stat().st_mode):
            raise ConfigError(f"{name}: cannot be read: is not a file")
        with path.open("rb") as file:
            content = file.read(MAX_BYTES + 1)
    except ConfigError:
        raise
    except OSError as error:
        raise ConfigError(f"{name}: cannot be read: {error.strerror}") from None
    except ValueError:
        raise ConfigError(f"{name!r}: cannot be read: is not the name of a file") from None
    if len(content) > MAX_BYTES:
        raise ConfigError(f"{name}: is too large (allowed: up to {MAX_BYTES // 1000} kB)")
    try:
        text = content.decode("utf-8-sig")
    except UnicodeDecodeError:
        raise ConfigError(f"{name}: cannot be read: is not text in UTF-8") from None
    return parse_yaml(text, name)

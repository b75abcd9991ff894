"""The page: one file, nothing to load, for screens, dark screens and paper."""

from __future__ import annotations

from pathlib import Path

from jinja2 import Environment, PackageLoader, StrictUndefined
from markupsafe import Markup, escape

from orthocut.io.files import write_text
from orthocut.report.content import Content

_ROW, _WIDE = 26, 860
_LEFT, _RIGHT = 300, 560


def write(content: Content, path: Path) -> None:
    """Write the page whole or not at all."""
    loader = PackageLoader("orthocut.report", "templates")
    environment = Environment(
        loader=loader, autoescape=True, undefined=StrictUndefined, trim_blocks=True, lstrip_blocks=True
    )
    template = environment.get_template("page.html.j2")
    write_text(
        template.render(content=content, dag=dag(content.links, {picture.anchor for picture in content.pictures})), path
    )


def dag(links: list[tuple[str, str, int]], drawn: set[str]) -> Markup:
    """Drawing of which sweeps go into which figures, as SVG; the numbers are cases.

    Parameters
    ----------
    links : list of (sweep, figure, number of cases)
    drawn : set of str
        Figures that the page shows; only their names are links.
    """
    sweeps = {sweep: count for sweep, _, count in links}
    figures = list(dict.fromkeys(figure for _, figure, _ in links))
    height = _ROW * (max(len(sweeps), len(figures), 1) + 1)

    def places(names: list[str]) -> dict[str, float]:
        step = height / (len(names) + 1)
        return {name: step * (index + 1) for index, name in enumerate(names)}

    left, right = places(list(sweeps)), places(figures)
    middle = (_LEFT + _RIGHT) / 2
    parts = [
        f'<path d="M{_LEFT} {left[sweep]:.0f} C{middle} {left[sweep]:.0f} {middle} {right[figure]:.0f} '
        f'{_RIGHT} {right[figure]:.0f}"/>'
        for sweep, figure, _ in links
    ]
    parts += [
        f'<text x="{_LEFT - 8}" y="{y + 4:.0f}" text-anchor="end">{escape(name)} ({sweeps[name]})</text>'
        for name, y in left.items()
    ]
    for name, y in right.items():
        text = f'<text x="{_RIGHT + 8}" y="{y + 4:.0f}">{escape(name)}</text>'
        parts.append(f'<a href="#{escape(name)}">{text}</a>' if name in drawn else text)
    label = "Sweeps on the left, with their numbers of cases, and the figures that draw them on the right"
    head = f'<svg class="dag" role="img" aria-label="{label}" viewBox="0 0 {_WIDE} {height}">'
    return Markup(head + "".join(parts) + "</svg>")

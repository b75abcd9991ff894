"""The report as a browser sees it: pictures load, links lead somewhere, nothing comes from elsewhere, no errors."""

import json
import re
import shutil
import subprocess

import pytest
from synthetic import dem_cut_run, make_case, mpm_run

from orthocut.figures.registry import draw, module, tabulate
from orthocut.figures.save import save
from orthocut.figures.tables import run_times, write
from orthocut.io.collect import collect
from orthocut.io.datasets import failed
from orthocut.io.store import Store
from orthocut.params.case import validate
from orthocut.report.content import gather
from orthocut.report.page import write as write_page

STUDY = """
title: A <study> & its "report"
sweeps:
  cuts: {base: {kind: mpm, numerics: {points_per_depth: 4}}, axes: {product: {cut_depth: [0.5 mm, 1 mm, 2 mm]}}}
  glass: {base: {kind: dem}}
figures: {nairn2015_fig08: [cuts], nairn2015_animation: [cuts], yang2018_table4: [glass]}
"""
PROBE = """
<script>
window.addEventListener("load", () => {
  const headings = [...document.querySelectorAll("h1,h2,h3")].map(h => Number(h.tagName[1]));
  document.title = "PROBE" + JSON.stringify({
    images: document.images.length,
    broken: [...document.images].filter(i => !i.naturalWidth).length,
    unnamed: [...document.images].filter(i => !i.alt).length,
    dead: [...document.querySelectorAll("a")].map(a => a.getAttribute("href"))
      .filter(h => !h.startsWith("#") || !document.getElementById(h.slice(1))),
    loaded: performance.getEntriesByType("resource").map(e => e.name).filter(n => !n.startsWith("data:")),
    jumps: headings.filter((h, k) => k && h > headings[k - 1] + 1).length,
    wide: document.documentElement.scrollWidth > window.innerWidth + 1,
    tables: document.querySelectorAll("table").length,
  });
});
</script>
"""


@pytest.fixture(scope="module")
def page(tmp_path_factory):
    """Return the report of a study with one failed case."""
    root = tmp_path_factory.mktemp("report")
    (root / "study.yaml").write_text(STUDY)
    store, results = Store(root / "results" / "store"), root / "results"
    runs = {
        "cuts": [mpm_run(snapshots=3, cut_depth=f"{h} mm") for h in (0.5, 1)],
        "glass": [dem_cut_run()],
    }
    for run in runs["cuts"] + runs["glass"]:
        store.put(validate(json.loads(run.attrs["case"])), run, 6, 1.0)
    case = make_case("mpm_cutting", cut_depth="2 mm", points_per_depth=4)
    hole = failed(case, "the chip <sinks> into the base", 1.0)
    store.put(case, hole, 0, 1.0)
    runs["cuts"].append(hole)
    for figure, sweep in (("nairn2015_fig08", "cuts"), ("nairn2015_animation", "cuts"), ("yang2018_table4", "glass")):
        dataset = collect(runs[sweep])
        save(draw(figure, dataset), results / "figures" / figure)
        if table := tabulate(figure, dataset):
            write(table, results / "tables" / figure)
    (results / "animations").mkdir()
    module("nairn2015_animation").animate(collect(runs["cuts"]), results / "animations" / "nairn2015_animation.gif")
    write(run_times(runs["cuts"] + runs["glass"], {}), results / "tables" / "run_times")
    claims = (
        "claim,source,paper value,ours,error,verdict,evidence\nforce rises,Fig. 8,1,2,0.1,reproduced,nairn2015_fig08\n"
    )
    (results / "tables" / "claims.csv").write_text(claims)
    write_page(gather(root / "study.yaml", results, results / "store"), results / "report.html")
    return results / "report.html"


@pytest.mark.parametrize("width", [1280, 400])
def test_a_browser_finds_nothing_wrong(page, tmp_path, width):
    browser = shutil.which("chromium")
    if browser is None:
        pytest.skip("chromium is not installed (Debian: chromium)")
    probed = tmp_path / "probed.html"
    probed.write_text(page.read_text(encoding="utf-8").replace("</body>", PROBE + "</body>"), encoding="utf-8")
    command = [
        browser, "--headless=new", "--no-sandbox", "--disable-gpu", "--no-first-run", "--disable-background-networking",
        "--disable-component-update", "--disable-sync", f"--user-data-dir={tmp_path / 'profile'}",
        f"--window-size={width},900", "--enable-logging=stderr", "--virtual-time-budget=10000", "--dump-dom",
        probed.as_uri(),
    ]  # fmt: skip
    done = subprocess.run(command, capture_output=True, text=True, timeout=120, check=True)
    found = json.loads(re.search(r"<title>PROBE(.*?)</title>", done.stdout).group(1))
    assert found["images"] == 3
    assert found["tables"] >= 4
    assert {name: found[name] for name in ("broken", "unnamed", "jumps")} == {"broken": 0, "unnamed": 0, "jumps": 0}
    assert found["dead"] == []
    assert found["loaded"] == []
    assert not found["wide"]
    assert "CONSOLE" not in done.stderr


def test_the_page_tells_what_happened(page):
    text = page.read_text(encoding="utf-8")
    assert "A &lt;study&gt; &amp; its" in text
    assert "2 done, 1 failed, 1 missing" in text
    assert "the chip &lt;sinks&gt; into the base" in text
    assert "force rises" in text
    assert "data:image/gif;base64," in text
    assert "http://" not in text.replace("http://www.w3.org", "")
    assert page.stat().st_size < 20e6


def test_what_is_not_there_is_left_out(tmp_path):
    (tmp_path / "study.yaml").write_text(STUDY)
    write_page(gather(tmp_path / "study.yaml", tmp_path, tmp_path / "store"), tmp_path / "report.html")
    assert "0 done, 0 failed, 4 missing" in (tmp_path / "report.html").read_text(encoding="utf-8")

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
from orthocut.report import content
from orthocut.report.content import gather
from orthocut.report.page import write as write_page

STUDY = """
title: A <study> & its "report"
sweeps:
  cuts: {base: {kind: mpm, numerics: {points_per_depth: 4}}, axes: {product: {cut_depth: [0.5 mm, 1 mm, 2 mm]}}}
  glass: {base: {kind: dem}}
figures:
  nairn2015_fig08: [cuts]
  nairn2015_fig10: [cuts] # was not drawn
  nairn2015_animation: [cuts]
  yang2018_table4: [glass]
"""
PROBE = """
<script>
window.addEventListener("load", () => {
  const ids = [...document.querySelectorAll("[id]")].map(e => e.id);
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
    twins: ids.length - new Set(ids).size,
    width: window.innerWidth,
  });
  window.parent.postMessage(document.title, "*");
});
</script>
"""


FRAME = """<!DOCTYPE html><html><head><link rel="icon" href="data:,"></head><body>
<script>window.addEventListener("message", event => {{ document.title = event.data; }});</script>
<iframe src="probed.html" width="{width}" height="900" style="border: 0"></iframe></body></html>
"""
"""The page in a window of any width; those of a headless browser have a least width."""


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
        store.put(validate(json.loads(run.attrs["case"])), run, 6)
    case = make_case("mpm_cutting", cut_depth="2 mm", points_per_depth=4)
    hole = failed(case, "the chip <sinks> into the base", 1.0)
    store.put(case, hole, 0)
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
    (results / "tables" / "nairn2015_claims.csv").write_text(claims.replace("rises", "falls"))
    for paper, claim in (("nairn2015", "a,nairn2015_fig08"), ("yang2018", "b,nairn2015_fig080")):
        (results / "published" / paper).mkdir(parents=True)
        (results / "published" / paper / "claims.csv").write_text(f"a claim,figure\n{claim}\n")
    (results / "tables" / "nairn2015_animation.csv").write_text("")
    for folder, number in (("published/benchmarks", 7), ("benchmarks", 8)):
        (results / folder).mkdir(parents=True)
        (results / folder / "roofline.csv").write_text(f"bound,share\nnew or old,{number} %\n")
    shutil.copy(results / "figures" / "nairn2015_fig08.png", results / "published" / "benchmarks" / "roofline.png")
    (results / "published" / "benchmarks" / "scenes.csv").write_text("scene\n" + "a long table\n" * 200)
    write_page(gather(root / "study.yaml", results, results / "store"), results / "report.html")
    return results / "report.html"


@pytest.mark.parametrize("width", [1280, 400])
def test_a_browser_finds_nothing_wrong(page, tmp_path, width):
    browser = shutil.which("chromium")
    if browser is None:
        pytest.skip("chromium is not installed (Debian: chromium)")
    probed = tmp_path / "probed.html"
    probed.write_text(page.read_text(encoding="utf-8").replace("</body>", PROBE + "</body>"), encoding="utf-8")
    framed = tmp_path / "framed.html"
    framed.write_text(FRAME.format(width=width), encoding="utf-8")
    command = [
        browser, "--headless=new", "--no-sandbox", "--disable-gpu", "--no-first-run", "--disable-background-networking",
        "--disable-component-update", "--disable-sync", f"--user-data-dir={tmp_path / 'profile'}",
        "--window-size=1400,1000", "--enable-logging=stderr", "--virtual-time-budget=10000", "--dump-dom",
        framed.as_uri(),
    ]  # fmt: skip
    done = subprocess.run(command, capture_output=True, text=True, timeout=120, check=True)
    found = json.loads(re.search(r"<title>PROBE(.*?)</title>", done.stdout).group(1))
    assert found["width"] == width
    assert found["images"] == 4
    assert found["twins"] == 0
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


def test_benchmarks_stand_there_new_ones_in_place_of_published_ones(page):
    text = page.read_text(encoding="utf-8")
    section = text.split('id="benchmark-roofline"')[1].split("</section>")[0]
    assert "What bounds a step" in section
    assert "data:image/png;base64," in section
    assert "<td>8 %</td>" in section
    assert "7 %" not in section
    assert "a long table" not in text


def test_what_is_not_there_is_left_out(tmp_path):
    (tmp_path / "study.yaml").write_text(STUDY)
    write_page(gather(tmp_path / "study.yaml", tmp_path, tmp_path / "store"), tmp_path / "report.html")
    assert "0 done, 0 failed, 4 missing" in (tmp_path / "report.html").read_text(encoding="utf-8")


def test_claims_stand_at_their_figures_with_their_own_header(page):
    text = page.read_text(encoding="utf-8")
    assert text.count('<th scope="col">a claim</th>') == 3  # at fig08 and in both tables of all claims
    for anchor in ("nairn2015_fig08-claims-nairn2015", "claims-nairn2015", "claims-yang2018", "table-claims"):
        assert text.count(f'id="{anchor}"') == 1
    assert "nairn2015_fig08-claims-yang2018" not in text


def test_claims_of_a_paper_that_a_study_judged_stand_there_too(page):
    text = page.read_text(encoding="utf-8")
    assert text.count("force falls") == 2  # at fig08 and in the table of all claims
    assert text.count('id="table-nairn2015_claims"') == 1
    assert "Claims, Nairn (2015)" in text


@pytest.mark.parametrize(
    ("name", "title"),
    [
        ("fig03b", "Fig. 3B"),
        ("fig10", "Fig. 10"),
        ("table4", "Table 4"),
        ("figures", "figures"),
        ("regimes", "regimes"),
    ],
)
def test_titles_of_figures(name, title):
    assert content._words(name) == title


def test_origins_and_run_times_are_those_of_the_results(page):
    text = page.read_text(encoding="utf-8")
    origins = text.split('id="origins"')[1].split("</table>")[0]
    assert sum(map(int, re.findall(r"<tr><td>(\d+)</td>", origins))) == 3
    times = text.split('id="times-by-kind"')[1].split("</table>")[0]
    assert re.findall(r"<tr><td>(\w+)</td><td>(\d+)</td>", times) == [("dem_cutting", "0"), ("mpm_cutting", "3")]

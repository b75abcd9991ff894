"""``orthocut store``: look after the results."""

from __future__ import annotations

from contextlib import nullcontext
from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer

from orthocut.cli.common import FAILED, Json, guarded, print_json
from orthocut.cli.study import CONFIG, study_path
from orthocut.params.block import ConfigError

if TYPE_CHECKING:
    from orthocut.io.store import Store
    from orthocut.params.case import Case

app = typer.Typer(
    help="Look after the results: check, list, clean up, carry to another place.",
    no_args_is_help=True,
    context_settings={"help_option_names": ["-h", "--help"]},
)
Root = Annotated[Path, typer.Option("--store", help="Folder of the results.")]
DEFAULT = Path("results/store")
Studies = Annotated[
    list[str] | None, typer.Option("--study", help="Only cases of this study, from these sources. Repeatable.")
]
DryRun = Annotated[bool, typer.Option("--dry-run", "-n", help="Say what would happen, change nothing.")]


def _open(root: Path) -> Store:
    from orthocut.io.store import Store

    if not root.is_dir():
        raise ConfigError(f"--store {root}: is not a folder (allowed: the folder of a store)")
    return Store(root)


def _cases(studies: list[str]) -> list[Case]:
    """Cases of studies."""
    from orthocut.params.study import load_study

    found = (load_study(study_path(Path(name))).cases(name) for name in studies)
    return [case for sweeps in found for members in sweeps.values() for case in members.values()]


def _wanted(cases: list[Case]) -> set[str]:
    """Names of the results of cases, from these sources."""
    from orthocut.params.identity import result_key

    return {result_key(case) for case in cases}


def _old_packings(root: Path, cases: list[Case]) -> list[Path]:
    """Packings beside the results that none of the cases is made of."""
    from orthocut.experiments.packing_shelf import FOLDER, shelf_path

    wanted = {shelf_path(root / FOLDER, case.packing) for case in cases if hasattr(case, "packing")}
    return sorted(path for path in (root / FOLDER).glob("packing-*.npy") if path not in wanted)


def _chosen(store: Store, studies: list[str] | None) -> list[str]:
    wanted = _wanted(_cases(studies)) if studies else None
    return [key for key in store.names() if wanted is None or key in wanted]


@app.command("verify", epilog="Example:\n\northocut store verify")
@guarded
def verify(root: Root = DEFAULT, as_json: Json = False) -> None:
    """Check the checksum of every file; name and set aside what is broken. Exit code 1 if anything was."""
    import warnings

    from orthocut.io.store import SNAPSHOTS

    store = _open(root)
    keys = store.names()
    keys += [path.name.removesuffix(SNAPSHOTS) for path in root.glob(f"*{SNAPSHOTS}")]
    with warnings.catch_warnings(record=True) as found:
        warnings.simplefilter("always")
        for key in sorted(set(keys)):
            store.entry(key)
            store.snapshots(key)
    broken = [str(warning.message) for warning in found]
    if as_json:
        print_json({"checked": len(set(keys)), "broken": broken})
    else:
        typer.echo(f"{len(set(keys))} results checked, {len(broken)} files broken")
        for line in broken:
            typer.echo(f"error: {line}", err=True)
    if broken:
        raise typer.Exit(FAILED)


@app.command("list", epilog="Example:\n\northocut store list --study quick")
@guarded
def list_results(root: Root = DEFAULT, studies: Studies = None, as_json: Json = False) -> None:
    """List the results: state, run time, size, and why a case failed."""
    store = _open(root)
    rows = []
    for key in _chosen(store, studies):
        entry = store.entry(key)
        if entry is not None:
            size = sum(path.stat().st_size for path in root.glob(f"{key}.*nc"))
            rows.append({**entry._asdict(), "bytes": size})
    if as_json:
        print_json({"results": rows})
        return
    for row in rows:
        typer.echo(f"{row['status']:<7} {row['seconds']:>8.1f} s {row['bytes'] / 1e3:>8.1f} kB  {row['key']}")
        if row["reason"]:
            typer.echo(f"        {row['reason']}")
    typer.echo(f"{len(rows)} results, {sum(row['bytes'] for row in rows) / 1e6:.1f} MB", err=True)


@app.command("retry", epilog="Example:\n\northocut store retry --study quick")
@guarded
def retry(root: Root = DEFAULT, studies: Studies = None) -> None:
    """Set failed results aside, so that the next run of the workflow simulates their cases again."""
    store = _open(root)
    found = [key for key in _chosen(store, studies) if store.retry(key)]
    for key in found:
        typer.echo(key)
    typer.echo(f"{len(found)} failed results set aside", err=True)


@app.command("gc", epilog="Example:\n\northocut store gc --dry-run")
@guarded
def collect_garbage(
    root: Root = DEFAULT,
    studies: Annotated[
        list[str] | None,
        typer.Option("--study", help=f"Keep what this study wants. Repeatable; default: all studies in {CONFIG}."),
    ] = None,
    dry_run: DryRun = False,
) -> None:
    """Remove results and packings that no study wants or that other sources made, and what killed processes left.

    Results of calibrations go too: no study lists them. Refused while a workflow uses the store.
    """
    from orthocut.io.files import held
    from orthocut.io.store import IN_USE, SNAPSHOTS, SUFFIX

    store = _open(root)
    names = studies or [str(path) for path in sorted(CONFIG.glob("*.yaml")) if path.name != "default.yaml"]
    if not names:
        raise ConfigError(f"{CONFIG}: holds no studies, so that nothing would be kept (allowed: --study STUDY.yaml)")
    cases = _cases(names)
    wanted = _wanted(cases)
    doomed = [store.path(key, suffix) for key in store.names() if key not in wanted for suffix in (SUFFIX, SNAPSHOTS)]
    doomed = [path for path in doomed if path.exists()] + list(store.remains())
    doomed += _old_packings(root, cases)
    try:
        with nullcontext() if dry_run else held(root / IN_USE):
            for path in doomed:
                typer.echo(str(path))
                if dry_run:
                    continue
                if path.is_dir():
                    path.rmdir()
                else:
                    path.unlink(missing_ok=True)
    except BlockingIOError as error:
        raise ConfigError(f"--store {root}: {error.strerror} (allowed: when that has ended)") from None
    typer.echo(f"{len(doomed)} files {'would be ' if dry_run else ''}removed", err=True)


@app.command("export", epilog="Example:\n\northocut store export quick.tar --study quick")
@guarded
def export(
    target: Annotated[Path, typer.Argument(help="Folder, or archive that ends in .tar, .tar.gz or .tgz.")],
    root: Root = DEFAULT,
    studies: Studies = None,
    snapshots: Annotated[bool, typer.Option(help="Also snapshots, where there are any.")] = True,
) -> None:
    """Copy results, checked, to a folder or an archive."""
    from orthocut.io.transfer import export_results

    store = _open(root)
    done = export_results(store, _chosen(store, studies), target, snapshots)
    _tell(done, "exported")


@app.command("import", epilog="Example:\n\northocut store import results/published/store")
@guarded
def import_(
    source: Annotated[Path, typer.Argument(help="Folder or archive that `orthocut store export` made.")],
    root: Root = DEFAULT,
) -> None:
    """Copy results, checked, into the store; what is there stays. Figures are then drawn without simulations."""
    import tarfile
    import zlib

    from orthocut.io.store import Store
    from orthocut.io.transfer import ARCHIVES, import_results, is_archive

    if not source.exists():
        raise ConfigError(f"{source}: cannot be read: no such file or folder")
    if not source.is_dir() and not is_archive(source):
        raise ConfigError(f"{source}: is not what `export` makes (allowed: a folder, or {', '.join(ARCHIVES)})")
    try:
        done = import_results(source, Store(root))
    except (tarfile.TarError, EOFError, zlib.error) as error:
        raise ConfigError(f"{source}: is not an archive of results: {error}") from None
    _tell(done, "imported")


def _tell(done: tuple[list[str], ...], verb: str) -> None:
    copied, present, broken = done
    for name in broken:
        typer.echo(f"error: {name} is broken and was left out", err=True)
    typer.echo(f"{len(copied)} files {verb}, {len(present)} were there already, {len(broken)} broken")
    if broken:
        raise typer.Exit(FAILED)

#!/usr/bin/env python3
"""Puts measured numbers into docs/results.md; ./dev results measures them first.

Usage: docs/update_results.py REPORTS [PAGE]

REPORTS is a folder of folders that mres compare and mres bench wrote. Each block of the page that begins with
`<!-- begin KIND NAME -->` and ends with `<!-- end -->` is written anew from REPORTS/NAME and nothing else, KIND being
machine, table, summary, truth, stages, plots, pareto or variants; plots go to results/NAME beside the page, and variants are the
folders below NAME, each with a report. Blocks of reports that are not there stay, and so does the text around them.
"""
import json
import pathlib
import re
import shutil
import statistics
import sys

PAGE = pathlib.Path(__file__).resolve().parent / "results.md"
BLOCK = re.compile(r"(<!-- begin (\w+) ([\w-]+) -->\n).*?(<!-- end -->)", re.DOTALL)


def read_report(folder):
    for name in ("report.json", "results.json"):
        if (folder / name).exists():
            return json.loads((folder / name).read_text())
    return None


def read_variants(folder):
    """The reports of the folders below, by name."""
    variants = {entry.name: read_report(entry) for entry in sorted(folder.glob("*/"))}
    return {name: report for name, report in variants.items() if report}


def markdown(rows):
    alignment = [":--"] + ["--:"] * (len(rows[0]) - 1)
    return "".join("| " + " | ".join(row) + " |\n" for row in [rows[0], alignment, *rows[1:]])


def field(result, path):
    """None where anything on the way is."""
    for name in path:
        result = None if result is None else result.get(name)
    return result


def cell(value, form):
    return "–" if value is None else form.format(value)


def overall(figure, values):
    """`figure`, such as max, of the values that there are."""
    known = [value for value in values if value is not None]
    return figure(known) if known else None


def grouped(items, key):
    """Lists of items by their key, sorted by it."""
    groups = {}
    for item in items:
        groups.setdefault(key(item), []).append(item)
    return sorted(groups.items())


def work(result):
    return result["effect"], result["samples"], result["width"], result["height"]


def work_title(effect, samples, width, height):
    return f"{effect} {samples}, {width}×{height}"


def machine(report, _folder, _page):
    device = report["machine"]
    parts = [device["renderer"], device["version"], f"{device['cores']} cores"]
    if report.get("commit"):
        parts.append(f"commit {report['commit']}")
    if report.get("date"):
        parts.append(report["date"])
    seconds = sum(r.get("seconds", 0.0) for r in report["results"])
    if seconds > 0:
        minutes = max(round(seconds / 60), 1)
        parts.append(f"{len(report['results'])} pictures in {minutes} minute{'s' if minutes > 1 else ''}")
    return ", ".join(parts) + ".\n"


def table(report, _folder, _page):
    figures = (
        ("full, ms", ("reference_time_ms", "median"), "{:.0f}"),
        ("mres, ms", ("time_ms", "median"), "{:.0f}"),
        ("speedup", ("speedup",), "{:.2f}"),
        ("efficiency", ("efficiency",), "{:.2f}"),
        ("RMS", ("error", "rms"), "{:.4f}"),
        ("max", ("error", "max"), "{:.3f}"),
        ("PSNR, dB", ("error", "psnr"), "{:.1f}"),
        ("SSIM", ("error", "ssim"), "{:.4f}"),
    )
    results = report["results"]
    rows = [["view, size, effect, samples"] + [title for title, _, _ in figures] + ["coverage, %, fine to coarse"]]
    for r in results:
        view = f"{r['scene']} {r['camera']} ({r['camera_name']}), {r['width']}×{r['height']}, {r['effect']} {r['samples']}"
        coverage = " ".join(f"{share * 100:.0f}" for share in r["coverage"])
        rows.append([view] + [cell(field(r, path), form) for _, path, form in figures] + [coverage])
    if len({(r["scene"], *work(r)) for r in results}) == 1 < len(results):
        means = [cell(overall(statistics.mean, (field(r, path) for r in results)), form) for _, path, form in figures]
        rows.append(["**mean**"] + [f"**{mean}**" for mean in means] + [""])
    return markdown(rows)


def summary(report, _folder, _page):
    rows = [["effect, samples, size", "views", "speedup", "least", "greatest", "efficiency", "RMS", "greatest"]]
    for key, results in grouped(report["results"], work):
        speedups = [field(r, ("speedup",)) for r in results]
        efficiencies = [field(r, ("efficiency",)) for r in results]
        errors = [field(r, ("error", "rms")) for r in results]
        rows.append([work_title(*key), str(len(results))]
                    + [cell(overall(figure, speedups), "{:.2f}") for figure in (statistics.mean, min, max)]
                    + [cell(overall(statistics.mean, efficiencies), "{:.2f}")]
                    + [cell(overall(figure, errors), "{:.4f}") for figure in (statistics.mean, max)])
    return markdown(rows)


def truth_title(name, errors):
    unit = "rays" if "rays" in errors else "samples"
    return f"{name.replace('_', ' ')}, {errors[unit]} {unit}"


def truth(report, _folder, _page):
    pictures = [(*work(r), truth_title(name, errors), errors)
                for r in report["results"] for name, errors in (r.get("truth") or {}).items()]
    rows = [["effect, samples, size", "truth", "views", "full RMS", "mres RMS", "more"]]
    for (*key, title), group in grouped(pictures, lambda picture: picture[:-1]):
        full, mres = (statistics.mean(errors[name] for *_, errors in group) for name in ("reference_rms", "rms"))
        more = (mres / full - 1) * 100 if full > 0 else None
        rows.append([work_title(*key), title, str(len(group)), f"{full:.4f}", f"{mres:.4f}", cell(more, "{:+.1f} %")])
    return markdown(rows)


def variants(reports, folder, page):
    """One row a report, all of one commit."""
    if len({report.get("commit") for report in reports.values()}) > 1:
        sys.exit(f"update_results: the reports below '{folder}' are of several commits; remove the folder and measure anew.")
    rows = [["effect, variant", "views", "speedup", "work", "RMS", "greatest"]]
    for name, report in reports.items():
        effect, *words = name.split("-")
        results = report["results"]
        errors = [field(r, ("error", "rms")) for r in results]
        means = [("speedup", "{:.2f}"), ("work", "{:.3f}")]
        rows.append([f"{effect}, {' '.join(words)}" if words else effect, str(len(results))]
                    + [cell(overall(statistics.mean, [field(r, (name,)) for r in results]), form) for name, form in means]
                    + [cell(overall(figure, errors), "{:.4f}") for figure in (statistics.mean, max)])
    return machine(next(iter(reports.values())) | {"results": []}, folder, page) + "\n" + markdown(rows)


def stages(report, _folder, _page):
    results = report["results"]
    names = list(dict.fromkeys(name for r in results for name in r["stages_ms"]))
    means = {name: statistics.mean(r["stages_ms"].get(name, 0.0) for r in results) for name in names}
    total = sum(means.values())
    rows = [["stage", "ms", "share"]]
    rows += [[name, f"{mean:.1f}", f"{mean / total * 100:.0f} %"] for name, mean in means.items()]
    return markdown(rows)


def pareto(_report, folder, _page):
    """The tables that mres bench wrote, where it measured several techniques."""
    tables = folder / "pareto.md"
    return tables.read_text() if tables.exists() else None


def plots(_report, folder, page):
    drawn = sorted((folder / "plots").glob("*.svg"))
    if not drawn:
        return None  # without gnuplot, those on the page stay
    target = page.parent / "results" / folder.name
    shutil.rmtree(target, ignore_errors=True)
    target.mkdir(parents=True)
    lines = []
    for plot in drawn:
        shutil.copyfile(plot, target / plot.name)
        lines.append(f"![{plot.stem.replace('-', ' ')}](results/{folder.name}/{plot.name})\n")
    return "\n".join(lines)


KINDS = {function.__name__: function for function in (machine, table, summary, truth, stages, plots, pareto, variants)}


def update(reports, page):
    def block(match):
        begin, kind, name, end = match.groups()
        folder = reports / name
        report = read_variants(folder) if kind == "variants" else read_report(folder)
        text = KINDS[kind](report, folder, page) if report else None
        return match[0] if text is None else f"{begin}\n{text}\n{end}"

    page.write_text(BLOCK.sub(block, page.read_text()))


def main():
    if not 2 <= len(sys.argv) <= 3:
        sys.exit(__doc__)
    reports = pathlib.Path(sys.argv[1])
    if not any(reports.glob("*/*.json")):
        sys.exit(f"update_results: there are no reports below '{reports}'; ./dev results makes them.")
    update(reports, pathlib.Path(sys.argv[2]) if len(sys.argv) == 3 else PAGE)


if __name__ == "__main__":
    main()

#!/usr/bin/env python3
"""Puts measured numbers into docs/results.md; ./dev results measures them first.

Usage: docs/update_results.py REPORTS

REPORTS is a folder of folders that mres compare and mres bench wrote. Each block of the page that begins with
`<!-- begin KIND NAME -->` and ends with `<!-- end -->` is written anew from REPORTS/NAME and nothing else, KIND being
machine, table, summary, stages or plots. Blocks of reports that are not there stay, and so does the text around them.
"""
import json
import pathlib
import re
import shutil
import statistics
import sys

DOCS = pathlib.Path(__file__).resolve().parent
PAGE = DOCS / "results.md"
BLOCK = re.compile(r"(<!-- begin (\w+) ([\w-]+) -->\n).*?(<!-- end -->)", re.DOTALL)


def read_report(folder):
    for name in ("report.json", "results.json"):
        if (folder / name).exists():
            return json.loads((folder / name).read_text())
    return None


def markdown(rows):
    alignment = [":--"] + ["--:"] * (len(rows[0]) - 1)
    return "".join("| " + " | ".join(row) + " |\n" for row in [rows[0], alignment, *rows[1:]])


def machine(report, _folder):
    device = report["machine"]
    return f"{device['renderer']}, {device['version']}, {device['cores']} cores.\n"


def table(report, _folder):
    figures = (
        ("full, ms", lambda r: r["reference_time_ms"]["median"], "{:.0f}"),
        ("mres, ms", lambda r: r["time_ms"]["median"], "{:.0f}"),
        ("speedup", lambda r: r["speedup"], "{:.2f}"),
        ("RMS", lambda r: r["error"]["rms"], "{:.4f}"),
        ("max", lambda r: r["error"]["max"], "{:.3f}"),
        ("PSNR, dB", lambda r: r["error"]["psnr"], "{:.1f}"),
        ("SSIM", lambda r: r["error"]["ssim"], "{:.4f}"),
    )
    results = report["results"]
    rows = [["view, size, effect, samples"] + [title for title, _, _ in figures] + ["coverage, %, fine to coarse"]]
    for r in results:
        view = f"{r['scene']} {r['camera']} ({r['camera_name']}), {r['width']}×{r['height']}, {r['effect']} {r['samples']}"
        coverage = " ".join(f"{share * 100:.0f}" for share in r["coverage"])
        rows.append([view] + [form.format(get(r)) for _, get, form in figures] + [coverage])
    if len({(r["scene"], r["width"], r["effect"], r["samples"]) for r in results}) == 1 < len(results):
        means = [form.format(statistics.mean(get(r) for r in results)) for _, get, form in figures]
        rows.append(["**mean**"] + [f"**{mean}**" for mean in means] + [""])
    return markdown(rows)


def summary(report, _folder):
    groups = {}
    for r in report["results"]:
        groups.setdefault((r["effect"], r["samples"], r["width"], r["height"]), []).append(r)
    rows = [["effect, samples, size", "views", "speedup", "least", "greatest", "RMS", "greatest"]]
    for (effect, samples, width, height), group in sorted(groups.items()):
        speedups = [r["speedup"] for r in group]
        errors = [r["error"]["rms"] for r in group]
        rows.append([f"{effect} {samples}, {width}×{height}", str(len(group))]
                    + [f"{f(speedups):.2f}" for f in (statistics.mean, min, max)]
                    + [f"{f(errors):.4f}" for f in (statistics.mean, max)])
    return markdown(rows)


def stages(report, _folder):
    results = report["results"]
    names = list(dict.fromkeys(name for r in results for name in r["stages_ms"]))
    means = {name: statistics.mean(r["stages_ms"].get(name, 0.0) for r in results) for name in names}
    total = sum(means.values())
    rows = [["stage", "ms", "share"]]
    rows += [[name, f"{mean:.1f}", f"{mean / total * 100:.0f} %"] for name, mean in means.items()]
    return markdown(rows)


def plots(_report, folder):
    target = DOCS / "results"
    target.mkdir(exist_ok=True)
    lines = []
    for plot in sorted((folder / "plots").glob("*.svg")):
        shutil.copyfile(plot, target / plot.name)
        lines.append(f"![{plot.stem.replace('-', ' ')}](results/{plot.name})\n")
    return "\n".join(lines)


KINDS = {"machine": machine, "table": table, "summary": summary, "stages": stages, "plots": plots}


def main():
    if len(sys.argv) != 2:
        sys.exit(__doc__)
    reports = pathlib.Path(sys.argv[1])
    if not any(reports.glob("*/*.json")):
        sys.exit(f"update_results: there are no reports below '{reports}'; ./dev results makes them.")

    def block(match):
        folder = reports / match[3]
        report = read_report(folder)
        return match[1] + "\n" + KINDS[match[2]](report, folder) + "\n" + match[4] if report else match[0]

    PAGE.write_text(BLOCK.sub(block, PAGE.read_text()))


if __name__ == "__main__":
    main()

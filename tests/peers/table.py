"""The table that ./dev peers ends with."""

HEADING = ["", "pass ms", "frame without", "with", "gain", "contrast", "RMSE", "block 99 %", "max",
           "to full: RMSE", "block 99 %", "max"]


def cells(result):
    frames = result.get("frame_ms")
    errors = [result.get(kind, {}).get(figure) for kind in ("error_to_converged", "error_to_full")
              for figure in ("rms", "block_p99", "block_max")]
    yield result["name"]
    yield f"{result['time_ms']['median']:.1f}"
    yield from (f"{frames[way]['median']:.1f}" if frames else "" for way in ("without", "with"))
    yield f"{result['gain']:.2f}x" if "gain" in result else ""
    yield from ("" if value is None else f"{value:.4f}" for value in [result["contrast"], *errors])


def text_of(results):
    rows = [HEADING, *(list(cells(result)) for result in results)]
    widths = [max(map(len, column)) for column in zip(*rows)]
    return "\n".join("  ".join([row[0].ljust(widths[0]), *map(str.rjust, row[1:], widths[1:])]).rstrip() for row in rows)

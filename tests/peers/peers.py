#!/usr/bin/python3
"""Measures what others would use instead of mres: VTK's vtkSSAOPass and n8ao, on the same scene and rasteriser.

Usage: tests/peers/peers.py [SCENE [SIZE]] [OPTION...]     by ./dev peers, which installs what it needs

Each peer is a program that takes a request (a JSON file: scene, width, height, radius, runs, warm_up, renderer, chromium)
and a folder, and leaves there a result.json of frames' times and pictures' files, and the pictures (measures.py). mres
exports the scene and the camera for them, and is measured by its own `mres compare`.
"""
import argparse
import json
import os
import pathlib
import shutil
import subprocess
import sys
import tempfile

import numpy
import OpenImageIO

sys.dont_write_bytecode = True
import measures  # noqa: E402: without leaving a folder in the sources
import table  # noqa: E402

ROOT = pathlib.Path(__file__).resolve().parents[2]
MRES = ROOT / "build/release/mres"
PEERS = {
    # VTK opens windows, which needs a display.
    "vtk": ["xvfb-run", "--auto-servernum", "/usr/bin/python3", str(ROOT / "tests/peers/vtk/vtk_ssao.py")],
    "n8ao": ["node", str(ROOT / "build/peers/n8ao/run.js")],
}
# For all: Mesa's software rasteriser, also where there is a GPU.
RENDERER = "llvmpipe"
ENVIRONMENT = os.environ | {"LIBGL_ALWAYS_SOFTWARE": "1", "GALLIUM_DRIVER": RENDERER}
WARM_UP = 2


def arguments():
    parser = argparse.ArgumentParser(prog="./dev peers", description="Measures vtkSSAOPass and n8ao beside mres.")
    parser.add_argument("scene", nargs="?", default="hall", help="a built-in scene, a .gltf or a .glb file (%(default)s)")
    parser.add_argument("size", nargs="?", default="1920x1080", help="as of mres compare (%(default)s)")
    parser.add_argument("--camera", default="0", metavar="N", help="of the scene, from 0 on (%(default)s)")
    parser.add_argument("--radius", default=0.5, type=float, metavar="METRES", help="reach of the occlusion (%(default)s)")
    parser.add_argument("--runs", default=15, type=int, metavar="N", help="timed pairs of frames (%(default)s)")
    parser.add_argument("-o", "--output", default="out/peers", type=pathlib.Path, metavar="DIR", help="(%(default)s)")
    options = parser.parse_args()
    if options.runs < 1 or not 0 < options.radius <= 100:
        parser.error("give at least one run, and a radius above 0 and up to 100 metres")
    if options.camera == "all":
        parser.error("the peers draw one picture; give --camera a number")
    return options


def run(name, command):
    """Its messages go to our own standard error; ends with a sentence if it fails."""
    print(f"peers: {name} ...", file=sys.stderr, flush=True)
    try:
        status = subprocess.run(command, env=ENVIRONMENT, stdout=subprocess.DEVNULL).returncode
    except FileNotFoundError as missing:
        sys.exit(f"peers: '{missing.filename}' is not installed; run ./dev peers, which installs what is missing.")
    if status != 0:
        sys.exit(f"peers: {name} failed, see above; nothing was written.")


def measure_mres(options, folder):
    """The report's one result, which knows the size in pixels."""
    run("mres", [MRES, "compare", options.scene, "--camera", options.camera, "--size", options.size, "--effect", "ssao",
                 "--set", f"radius={options.radius}", "--truth", "--repeat", str(options.runs), "-o", folder])
    report = json.loads((folder / "report.json").read_text())
    renderer = report["machine"]["renderer"]
    if RENDERER not in renderer:
        sys.exit(f"peers: mres draws with '{renderer}', not with {RENDERER}; install libgl1-mesa-dri.")
    return report


def results_of_mres(report, folder):
    result = report["results"][0]
    # Its converged picture is known at a part of the pixels only.
    contrast = float(OpenImageIO.ImageBuf(str(folder / "effect_full.exr")).get_pixels().std())
    full, mres = ({"name": name, "samples": result["samples"], "contrast": contrast} for name in ("mres-full", "mres"))
    converged = result["truth"]["converged"]
    full |= {"time_ms": result["reference_time_ms"], "error_to_converged": {"rms": converged["reference_rms"]}}
    mres |= {"time_ms": result["time_ms"], "error_to_converged": {"rms": converged["rms"]}, "gain": result["speedup"],
             "error_to_full": {name: result["error"][name] for name in ("rms", "block_p99", "block_max")}}
    return [full, mres]


def write_picture(folder, name, values):
    for ending, kind in ((".exr", OpenImageIO.HALF), (".png", OpenImageIO.UINT8)):
        image = OpenImageIO.ImageBuf(numpy.ascontiguousarray(values[:, :, None]))
        if not image.write(str(folder / (name + ending)), kind):
            sys.exit(f"peers: '{name + ending}' can't be written: {image.geterror()}; make room or choose another -o.")


def measure_peer(name, request, folder, pictures):
    """What peers.json says of it, and its results; leaves its pictures in `pictures`."""
    folder.mkdir()
    (folder / "request.json").write_text(json.dumps(request))
    run(name, [*PEERS[name], folder / "request.json", folder])
    peer = json.loads((folder / "result.json").read_text())
    size = request["width"], request["height"]
    converged = measures.read_values(folder / peer["converged"], *size)
    write_picture(pictures, f"{name}-converged", converged)
    results = []
    full = None
    for drawn in peer["results"]:
        values = measures.read_values(folder / drawn["picture"], *size)
        write_picture(pictures, drawn["name"], values)
        result = {"name": drawn["name"], "samples": drawn["samples"], **measures.times(drawn["frames_ms"]),
                  "error_to_converged": measures.error(values, converged), "contrast": float(converged.std())}
        if full is None:
            full = values, result
        else:
            result["gain"] = full[1]["time_ms"]["median"] / result["time_ms"]["median"]
            result["error_to_full"] = measures.error(values, full[0])
        results.append(result)
    return {key: peer[key] for key in ("renderer", "versions", "settings")}, results


def publish(pictures, output, report):
    """Pictures first, so that what the report is about is there."""
    for picture in pictures.iterdir():
        os.replace(picture, output / picture.name)
    text = pictures / "peers.json"
    text.write_text(json.dumps(report, indent=2) + "\n")
    os.replace(text, output / "peers.json")


def request_of(options, view, scene):
    """Of a view as mres reports it."""
    return {"scene": str(scene.resolve()), "width": view["width"], "height": view["height"], "radius": options.radius,
            "runs": options.runs, "warm_up": WARM_UP, "renderer": RENDERER, "chromium": shutil.which("chromium")}


def keep_pictures_of_mres(folder, pictures):
    for source, name in (("effect_full", "mres-full"), ("effect_mres", "mres")):
        for ending in (".exr", ".png"):
            os.replace(folder / (source + ending), pictures / (name + ending))


def measure(options, folder, pictures):
    """The report of all; leaves their pictures in `pictures`, and much else in `folder`."""
    mres = measure_mres(options, folder / "mres")
    view = mres["results"][0]
    scene = folder / "scene.glb"
    run("mres export", [MRES, "export", options.scene, "--camera", options.camera, "-o", scene])
    request = request_of(options, view, scene)
    report = {"schema": 1, "machine": mres["machine"], "radius": options.radius, "peers": {}, "results": []}
    report |= {name: view[name] for name in ("scene", "triangles", "camera", "width", "height")}
    for name in PEERS:
        report["peers"][name], results = measure_peer(name, request, folder / name, pictures)
        report["results"] += results
    report["peers"]["mres"] = {"renderer": mres["machine"]["renderer"], "settings": view["settings"],
                               "versions": {"mres": mres["version"], "commit": mres["commit"]}}
    report["results"] += results_of_mres(mres, folder / "mres")
    keep_pictures_of_mres(folder / "mres", pictures)
    return report


def text_of(report, output):
    return (f"{report['scene']}, camera {report['camera']}, {report['width']}x{report['height']}, radius "
            f"{report['radius']} m, {report['machine']['renderer']}, {report['machine']['cores']} cores\n\n"
            f"{table.text_of(report['results'])}\n\n"
            "Errors are those of the ambient occlusion to the peer's own converged picture, and to its own picture at "
            "full resolution; contrast is the standard deviation of the former, of mres the latter; blocks are 8x8 "
            f"pixels.\nPictures and peers.json are in {output}.")


def main():
    options = arguments()
    try:
        options.output.mkdir(parents=True, exist_ok=True)
        work = tempfile.TemporaryDirectory(prefix=".partial-", dir=options.output)
    except OSError as error:
        sys.exit(f"peers: can't write to '{options.output}': {error.strerror}; choose another place with -o.")
    with work:
        folder = pathlib.Path(work.name)
        pictures = folder / "pictures"
        pictures.mkdir()
        report = measure(options, folder, pictures)
        publish(pictures, options.output, report)
    print(text_of(report, options.output))


if __name__ == "__main__":
    try:
        main()
    except KeyboardInterrupt:
        sys.exit(130)  # as shells have it; the peers got the signal as well

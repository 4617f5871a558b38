#!/usr/bin/python3
"""VTK's vtkSSAOPass on a scene: its times and its pictures.

Usage: vtk_ssao.py REQUEST FOLDER     by tests/peers/peers.py, which says what is in either

Debian's VTK opens an X window even where it draws off the screen: without a display, run it under xvfb-run.
"""
import json
import pathlib
import re
import sys
import time

import numpy
import vtk
from vtk.util.numpy_support import vtk_to_numpy

SAMPLES = 64
BIAS = 0.02  # radii, as mres has it; VTK's default is the same for a radius of 0.5
# The converged picture has 256 samples, without the blur, under 16 parts of the pass's noise each: 4096 in all. The
# pass's samples are always the same ones, its noise rotates them and is fixed to the screen, so the view is moved over it.
CONVERGED_SAMPLES = 256
CONVERGED_SHIFTS = [(x, y) for x in range(0, 16, 4) for y in range(0, 16, 4)]  # pixels


def new_ssao(radius):
    ssao = vtk.vtkSSAOPass()
    ssao.SetDelegatePass(vtk.vtkRenderStepsPass())
    ssao.SetRadius(radius)
    ssao.SetBias(BIAS * radius)
    ssao.SetKernelSize(SAMPLES)
    ssao.SetBlur(True)
    return ssao


def prepare(actor):
    """White and unlit, so that a pixel is its ambient occlusion and little besides the pass takes time."""
    # mres draws translucent surfaces after its effects. The importer takes masked ones, whose holes it ignores, for such.
    actor.SetVisibility(not actor.GetForceTranslucent())
    surface = actor.GetProperty()
    surface.SetInterpolationToPhong()
    surface.SetColor(1, 1, 1)
    surface.SetAmbient(1)
    surface.SetDiffuse(0)
    surface.SetSpecular(0)


class View:
    """A window of its own for each way to draw: VTK builds the shaders of all actors anew when the pass changes."""

    def __init__(self, request, render_pass):
        self.window = vtk.vtkRenderWindow()
        self.window.SetOffScreenRendering(1)
        self.window.SetMultiSamples(0)
        self.window.SetSize(request["width"], request["height"])
        self.renderer = vtk.vtkRenderer()
        self.renderer.SetBackground(1, 1, 1)
        self.window.AddRenderer(self.renderer)
        importer = vtk.vtkGLTFImporter()
        importer.SetFileName(request["scene"])
        importer.SetRenderWindow(self.window)
        importer.SetCamera(0)
        importer.Update()
        for actor in self.renderer.GetActors():
            prepare(actor)
        self.renderer.SetPass(render_pass)

    def draw(self):
        """Milliseconds until all is drawn: WaitForCompletion() is glFinish."""
        start = time.perf_counter()
        self.window.Render()
        self.window.WaitForCompletion()
        return 1000 * (time.perf_counter() - start)

    def values(self):
        """Of the picture, 0 to 1, rows from top to bottom."""
        width, height = self.window.GetSize()
        pixels = vtk.vtkUnsignedCharArray()
        self.window.GetRGBACharPixelData(0, 0, width - 1, height - 1, 0, pixels)
        return vtk_to_numpy(pixels).reshape(height, width, 4)[::-1, :, 0].astype(numpy.float32) / 255

    def shifted_values(self, x, y):
        """With the view moved by whole pixels while it is drawn; what that leaves out is NaN."""
        width, height = self.window.GetSize()
        self.renderer.GetActiveCamera().SetWindowCenter(2 * x / width, 2 * y / height)
        self.draw()
        values = numpy.full((height, width), numpy.nan, numpy.float32)
        # To the right and up in the window's terms: the picture moves to the left and down.
        values[: height - y, x:] = self.values()[y:, : width - x]
        return values


def converged(view, ssao):
    ssao.SetKernelSize(CONVERGED_SAMPLES)
    ssao.SetBlur(False)
    mean = numpy.nanmean([view.shifted_values(*shift) for shift in CONVERGED_SHIFTS], axis=0)
    return mean.astype(numpy.float32)


def renderer_of(window):
    return re.search("renderer string: *(.*)", window.ReportCapabilities()).group(1)


def main(request_file, folder):
    request = json.loads(pathlib.Path(request_file).read_text())
    ssao = new_ssao(request["radius"])
    views = {"without": View(request, vtk.vtkRenderStepsPass()), "with": View(request, ssao)}
    for view in views.values():
        view.draw()
    renderer = renderer_of(views["with"].window)
    if request["renderer"] not in renderer:
        sys.exit(f"VTK draws with '{renderer}', not with {request['renderer']}; install libgl1-mesa-dri.")
    times = {name: [] for name in views}
    for run in range(request["warm_up"] + request["runs"]):
        for name, view in views.items():
            milliseconds = view.draw()
            if run >= request["warm_up"]:
                times[name].append(milliseconds)
    views["with"].values().tofile(folder / "vtk-ssao.f32")
    converged(views["with"], ssao).tofile(folder / "vtk-converged.f32")
    result = {
        "renderer": renderer, "versions": {"vtk": vtk.vtkVersion.GetVTKVersion()},
        "results": [{"name": "vtk-ssao", "samples": SAMPLES, "picture": "vtk-ssao.f32", "frames_ms": times}],
        "converged": "vtk-converged.f32",
        "settings": {"bias_radii": BIAS, "blur": True, "converged_samples": CONVERGED_SAMPLES * len(CONVERGED_SHIFTS)},
    }
    (folder / "result.json").write_text(json.dumps(result))


if __name__ == "__main__":
    main(sys.argv[1], pathlib.Path(sys.argv[2]))

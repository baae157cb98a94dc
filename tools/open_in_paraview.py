#!/usr/bin/env pvpython
"""Makes a view of a run for ParaView: its grains as spheres, coloured by their speed, and the walls of its deck.

Usage: pvpython tools/open_in_paraview.py DIR [--input DIR] [--png FILE] [--time SECONDS] [--hide WALL]...

Writes the walls to DIR/walls/ and the view to DIR/view.pvsm, and, if asked, a picture at a time (the last one by default). Then

    paraview --state=DIR/view.pvsm

opens it, with all snapshots in the time line. --input is where the STL files of the deck are, if it has any. Walls are
drawn where they start; those that a phase removes are in the list of ParaView's pipeline to be hidden, or by --hide.
"""
import argparse
import os
import sys

HERE = os.path.dirname(os.path.abspath(__file__))
sys.path[:0] = [os.path.join(HERE, "python"), os.path.join(HERE, "..", "python")]  # of the source, installed
sys.dont_write_bytecode = True

from paraview import simple  # noqa: E402
from repose.walls import vtp_of, wall_surfaces  # noqa: E402

GREY, SIZE = (0.62, 0.66, 0.72), (1200, 1000)
COLOURS = ((0.0, (0.82, 0.69, 0.47)), (0.5, (0.35, 0.56, 0.66)), (1.0, (0.04, 0.22, 0.55)))  # sand at rest to blue


def show_grains(folder, view):
    """The series of snapshots, each grain as a sphere of its radius."""
    reader = simple.OpenDataFile(os.path.join(folder, "run.hdf.series"))
    reader.UpdatePipeline()
    speed = simple.Calculator(Input=reader, Function="mag(velocity)", ResultArrayName="speed, m/s")
    simple.RenameSource("grains", speed)
    display = simple.Show(speed, view)
    display.SetRepresentationType("Point Gaussian")  # spheres without triangles: a full vessel would have 50 million
    display.ShaderPreset = "Sphere"
    display.GaussianRadius = 1.0
    display.ScaleByArray = 1
    display.SetScaleArray = ["POINTS", "radius"]
    display.UseScaleFunction = 0
    simple.ColorBy(display, ("POINTS", "speed, m/s"))
    display.SetScalarBarVisibility(view, True)
    return reader, display


def show_walls(folder, surfaces, hidden, view):
    """Each wall as a source of its own, translucent."""
    os.makedirs(os.path.join(folder, "walls"), exist_ok=True)
    for name, present, points, polygons in surfaces:
        path = os.path.join(folder, "walls", name + ".vtp")
        with open(path, "w") as file:
            file.write(vtp_of(points, polygons))
        source = simple.XMLPolyDataReader(registrationName="wall " + name, FileName=[path])
        if name in hidden or not present:
            continue
        display = simple.Show(source, view)
        display.ColorArrayName = [None, ""]
        display.DiffuseColor = GREY
        display.AmbientColor = GREY
        display.Opacity = 0.22


def set_scale(display, reader):
    """Colours from rest to the greatest speed of the snapshot shown."""
    transfer = simple.GetColorTransferFunction("speed, m/s")
    simple.UpdatePipeline(proxy=reader)
    display.RescaleTransferFunctionToDataRange(False, True)
    low, high = transfer.RGBPoints[0], transfer.RGBPoints[-4]
    transfer.RGBPoints = [value for share, colour in COLOURS for value in (share, *colour)]
    transfer.RescaleTransferFunction(0.0, high if high > low else 1.0)
    bar = simple.GetScalarBar(transfer, simple.GetActiveView())
    bar.Title, bar.ComponentTitle = "speed, m/s", ""
    bar.RangeLabelFormat = "%.2g"
    for part in ("TitleColor", "LabelColor"):
        setattr(bar, part, [0.0, 0.0, 0.0])


def look(view, time):
    """From the front and a little above, z upwards."""
    view.ViewTime = time
    view.CameraViewUp = [0.0, 0.0, 1.0]
    view.CameraFocalPoint = [0.0, 0.0, 0.0]
    view.CameraPosition = [0.35, -1.0, 0.3]
    simple.ResetCamera(view)
    simple.GetActiveCamera().Dolly(1.05)


def main():
    arguments = argparse.ArgumentParser(description="make a view of a run for ParaView")
    arguments.add_argument("run", metavar="DIR")
    arguments.add_argument("--input", metavar="DIR", help="where the STL files of the deck are")
    arguments.add_argument("--png", metavar="FILE", help="a picture")
    arguments.add_argument("--time", type=float, metavar="SECONDS", help="of the picture; the nearest snapshot is taken")
    arguments.add_argument("--hide", action="append", default=[], metavar="WALL", help="a wall that is not to be seen")
    chosen = arguments.parse_args()
    folder = os.path.abspath(chosen.run)
    try:
        surfaces = wall_surfaces(os.path.join(folder, "deck.resolved.toml"), chosen.input)
    except OSError as error:
        sys.exit(f"open_in_paraview.py: {error}")
    view = simple.GetActiveViewOrCreate("RenderView")
    view.ViewSize = SIZE
    view.UseColorPaletteForBackground = 0
    view.Background = [1.0, 1.0, 1.0]
    view.OrientationAxesLabelColor = [0.0, 0.0, 0.0]
    reader, display = show_grains(folder, view)
    show_walls(folder, surfaces, chosen.hide, view)
    times = list(reader.TimestepValues)
    time = min(times, key=lambda t: abs(t - chosen.time)) if chosen.time is not None else times[-1]
    simple.GetAnimationScene().UpdateAnimationUsingDataTimeSteps()
    simple.GetAnimationScene().AnimationTime = time
    look(view, time)
    set_scale(display, reader)
    state = os.path.join(folder, "view.pvsm")
    simple.SaveState(state)
    print(f"paraview --state={state}")
    if chosen.png:
        simple.SaveScreenshot(chosen.png, view, ImageResolution=SIZE)
        print(chosen.png)


if __name__ == "__main__":
    main()

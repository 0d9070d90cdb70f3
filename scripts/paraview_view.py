"""The standard view of a run in ParaView 5.11: translucent wall, leaflets coloured by strain, speed on the plane through
the axis, markers coloured by group, with the times of the run.

    pvpython scripts/paraview_view.py OUT -o view.png [--time S]     a picture (without a display: xvfb-run -a pvpython ...)
    VALSALVA_RUN=OUT paraview --script=scripts/paraview_view.py      interactive
"""
import argparse
import os
from pathlib import Path

from paraview import simple as pv

SPEED = [0.0, 1.0, 1.0, 1.0, 0.25, 0.99, 0.89, 0.65, 0.5, 0.95, 0.51, 0.31, 0.75, 0.71, 0.21, 0.48, 1.0, 0.29, 0.1, 0.47]
LAYER = 0.2  # cm: thickness of the layer of markers that is shown
MARKER_COLORS = [[0.78, 0.27, 0.24], [0.18, 0.43, 0.70], [0.95, 0.60, 0.25], [0.23, 0.56, 0.36]]


def open_series(out, name):
    """The reader of out/name, or None if the run has no such file."""
    path = Path(out, name)
    return pv.OpenDataFile(str(path)) if path.is_file() else None


def set_place(bar, corner):
    bar.WindowLocation, bar.ScalarBarLength = corner, 0.3
    bar.TitleColor = bar.LabelColor = [0.1, 0.1, 0.1]
    bar.RangeLabelFormat = "%g"


def show_wall(out, view):
    wall = open_series(out, "structure/wall.hdf")
    if wall is None:
        return
    display = pv.Show(wall, view)
    display.ColorArrayName = ["POINTS", ""]
    display.SetRepresentationType("Points")
    display.PointSize, display.Opacity = 2.0, 0.12
    display.AmbientColor = display.DiffuseColor = [0.55, 0.50, 0.48]


def color_by(display, array):
    """Colours a display by (association, name[, component]); returns the colour map of the array."""
    pv.ColorBy(display, array)
    return pv.GetColorTransferFunction(array[1])


def show_bar(display, view, colors, title, corner):
    display.SetScalarBarVisibility(view, True)
    bar = pv.GetScalarBar(colors, view)
    bar.Title, bar.ComponentTitle = title, ""
    set_place(bar, corner)


def show_leaflets(out, view):
    leaflets = open_series(out, "structure/leaflets.hdf.series")
    if leaflets is None:
        return
    display = pv.Show(leaflets, view)
    display.LineWidth = 2.0
    colors = color_by(display, ("CELLS", "strain"))
    colors.ApplyPreset("Viridis (matplotlib)", True)
    colors.RescaleTransferFunction(0.0, 0.15)
    show_bar(display, view, colors, "fibre strain", "Upper Right Corner")


def show_speed(out, view):
    fields = open_series(out, "fields/fields.hdf.series")
    if fields is None:
        return
    fields.UpdatePipeline()
    bounds = fields.GetDataInformation().GetBounds()
    middle = [0.5 * (bounds[2 * d] + bounds[2 * d + 1]) for d in range(3)]
    plane = pv.Slice(Input=fields, SliceType="Plane")
    plane.SliceType.Origin, plane.SliceType.Normal = middle, [0.0, 1.0, 0.0]
    display = pv.Show(plane, view)
    colors = color_by(display, ("CELLS", "velocity_cm_s", "Magnitude"))
    colors.ColorSpace, colors.RGBPoints = "RGB", SPEED
    display.Ambient, display.Diffuse = 1.0, 0.0
    colors.RescaleTransferFunction(0.0, 150.0)
    show_bar(display, view, colors, "speed (cm/s)", "Lower Right Corner")


def show_markers(out, view):
    markers = open_series(out, "structure/markers.hdf.series")
    if markers is None:
        return
    # only a layer in front of the plane through the axis; the plane hides the rest
    markers.UpdatePipeline()
    bounds = markers.GetDataInformation().GetBounds()
    axis = 0.5 * (bounds[2] + bounds[3])
    layer = markers
    for y, side in ((axis, 0), (axis + LAYER, 1)):
        layer = pv.Clip(Input=layer, ClipType="Plane", Invert=side)
        layer.ClipType.Origin, layer.ClipType.Normal = [0.0, y, 0.0], [0.0, 1.0, 0.0]
    display = pv.Show(layer, view)
    display.SetRepresentationType("Points")
    display.PointSize = 3.0
    colors = color_by(display, ("POINTS", "group"))
    colors.InterpretValuesAsCategories = 1
    colors.Annotations = [word for n in range(len(MARKER_COLORS)) for word in (str(n), f"group {n}")]
    colors.IndexedColors = sum(MARKER_COLORS, [])
    display.SetScalarBarVisibility(view, False)


def build(out, time=None):
    """The view of the run in `out` at `time` (s; None: the last), with all parts that the run has."""
    view = pv.GetActiveViewOrCreate("RenderView")
    view.ViewSize = [1400, 700]
    view.UseColorPaletteForBackground = 0
    view.Background = [1.0, 1.0, 1.0]
    view.OrientationAxesLabelColor = [0.1, 0.1, 0.1]
    for show in (show_wall, show_leaflets, show_speed, show_markers):
        show(out, view)
    scene = pv.GetAnimationScene()
    scene.UpdateAnimationUsingDataTimeSteps()
    times = list(pv.GetTimeKeeper().TimestepValues or [0.0])
    scene.AnimationTime = times[-1] if time is None else min(times, key=lambda t: abs(t - time))
    # the vessel from left to right, seen from the side and slightly from above
    view.CameraFocalPoint, view.CameraViewUp = [0.0, 0.0, 0.0], [1.0, 0.0, 0.0]
    view.CameraPosition = [0.25, 1.0, 0.0]
    view.CameraParallelProjection = 1
    pv.ResetCamera(view)
    view.CameraParallelScale *= 0.52  # the vessel fills the width; the box may be clipped
    pv.Render(view)
    return view


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("out", nargs="?", default=os.environ.get("VALSALVA_RUN"), help="output folder of a run")
    parser.add_argument("-o", "--picture", type=Path, help="write this picture and exit")
    parser.add_argument("--time", type=float, help="time in s; the nearest frame is used (default: the last)")
    arguments = parser.parse_args()
    if not arguments.out or not Path(arguments.out, "fields").is_dir():
        parser.error(f"{arguments.out}: not the output folder of a run; name one or set VALSALVA_RUN")
    view = build(arguments.out, arguments.time)
    if arguments.picture:
        pv.SaveScreenshot(str(arguments.picture), view)
        print(f"paraview_view: {arguments.picture}")


main()

"""The style of all pictures: type, colours, panel letters, saving."""
import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt  # noqa: E402
from matplotlib.colors import LinearSegmentedColormap  # noqa: E402

PAGE_WIDTH = 7.1     # inches: two columns of a journal
COLUMN_WIDTH = 3.5   # inches: one column, and the width of a phone
INK = "#222222"
GREY = "#8a8a8a"
VENTRICLE, AORTA, FLOW = "#c8443c", "#2f6db3", "#222222"
OTHERS = ["#3a8f5c", "#8e5aa8", "#c98a1b", "#4fb0c6", "#7a6a58"]
LEAFLETS = ["#12807a", "#c9701a", "#6f4a9e"]

SPEED = LinearSegmentedColormap.from_list("speed", ["#ffffff", "#fde3a7", "#f3834f", "#b5367a", "#4a1a78"])

PORT_NAMES = {"lv": "left ventricle", "ao": "aorta", "la": "left atrium", "in": "inlet", "out": "outlet"}
PORT_COLORS = {"lv": VENTRICLE, "ao": AORTA, "inlet": VENTRICLE, "outlet": AORTA, "in": VENTRICLE, "out": AORTA}


def apply():
    plt.rcParams.update({
        "font.family": "sans-serif",
        "font.sans-serif": ["Liberation Sans", "Nimbus Sans", "Arial", "DejaVu Sans"],
        "mathtext.fontset": "dejavusans",
        "font.size": 8.5, "axes.labelsize": 8.5, "axes.titlesize": 8.5,
        "xtick.labelsize": 8, "ytick.labelsize": 8, "legend.fontsize": 8,
        "text.color": INK, "axes.labelcolor": INK, "axes.edgecolor": INK,
        "xtick.color": INK, "ytick.color": INK,
        "axes.linewidth": 0.6, "xtick.major.width": 0.6, "ytick.major.width": 0.6,
        "axes.spines.top": False, "axes.spines.right": False,
        "lines.linewidth": 1.3, "lines.solid_capstyle": "round",
        "legend.frameon": False, "legend.handlelength": 1.6,
        "figure.dpi": 100, "savefig.dpi": 300, "savefig.facecolor": "white",
        "svg.fonttype": "path", "svg.hashsalt": "valsalva", "pdf.fonttype": 42,
    })


def port_label(port):
    return PORT_NAMES.get(port, port.replace("_", " "))


def port_color(port, others):
    """The fixed colour of a known port, else the next of the iterator `others`."""
    return PORT_COLORS.get(port) or next(others)


def letter(axes, text, x=0.0, y=1.02):
    axes.text(x, y, text, transform=axes.transAxes, fontweight="bold", fontsize=9.5, ha="left", va="bottom")


def save(figure, folder, name, *formats):
    """Writes name.png and further formats, each under a temporary name first, so that viewers see complete files."""
    for suffix in ("png",) + formats:
        part = folder / f".{name}.part.{suffix}"
        figure.savefig(part, metadata={"Date": None} if suffix == "svg" else None)  # the same run gives the same file
        part.replace(folder / f"{name}.{suffix}")
    plt.close(figure)

"""Figures of data/studies/README.md that different kernels of OpenBLAS give, a run of each study with each kernel."""

from pathlib import Path

from sentences import Fresh, Sentence
from studies import CYCLES, MASS, MM, OPTIMAL

ALL, TWO = ("Haswell", "SkylakeX", "Prescott", "Zen"), ("Haswell", "SkylakeX")
WITHOUT_AVX512 = ("Haswell", "Prescott", "Zen")
NEEDS = {"Haswell": "avx2", "Zen": "avx2", "SkylakeX": "avx512f", "Prescott": "pni"}  # of the processor, as Linux calls it
SPREAD = 1e-6  # what kernels may leave of a mass


def available(kernels):
    """Whether this processor can run all of them."""
    flags = Path("/proc/cpuinfo").read_text(encoding="utf-8").split()
    return all(NEEDS[kernel] in flags for kernel in kernels)


def spread(values):
    return (max(values) - min(values)) / min(values)


def ends(run, study, kernels):
    return [run("optimize", f"studies/{study}", words=("--no-verify",), kernel=kernel).summary for kernel in kernels]


def masses(run, study, kernels):
    """Mass and spread."""
    found = [s["mass_final"] for s in ends(run, study, kernels)]
    return [Fresh(found[0], relative=MASS), Fresh(spread(found), most=SPREAD)]


def row(run, study, kernels, digits):
    return Sentence(f"| {study} | {', '.join(kernels)} | {{:.{digits}f}} | {{:.1e}} |", lambda: masses(run, study, kernels))


def plate(run):
    def figures():
        mass, off = masses(run, "plate_with_hole", ALL)
        found = [s["objective"]["final"] for s in ends(run, "plate_with_hole", ALL)]
        return [Fresh(mass.value, relative=1e-6), Fresh(found[0], relative=1e-5), off, Fresh(spread(found), most=SPREAD)]

    return Sentence(f"| plate_with_hole | {', '.join(ALL)} | {{:.4f}}, the limit; f^T u {{:.3f}} J | {{:.1g}}; f^T u {{:.1e}} |", figures)


def holes(run):
    def figures():
        mass, off = masses(run, "cantilever_holes", ALL)
        found = [s["objective"]["final"] for s in ends(run, "cantilever_holes", ALL)]
        least, most = (Fresh(end(found), relative=MASS) for end in (min, max))
        return [mass, least, most, off, Fresh(spread(found), most=1e-3)]

    return Sentence(f"| cantilever_holes | {', '.join(ALL)} | {{:.5f}}, the limit; f^T u {{:.4e}} to {{:.4e}} J | {{:.1e}}; f^T u {{:.1e}} |", figures)


def cycles_of_holes(run):
    def figures():
        found = ends(run, "cantilever_holes", ALL)
        cycles, residuals = ([s[key] for s in found] for key in ("cycles", "kkt_residual"))
        return [*(Fresh(end(cycles), within=CYCLES) for end in (min, max)), *(Fresh(end(residuals), most=OPTIMAL) for end in (min, max))]

    return Sentence("cantilever_holes takes {} to {} cycles and ends with residuals of {:.2g} to {:.2g}, all below 0.01", figures)


def other_holes(run):
    """The cantilever with new holes, by another kernel than its table."""
    def figures():
        tried = run("optimize", "studies/cantilever", words=("--nucleate",), kernel="SkylakeX").summary["nucleation"]["tried"]
        kept = [t for t in tried if t["kept"]]
        return [Fresh(MM * kept[3]["place"][0], within=80), *(Fresh(kept[i]["objective"], relative=5e-2 if i == 3 else 5e-3) for i in (3, -1))]

    return Sentence("with the kernel SkylakeX the fourth hole lies at {:.0f} mm and leaves {:.5f} kg, and all six end at {:.5f} kg", figures)


def sentences(run):
    rows = [(ALL, row(run, "connecting_rod", ALL, 5)), (ALL, row(run, "cantilever", ALL, 5)), (ALL, plate(run)), (ALL, holes(run)),
            (ALL, cycles_of_holes(run)), (TWO, row(run, "four_bar_mixed", TWO, 6)), (WITHOUT_AVX512, row(run, "slider_crank_both", WITHOUT_AVX512, 6)),
            (TWO, other_holes(run))]
    return [sentence for kernels, sentence in rows if available(kernels)]


def long(run):
    """Of the studies that take minutes with each kernel."""
    return [row(run, study, TWO, 5) for study in ("connecting_rod_3d", "robot_arm_lattice")] if available(TWO) else []

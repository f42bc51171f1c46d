"""Decks of `liesl export --to calculix`, run by CalculiX."""

import re
import shutil
import subprocess
import sys

BLOCK = r"displacements \(vx,vy,vz\) for set {} and time\s+(\S+)\n\n((?:\s+\d+.*\n)+)"


def need_calculix():
    """Ends with 77 (skipped) without ccx (calculix-ccx)."""
    if not shutil.which("ccx"):
        print("skipped: apt-get install calculix-ccx")
        sys.exit(77)


def run_deck(program, scene, part, folder, options):
    """Writes the deck of a part into `folder` and runs it. False, with what CalculiX says, if it fails."""
    subprocess.run([program, "export", scene, "--to", "calculix", "--part", part, "-o", folder, "--quiet",
                    *options], check=True)
    run = subprocess.run(["ccx", part], cwd=folder, capture_output=True, text=True, timeout=500)
    if "*ERROR" in run.stdout:
        print(run.stdout[-2000:])
        return False
    return True


def displacements(folder, part, nodes="NODES"):
    """Time -> node -> displacement of a set of nodes, as CalculiX prints them."""
    out = {}
    for time, lines in re.findall(BLOCK.format(nodes), (folder / f"{part}.dat").read_text()):
        rows = [line.split() for line in lines.splitlines() if line.strip()]
        out[float(time)] = {int(r[0]): [float(x) for x in r[1:]] for r in rows}
    return out

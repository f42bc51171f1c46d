"""Inputs of the pages that report_test.py looks at."""

BATCH = """name = "four rods"
study = "{study}"
[grid]
speed = {{ key = "joints.motor.drive.rate", values = [120, 150] }}
limit = {{ key = "constraints.bending.limit", values = [0.9e-3, 1.1e-3] }}
"""
COMPARE = """name = "two formalisms"
scene = "{scene}"
repeats = 1
set = {{ "simulation.duration" = 0.01 }}
[quantity]
response = "bend"
norm = "rms"
[reference]
formalisms = ["r3so3", "se3"]
elements = 16
step = 5e-5
[grid]
formalism = ["se3", "r3so3"]
elements = [4, 8]
step = [4e-4, 2e-4]
"""

# Joints between the ends of bodies: a hanger on the middle of a span, an overhang, a cross, a weight on a third interface.
BRANCHES = """name = "branches"
gravity = [0, -9.81, 0]
[ground.points]
b = [1, 0, 0]
o = [0, 0.4, 0]
p = [0.5, 0.4, 0]
c = [1.4, 0, 0]
d = [1.4, 0.5, 0]
m = [0, -0.7, 0]
n = [0.4, -0.7, 0]
[materials]
steel = { E = 210e9, nu = 0.3, rho = 7850 }
[sections]
thin = { type = "rectangle", width = 0.01, height = 0.01 }
[bodies]
span = { beam = { from = [0, 0, 0], to = [1, 0, 0], section = "thin", material = "steel", elements = 8 } }
hanger = { beam = { from = [0.5, 0, 0], to = [0.5, -0.3, 0], section = "thin", material = "steel", elements = 2 } }
load = { rigid = { at = [0.5, -0.3, 0], mass = 3, inertia = [1e-3, 1e-3, 1e-3] } }
over = { beam = { from = [0, 0.4, 0], to = [1, 0.4, 0], section = "thin", material = "steel", elements = 8 } }
rising = { beam = { from = [1.4, 0, 0], to = [2, 0.5, 0], section = "thin", material = "steel", elements = 8 } }
falling = { beam = { from = [1.4, 0.5, 0], to = [2, 0, 0], section = "thin", material = "steel", elements = 8 } }
weight = { rigid = { at = [0.2, -0.7, 0], mass = 30, inertia = [1e-2, 1e-2, 1e-2] } }
[bodies.strip.solid]
mesh = { from = [-0.02, -0.01], to = [0.42, 0.01], cells = [44, 2] }
material = "steel"
thickness = 0.01
at = [0, -0.7, 0]
modes = 4
[bodies.strip.solid.interfaces]
left = { circle = { centre = [0, 0], radius = 0.011 } }
right = { circle = { centre = [0.4, 0], radius = 0.011 } }
middle = { circle = { centre = [0.2, 0], radius = 0.011 } }
[joints]
a = { revolute = ["ground", "span.start"], axis = [0, 0, 1] }
b = { revolute = ["ground.b", "span.end"], axis = [0, 0, 1] }
hook = { revolute = ["span.mid", "hanger.start"], axis = [0, 0, 1] }
shackle = { revolute = ["hanger.end", "load.origin"], axis = [0, 0, 1] }
o = { revolute = ["ground.o", "over.start"], axis = [0, 0, 1] }
p = { revolute = ["ground.p", "over.mid"], axis = [0, 0, 1] }
c = { revolute = ["ground.c", "rising.start"], axis = [0, 0, 1] }
d = { revolute = ["ground.d", "falling.start"], axis = [0, 0, 1] }
cross = { revolute = ["rising.mid", "falling.mid"], axis = [0, 0, 1] }
m = { revolute = ["ground.m", "strip.left"], axis = [0, 0, 1] }
n = { revolute = ["ground.n", "strip.right"], axis = [0, 0, 1] }
w = { revolute = ["strip.middle", "weight.origin"], axis = [0, 0, 1] }
[simulation]
duration = 0.04
step = 5e-4
rho_inf = 0.8
"""

# A bar and a plate, clamped on the left, that sink under their loads: on the bar hangs a rigid body.
CANTILEVER = """name = "cantilever"
gravity = [0, 0, 0]
[materials]
alu = { E = 70e9, nu = 0.33, rho = 2700 }
[sections]
bar = { type = "rectangle", width = 0.02, height = 0.01 }
[bodies]
bar = { beam = { from = [0, 0, 0], to = [1, 0, 0], section = "bar", material = "alu", elements = 8 } }
load = { rigid = { at = [1, 0, 0], mass = 1, inertia = [1e-3, 1e-3, 1e-3] } }
[joints]
wall = { fixed = ["ground", "bar.start"] }
tip = { fixed = ["bar.end", "load.origin"] }
[loads]
down = { at = "load.origin", force = [0, -1, 0] }
[simulation]
type = "static"
[responses]
sunk = { response = "displacement", at = "bar.end" }
stress = { response = "stress", of = "bar" }
"""
CANTILEVER_STUDY = """scene = "cantilever.toml"
[design]
w = { of = "bar", property = "width", bounds = [0.01, 0.05] }
h = { of = "bar", property = "height", bounds = [0.005, 0.05] }
[objective]
minimize = "mass"
of = ["bar"]
[constraints]
sunk = { use = "sunk", limit = 1e-3 }
stress = { use = "stress", limit = 20e6 }
"""

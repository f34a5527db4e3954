# The crane, on an elastic contact with the ground, and its load on a cord above a heap.
rows = 2
event(i) = i == 1 ? "+1500 kg, leaks" : i == 3 ? "−700 kg, leak closes" : ""
row(i) = i == 3
x = 8
eval wall(3.5, 3.7, 4.9) . spring(3.5, 4.5, x - 1, 4.5) . right(3.1, 4.4, "elastic contact")
eval ground(3.5, x - 0.5, 3.9) . ground(x + 0.5, 12.5, 3.9)
eval box(x - 1, 4.15, x + 1, 4.85, 0) . disc(x - 0.7, 4.05, 0.15, 0) . disc(x + 0.7, 4.05, 0.15, 0)
eval text(x + 1.2, 4.5, "crane, 8 t")
eval line(x, 4.15, x, 0.5, DASHED) . line(x, 4.15, x + 1.35, 1.6, OUTLINE) . disc(x + 1.45, 1.45, 0.36, 1)
eval text(x + 2, 1.5, "load") . text(x + 1, 2.9, "6 m")
eval line(x, 1.45, x + 1.07, 1.45, QUANTITY) . right(x - 0.15, 1.45, "x")
eval line(x + 1.45, 1.05, x + 1.45, 0.45, MASS) . text(x + 1.65, 0.65, "leak, 40 kg/s")
eval ground(3.5, 12.5, 0.3) . polygon("-0.8 0 -0.4 0.4 0.3 0.45 0.8 0", x, 0.3, 0, 1) . right(x - 1, 0.65, "heap")

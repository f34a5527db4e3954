# A chain slides over the edge of a table; its links are taken up from a heap at the edge.
rows = 1
event(i) = "2 m hang"
x = 8
eval polygon("0 0 -3.5 0 -3.5 -0.25 -0.3 -0.25 -0.3 -3.6 0 -3.6", x, 3.6, 0, 0) . ground(x - 4.5, x + 4, 0)
do for [k = 0:6] { eval disc(x - 1.55 + 0.22 * k, 3.71, 0.11, 1) }
do for [k = 0:4] { eval disc(x - 1.34 + 0.22 * k, 3.9, 0.11, 1) }
do for [k = 0:2] { eval disc(x - 1.12 + 0.22 * k, 4.09, 0.11, 1) }
eval disc(x + 0.02, 3.72, 0.11, 1)
do for [k = 0:11] { eval disc(x + 0.13, 3.52 - 0.21 * k, 0.11, 1) }
eval right(x - 1.9, 4.2, "heap, at rest") . line(x + 1.4, 3.6, x + 1.4, 1.1, DISTANCE) . text(x + 1.6, 2.4, "x")
eval line(x, 3.6, x + 1.7, 3.6, DASHED) . line(x + 0.3, 1.1, x + 1.7, 1.1, DASHED)
eval line(x + 0.6, 2.6, x + 0.6, 1.5, QUANTITY) . text(x + 0.8, 2.1, "v")

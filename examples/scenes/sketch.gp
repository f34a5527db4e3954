# What the sketches of the machines share: a canvas of 16 x 5 units, 30 pixels each, and functions that return commands,
# for eval. One meaning a mark: outlines are thick; what is grey is the mass that changes; a thick arrow is the quantity
# of the curve; a thin arrow is a force or a torque; a dotted arrow is mass that moves; a dashed line is a
# direction, a path or a distance.
set style line 1 lc rgb "black" lw 1.6
set style line 2 lc rgb "#333333" lw 0.9
set style line 3 lc rgb "#333333" lw 0.9 dt (6,4)
set style arrow 1 nohead ls 1
set style arrow 2 nohead ls 2
set style arrow 3 nohead ls 3
set style arrow 4 head filled size 0.42,20 lc rgb "#111111" lw 2.6
set style arrow 5 head size 0.26,22 ls 2
set style arrow 6 nohead lc rgb "black" lw 1.4 dt (2,3)
set style arrow 7 heads size 0.2,22 ls 3
set style arrow 8 head filled size 0.24,22 lc rgb "black" lw 1 # the head of a dotted arrow
OUTLINE = 1; THIN = 2; DASHED = 3; QUANTITY = 4; FORCE = 5; MASS = 6; DISTANCE = 7
fill_of(full) = sprintf('fc rgb "%s" fs solid 1 border lc rgb "black" lw 1.6', full ? "#c4c4c4" : "white")

plain(x1, y1, x2, y2, style) = sprintf("set arrow from %g,%g to %g,%g as %d front;", x1, y1, x2, y2, style)
part(a, b, u) = a + u * (b - a)
split(x1, y1, x2, y2, u, style) = plain(x1, y1, part(x1, x2, u), part(y1, y2, u), style) . \
    plain(part(x1, x2, u), part(y1, y2, u), x2, y2, style + 2)
line(x1, y1, x2, y2, style) = style == MASS ? \
    split(x1, y1, x2, y2, 1 - 0.24 / sqrt((x2 - x1)**2 + (y2 - y1)**2), style) : plain(x1, y1, x2, y2, style)
text(x, y, s) = sprintf("set label \"%s\" at %g,%g left front;", s, x, y)
middle(x, y, s) = sprintf("set label \"%s\" at %g,%g center front;", s, x, y)
right(x, y, s) = sprintf("set label \"%s\" at %g,%g right front;", s, x, y)
box(x1, y1, x2, y2, full) = sprintf("set object rectangle from %g,%g to %g,%g %s front;", x1, y1, x2, y2, fill_of(full))
disc(x, y, r, full) = sprintf("set object circle at %g,%g size %g %s front;", x, y, r, fill_of(full))
pin(x, y) = disc(x, y, 0.12, 0)
dot(x, y) = sprintf("set object circle at %g,%g size 0.09 fc rgb \"black\" fs solid 1 front;", x, y)

# A polygon from "x y x y ...", times scale, turned by the angle a about the point (x0, y0), where it has its origin
scale = 1
turned_x(x, y, a) = x * cos(a) - y * sin(a)
turned_y(x, y, a) = x * sin(a) + y * cos(a)
coordinate(s, i) = scale * real(word(s, i))
corners(s, i, x0, y0, a) = i > words(s) ? "" : sprintf("%s %g,%g", i > 1 ? " to" : "", \
    x0 + turned_x(coordinate(s, i), coordinate(s, i + 1), a), y0 + turned_y(coordinate(s, i), coordinate(s, i + 1), a)) \
    . corners(s, i + 2, x0, y0, a)
polygon(s, x0, y0, a, full) = "set object polygon from" . corners(s . " " . word(s, 1) . " " . word(s, 2), 1, x0, y0, a) . \
    " " . fill_of(full) . " front;"

# Arcs about (x, y) from the angle a to b in degrees; one with a head at b. Their grey is nearly black, as gnuplot 5.4
# leaves out an arc that is black.
curved(x, y, r, a, b, lw, dt) = sprintf("set object circle at %g,%g size %g arc [%g:%g] nowedge ", x, y, r, a < b ? a : b, \
    a < b ? b : a) . sprintf("fs empty border lc rgb \"%s\" lw %g %s front;", lw > 1 ? "#111111" : "#333333", lw, dt)
arc(x, y, r, a, b, style) = curved(x, y, r, a, b, style == OUTLINE ? 1.6 : 0.9, style == DASHED ? "dt (6,4)" : "")
DEG = pi / 180
ahead(r, a, b, size) = a < b ? b - size / r / DEG : b + size / r / DEG
short(r, a, b, size) = abs(b - a) * r * DEG <= size
tip(x, y, r, c, b, style) = line(x + r * cos(c * DEG), y + r * sin(c * DEG), x + r * cos(b * DEG), y + r * sin(b * DEG), style)
turn(x, y, r, a, b, style, size) = short(r, a, b, size) ? tip(x, y, r, a, b, style) : \
    curved(x, y, r, a, ahead(r, a, b, size), style == QUANTITY ? 2.6 : 0.9, "") . tip(x, y, r, ahead(r, a, b, size), b, style)
turning(x, y, r, a, b) = turn(x, y, r, a, b, QUANTITY, 0.45)
torque(x, y, r, a, b) = turn(x, y, r, a, b, FORCE, 0.24)

# The ground is hatched below, a wall on its left; a support carries a pin.
strokes(x, y, x2, down) = x > x2 ? "" : line(x, y, x - 0.22, y - down, THIN) . strokes(x + 0.3, y, x2, down)
ground(x1, x2, y) = line(x1, y, x2, y, OUTLINE) . strokes(x1 + 0.25, y, x2, 0.22)
wall_strokes(x, y, y2) = y > y2 ? "" : line(x, y, x - 0.22, y - 0.22, THIN) . wall_strokes(x, y + 0.3, y2)
wall(x, y1, y2) = line(x, y1, x, y2, OUTLINE) . wall_strokes(x, y1 + 0.25, y2)
support(x, y) = polygon("0 0 0.3 -0.45 -0.3 -0.45", x, y, 0, 0) . ground(x - 0.5, x + 0.5, y - 0.45) . pin(x, y)

coils = 8
# A spring from (x1, y1) to (x2, y2)
zigzag(x, y, dx, dy, i, n) = i == n ? "" : line(x + side(i) * -dy * 0.5, y + side(i) * dx * 0.5, \
    x + dx + side(i + 1) * -dy * 0.5, y + dy + side(i + 1) * dx * 0.5, OUTLINE) . zigzag(x + dx, y + dy, dx, dy, i + 1, n)
side(i) = i == 0 || i == coils ? 0 : i % 2 ? 1 : -1
spring(x1, y1, x2, y2) = zigzag(x1, y1, (x2 - x1) / coils, (y2 - y1) / coils, 0, coils)

# A line from (x, y) of the length r at the angle a in degrees
ray(x, y, r, a, style) = line(x, y, x + r * cos(a * DEG), y + r * sin(a * DEG), style)

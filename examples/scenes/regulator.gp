# Mercury in a tube on the axis and in outer tubes; a needle in it closes the contact of the motor.
rows = 2
event(i) = i == 0 ? "off" : "on"
row(i) = i
x = 8
do for [d in "-2.4 0 2.4"] {
    eval box(x + d - 0.3, 0.8, x + d + 0.3, 4, 0).box(x + d - 0.3, 0.8, x + d + 0.3, d eq "0" ? 2 : 3.1, 1)
}
eval box(x - 2.7, 0.6, x + 2.7, 1.1, 1) . line(x, 0.6, x, 0.1, OUTLINE)
eval line(x, 4.4, x, 1.95, OUTLINE) . text(x + 0.5, 3.4, "contact") . line(x + 0.1, 1.6, x + 2.4, 1.6, DISTANCE)
eval middle(x + 1.2, 2, "R")
eval turning(x, 4.8, 0.9, 215, 325) . text(x + 1, 4.5, "ω") . right(x - 2.9, 2, "mercury")
eval torque(x, 0.7, 0.7, 235, 305) . text(x + 0.6, 0.1, "T")

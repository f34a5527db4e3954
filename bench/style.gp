# What the plots of costs share: gnuplot -e "svg='OUT.svg'" bench/NAME.gp
set terminal svg size 720,600 font "Helvetica,18" background "white"
set output svg
set datafile separator ","
set datafile missing NaN
set grid lc rgb "#e4e4e4" lt 1
set border 3 lc rgb "#555555"
set tics nomirror textcolor rgb "#333333" scale 0.5
unset key
# colours that colour-blind readers tell apart (Okabe and Ito); peers grey
blue = "#0072b2"; sky = "#3a9bd9"; green = "#009e73"; purple = "#b3548a"; red = "#d55e00"; grey = "#777777"; black = "#222222"

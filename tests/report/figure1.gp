# Anderson's Figure 1 in kind: seen upwards, from close by.
set xrange [-2:2]; set yrange [-2:2]
set isosamples 30
set view from 2.4,3.2,-0.3 to 0,0,3
splot 3*exp(-x**2-y**2) + .4*sin(3*x)*cos(3*y)

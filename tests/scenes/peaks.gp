# A shaded drawing (Anderson 1982): the visible part of each facet, hatched by the light; no grid, but the outlines.
set title "Peaks, shaded"
set hidden3d outline
set hatch 45,0.6
set light -2,-3,3
set isosamples 90
set ticslevel 0
set view 60,32,1.25,1.35
splot [-3:3][-3:3] 3*(1-x)**2*exp(-x**2-(y+1)**2) - 10*(x/5-x**3-y**5)*exp(-x**2-y**2) - exp(-(x+1)**2-y**2)/3
